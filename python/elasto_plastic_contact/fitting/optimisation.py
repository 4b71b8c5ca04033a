# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Least squares over a model (models.py): by a trust region within bounds, and by a few Gauss-Newton steps from where
the derivatives are known. (SciPy's own trust region scales its steps by the distance to the bounds: it takes twice as
many in the narrow valleys of hardening laws, or more.)"""

from dataclasses import dataclass

import numpy
from scipy.optimize import lsq_linear

from ..errors import UserError
from .runs import Failure, first_line

# An iteration ends when its next step would lower the sum of squares by less than this: a tenth of a standard error.
TOLERANCE = 0.01

# The step of derivatives by differences, in coordinates, where nothing asks for a larger one.
SMALLEST_STEP = 0.01

# The trust region in coordinates: at first, a factor of e to each side of a logarithmic one.
FIRST_RADIUS, SMALLEST_RADIUS = 1., 1e-4

MOST_ITERATIONS, MOST_STEPS = 30, 8


@dataclass(frozen=True)
class Minimum:
    """x: coordinates; residuals and their derivatives there (a column for each coordinate); converged: whether the next
    step would change nothing; remark: how it ended."""
    x: numpy.ndarray
    residuals: numpy.ndarray
    jacobian: numpy.ndarray
    converged: bool
    remark: str

    @property
    def chi_square(self):
        return float(self.residuals @ self.residuals)


def next_step(x, residuals, jacobian, lower, upper):
    """The Gauss-Newton step within the bounds, and by how much it would lower the sum of squares."""
    low, high = lower - x, upper - x
    scale = numpy.linalg.norm(jacobian, axis=0)
    scale = numpy.where(scale > 0., scale, 1.)
    # (lsq_linear wants room between the bounds)
    room = numpy.maximum(1e-12, 1e-9 * (upper - lower))
    found = lsq_linear(jacobian / scale, -residuals, bounds=((low - room) * scale, (high + room) * scale), tol=1e-12)
    step = (found.x / scale).clip(low, high)
    after = residuals + jacobian @ step
    return step, float(residuals @ residuals - after @ after)


def least_fall(model, residuals, n_free, tolerance):
    """The fall of the sum of squares that is not worth a step: a tolerance in units of the variance of the noise, which
    is that of the residuals, and not less than 1 if the noise is known."""
    variance = residuals @ residuals / max(len(residuals) - n_free, 1)
    return tolerance * max(variance, 1. if model.noise_is_known else 1e-10)


def start_of(model, x):
    """The residuals at a first point. Raises UserError if they cannot be computed."""
    found, = model.evaluate([x])
    if isinstance(found, Failure):
        raise UserError("the run at the start has failed, so that there is nothing to begin with: "
                        f"{first_line(found)}. Give another start")
    return found


def noise_of(model, x):
    """How far the residuals are from smooth functions of the coordinates, over their derivatives along the diagonal of
    these: from fourth differences, whose mean square is 70 times that of independent errors (more_wild_2011). What has
    no five points within the bounds, or fails, counts as smooth."""
    inward = numpy.where(model.upper - x > x - model.lower, 1., -1.)
    ladder = [x + k * SMALLEST_STEP * inward for k in range(5)]
    if any((point < model.lower).any() or (point > model.upper).any() for point in ladder):
        return 0.
    found = model.evaluate(ladder)
    if any(isinstance(values, Failure) for values in found):
        return 0.
    fourth = numpy.diff(found, 4, axis=0)[0]
    slope = numpy.sqrt(((found[4] - found[0]) ** 2).mean()) / (4. * SMALLEST_STEP)
    return float(numpy.sqrt((fourth ** 2).mean() / 70.) / slope) if slope > 0. else 0.


class Derivatives:
    """The Jacobian of a model by differences, all columns in one batch: central ones, where there is room at both
    sides. (Those at one side are wrong by half the step, which a narrow valley of the sum of squares does not
    forgive.)"""

    def __init__(self, model, step):
        self.model, self.step = model, step

    def sides(self, x):
        """For each coordinate the points beside x."""
        found = []
        for i in range(len(x)):
            up, down = min(self.step, self.model.upper[i] - x[i]), min(self.step, x[i] - self.model.lower[i])
            if min(up, down) > 0.5 * self.step:
                found.append((up, -down))
            else:
                found.append((up,) if up >= down else (-down,))
        return found

    def __call__(self, x, residuals):
        sides = self.sides(x)
        points = [(i, move) for i, moves in enumerate(sides) for move in moves]
        found = dict(zip(points, self.model.evaluate([moved(x, i, move) for i, move in points])))
        return numpy.column_stack([self.column(x, residuals, i, {move: found[i, move] for move in moves})
                                   for i, moves in enumerate(sides)])

    def column(self, x, residuals, i, found):
        good = {move: values for move, values in found.items() if not isinstance(values, Failure)}
        if not good:
            return self.other_side(x, residuals, i, next(iter(found)))
        ends = {0.: residuals} | good if len(good) == 1 else good
        (a, at_a), (b, at_b) = ends.items()
        return (at_b - at_a) / (b - a)

    def other_side(self, x, residuals, i, failed):
        """A run has failed: half of the step to the other side, and to the same one."""
        for move in (-0.5 * failed, 0.5 * failed):
            if self.model.lower[i] <= x[i] + move <= self.model.upper[i]:
                values, = self.model.evaluate([moved(x, i, move)])
                if not isinstance(values, Failure):
                    return (values - residuals) / move
        raise UserError("the runs beside a point of the fit fail on both sides, so that there are no derivatives: give "
                        "narrower bounds, a smaller 'step', or a case that converges more easily")


def moved(x, i, move):
    other = numpy.array(x, float)
    other[i] += move
    return other


def minimise(model, start, step, report=lambda text: None, in_words=str, tolerance=TOLERANCE):
    """The Minimum from a start, by Gauss-Newton steps with derivatives by differences of a step. Each is the best one
    of the linear least squares within the bounds and within a box around the point, the trust region, which grows and
    shrinks as the sum of squares falls as expected or not (Conn, Gould and Toint, 2000); a run that fails makes it
    shrink, too. After a step of less than a standard error, the derivatives are improved by that step alone, and taken
    anew where such ones lead nowhere."""
    x, derivatives, radius = numpy.array(start, float), Derivatives(model, step), FIRST_RADIUS
    residuals = start_of(model, x)
    report(f"  {in_words(x)}: sum of squares {residuals @ residuals:.6g}")
    jacobian, are_exact = derivatives(x, residuals), True
    for _ in range(MOST_ITERATIONS):
        _, fall = next_step(x, residuals, jacobian, model.lower, model.upper)
        if fall < least_fall(model, residuals, len(x), tolerance):
            return Minimum(x, residuals, jacobian, True, "")
        other, after, radius = trusted_step(model, x, residuals, jacobian, radius, report, in_words)
        if other is None and not are_exact:
            jacobian, are_exact, radius = derivatives(x, residuals), True, FIRST_RADIUS
            continue
        if other is None:
            return Minimum(x, residuals, jacobian, False,
                           "no step lowers the sum of squares any more, as the derivatives say: "
                           "the computed curves are not smooth enough")
        are_exact = fall >= least_fall(model, residuals, len(x), 1.)
        jacobian = derivatives(other, after) if are_exact else improved(jacobian, other - x, after - residuals)
        x, residuals = other, after
    return Minimum(x, residuals, jacobian, False, f"it has not converged in {MOST_ITERATIONS} iterations")


def improved(jacobian, step, change):
    """The derivatives that explain the change of the residuals in a step, next to those before (Broyden, 1965)."""
    return jacobian + numpy.outer(change - jacobian @ step, step) / (step @ step)


def trusted_step(model, x, residuals, jacobian, radius, report, in_words):
    """The next point, its residuals, and the radius of the trust region there; no point if none is found."""
    while radius > SMALLEST_RADIUS:
        lower, upper = numpy.maximum(model.lower, x - radius), numpy.minimum(model.upper, x + radius)
        step, expected = next_step(x, residuals, jacobian, lower, upper)
        after, = model.evaluate([x + step])
        size = numpy.abs(step).max()
        if isinstance(after, Failure):
            report(f"  {in_words(x + step)}: the run has failed; nearer points are tried: {first_line(after)}")
            radius = 0.25 * size
            continue
        report(f"  {in_words(x + step)}: sum of squares {after @ after:.6g}")
        ratio = (residuals @ residuals - after @ after) / max(expected, 1e-300)
        if ratio < 0.25:
            radius = 0.25 * size
        elif ratio > 0.75 and size > 0.9 * radius:
            radius *= 2.
        if ratio > 0.01:
            return x + step, after, radius
    return None, None, radius


def polish(model, x, jacobian, free, tolerance=TOLERANCE, residuals=None):
    """The Minimum over the coordinates 'free' from a point near it, by Gauss-Newton steps that take the derivatives
    from elsewhere and improve them with each run, or None if the run at x fails."""
    free = numpy.asarray(free, int)
    if residuals is None:
        residuals, = model.evaluate([x])
    if isinstance(residuals, Failure):
        return None
    lower, upper = model.lower[free], model.upper[free]
    factor = 1.
    for _ in range(MOST_STEPS):
        if not len(free):
            break
        step, fall = next_step(x[free], residuals, jacobian[:, free], lower, upper)
        if fall < least_fall(model, residuals, len(free), tolerance):
            return Minimum(x, residuals, jacobian, True, "")
        other = x.copy()
        other[free] += factor * step
        after, = model.evaluate([other])
        if isinstance(after, Failure):
            factor *= 0.5
            continue
        jacobian = improved(jacobian, other - x, after - residuals)
        if after @ after < residuals @ residuals:
            x, residuals, factor = other, after, 1.
        else:
            factor *= 0.5
    return Minimum(x, residuals, jacobian, not len(free),
                   "" if not len(free) else "Gauss-Newton steps have not converged")
