# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hardness and modulus from the unloading of a curve of force over depth, by the method of
Oliver and Pharr (1992), as the program evaluates its own (doc/theory, Evaluating an
indentation test). For measured curves and for histories alike. The program has the method once more, since it
evaluates a run while it computes it and without Python; a test compares the two. Needs NumPy."""

import argparse
from dataclasses import dataclass

import numpy

from .arguments import number
from .errors import UserError
from .pyramids import area_factor
from .tables import read_table

# The shares of the largest force between which the law of the unloading is fitted.
LOWEST_SHARE, HIGHEST_SHARE = 0.50, 0.95
ROUNDING = 1e-9

# What is allowed of the constants of evaluate(): epsilon is 1 of a flat end, less of others.
CONSTANTS = {"beta": number(above=0), "epsilon": number(above=0, most=1), "noise": number(least=0, below=0.5)}


@dataclass(frozen=True)
class Tip:
    """area: the section of the tip as a function of the height above it; depth_factor: epsilon, of
    the shape of the tip."""
    area: callable
    depth_factor: float

    @staticmethod
    def cone(semi_apex_angle):
        """semi_apex_angle: between axis and flank, in degrees; 70.3 stands for Berkovich's pyramid."""
        slope = numpy.tan(numpy.radians(semi_apex_angle))
        return Tip(lambda height: numpy.pi * (slope * height) ** 2, 2. - 4. / numpy.pi)

    @staticmethod
    def sphere(radius):
        return Tip(lambda height: numpy.pi * height * (2. * radius - height), 0.75)

    @staticmethod
    def pyramid(n_faces, face_angle, truncation=0.):
        """A regular one. face_angle: between axis and faces, in degrees; truncation: the height that is cut off."""
        factor = area_factor(n_faces, face_angle)
        return Tip(lambda height: factor * (height + truncation) ** 2, 0.75)

    @staticmethod
    def polynomial(coefficients):
        """C0 h^2 + C1 h + C2 h^(1/2) + C3 h^(1/4) + ..., from the calibration of a tip."""
        exponents = [2.] + [0.5 ** n for n in range(len(coefficients) - 1)]
        return Tip(lambda height: sum(c * height ** p for c, p in zip(coefficients, exponents)), 0.75)


@dataclass(frozen=True)
class Unloading:
    """The columns of indentation.csv of the same names (doc/lookup/tables.md); the last four follow from
    the section of the tip."""
    max_depth: float
    max_force: float
    stiffness: float
    exponent: float
    final_depth: float
    contact_depth: float
    tip_area: float
    tip_hardness: float
    tip_reduced_modulus: float


def evaluate(depth, force, tip, *, beta=1., epsilon=None, noise=0., initial_gap=0., modelled_part=1., indenter_compliance=0.,
             jumps=None):
    """All Unloadings of a curve that have at least three points between 95 and 50 per cent of
    their largest force.

    depth, force: from the first point on, in any consistent units.
    beta: S = 2 beta E_r sqrt(A / pi); 1 as in theory, 1.034 to 1.05 in laboratories for Berkovich's tip.
    epsilon: h_c = h_max - epsilon F_max / S; None stands for that of the tip's shape.
    noise: relative to the largest depth and force. A rise by less does not end an unloading, a
    fall by less is none, and forces below are not evaluated.
    initial_gap: the depth at which the tip first touches.
    modelled_part: of the indenter, as in indentation.csv.
    indenter_compliance: (1 - nu_i^2) / E_i, which is added to 1 / E_r of a run; its indenter is rigid.
    jumps: of a history whose mesh changes, jumps_of_meshes().
    """
    epsilon = tip.depth_factor if epsilon is None else epsilon
    check_constants(beta=beta, epsilon=epsilon, noise=noise)
    points = points_of(depth, force)
    found = []
    for part in unloadings(points, noise, no_jumps(points) if jumps is None else jumps):
        part = part[part[:, 1].argmax():]
        deepest, largest = part[0]
        if min(LOWEST_SHARE * largest, largest - part[:, 1].min()) <= noise * points[:, 1].max():
            continue
        fit = fit_unloading(part)
        if fit is None:
            continue
        contact = contact_of(tip, deepest - initial_gap, largest, fit[0], beta=beta, epsilon=epsilon, modelled_part=modelled_part)
        modulus = contact[-1] / (1. + indenter_compliance * contact[-1])
        found.append(Unloading(*map(float, (deepest, largest, *fit, *contact[:-1], modulus))))
    return found


def fit_unloading(part, shares=(LOWEST_SHARE, HIGHEST_SHARE)):
    """Stiffness at the first point of an unloading, exponent and final depth of its law, fitted between these shares of its
    first force; None if that takes in fewer than three points. part: a row of depth and force for each point."""
    deepest, largest = part[0]
    share = part[:, 1] / largest
    fitted = (share >= shares[0] - ROUNDING) & (share <= shares[1] + ROUNDING)
    if fitted.sum() < 3:
        return None
    log_coefficient, exponent, final_depth = fit_power_law(*part[fitted].T)
    stiffness = exponent * numpy.exp(log_coefficient + (exponent - 1.) * numpy.log(deepest - final_depth))
    return stiffness, exponent, final_depth


def contact_of(tip, depth, force, stiffness, *, beta=1., epsilon=None, modelled_part=1.):
    """Contact depth, section of the tip there, hardness and reduced modulus; the last three are 0 without a section."""
    contact_depth = depth - (tip.depth_factor if epsilon is None else epsilon) * force / stiffness
    area = modelled_part * tip.area(contact_depth) if contact_depth > 0. else 0.
    if not area > 0.:
        return contact_depth, area, 0., 0.
    return contact_depth, area, force / area, numpy.sqrt(numpy.pi / (area * modelled_part)) * stiffness / (2. * beta)


def check_constants(**values):
    for name, value in values.items():
        try:
            CONSTANTS[name](value)
        except argparse.ArgumentTypeError as error:
            raise UserError(f"{name}: {error}") from None


def points_of(depth, force):
    """A row for each point of the curve."""
    try:
        points = numpy.column_stack([depth, force]).astype(float)
    except (TypeError, ValueError):
        points = numpy.empty(0)
    if points.ndim != 2 or points.shape[1] != 2 or not len(points) or not numpy.isfinite(points).all():
        raise UserError("depth and force must be finite numbers, as many of one as of the other")
    return points


def no_jumps(points):
    return numpy.zeros(len(points)), numpy.ones(len(points))


def jumps_of_meshes(results):
    """What all changes of the mesh before a step of a run have taken from the depth, and by which
    factor they have lowered the force."""
    shift, factor = no_jumps(results.history)
    for change in read_table(results.path("mesh_changes.csv")) if results.has("mesh_changes.csv") else []:
        later = results.history["step"] > change["step"]
        shift[later] += change["depth_before"] - change["depth"]
        if change["force_before"] > 0. and change["force"] > 0.:
            factor[later] *= change["force_before"] / change["force"]
    return shift, factor


def unloadings(points, noise, jumps):
    """Depths and forces from the last point before both fall to the last one before either rises by
    more than noise; on the way, as if the mesh had not changed since the first of them."""
    tolerance = noise * points.max(axis=0)
    shift, factor = jumps
    part, lowest = [points[0]], points[0]
    for i in range(1, len(points)):
        begin = i - len(part)
        point = points[i] * [1., factor[i] / factor[begin]] + [shift[i] - shift[begin], 0.]
        if (point < lowest + tolerance).all():
            part.append(point)
            lowest = numpy.minimum(lowest, point)
        else:
            yield numpy.array(part)
            part, lowest = [points[i]], points[i]
    yield numpy.array(part)


def fit_power_law(depth, force):
    """Logarithm of the coefficient, exponent and final depth of force = coefficient (depth -
    final depth)^exponent: linear regression of the logarithms for each of many final depths, up to a thousand times the
    range of the depths below the smallest, closer and closer to the best."""
    smallest, size = depth.min(), numpy.ptp(depth)
    logarithm = numpy.log(force)

    def regressions(log_distances):
        final = smallest - size * numpy.exp(log_distances)
        x = numpy.log(depth - final[:, None])
        x_mean = x.mean(axis=1, keepdims=True)
        exponent = ((x - x_mean) @ (logarithm - logarithm.mean())) / ((x - x_mean) ** 2).sum(axis=1)
        constant = logarithm.mean() - exponent * x_mean[:, 0]
        residual = constant[:, None] + exponent[:, None] * x - logarithm
        return (residual ** 2).sum(axis=1), constant, exponent, final

    low, high = numpy.log(1e-3), numpy.log(1e3)
    while high - low > 1e-8:
        distances = numpy.linspace(low, high, 41)
        squares, constant, exponent, final = regressions(distances)
        best = int(squares.argmin())
        low, high = distances[max(best - 1, 0)], distances[min(best + 1, 40)]
    return constant[best], exponent[best], final[best]
