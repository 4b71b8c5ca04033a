# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a hold of the force says: how far and how fast the depth grows, and the rate sensitivity of the hardness."""

import numpy

# Of a hold, this part is left out at its beginning, in which stresses of the loading relax (as the program does).
FIRST_PART = 0.1

# The fewest points of a hold, and of the part of it that is fitted.
FEWEST_POINTS = 5

# Depths between which the rate is integrated, their distance beyond the measured ones over the range of these, and how
# many iterations the fit and the contact depth take at most.
N_DEPTHS, BEYOND, MOST_ITERATIONS = 400, 0.5, 100

# Linear viscosity has the rate sensitivity 1, a steady drift of the depth up to 2 and more: what is above this is one.
LARGEST = 1.5

# A fit ends when it changes no parameter by more, relatively.
TOLERANCE = 1e-9


def creep(curve, hold):
    """How much the depth grows in the hold in nm, and how fast in its second half in nm/s; empty without a hold or a
    time."""
    if not can_creep(curve, hold):
        return {}
    half = slice((hold.begin + hold.end) // 2, hold.end + 1)
    return {"creep_depth": 1e3 * (curve.depth[hold.end] - curve.depth[hold.begin]),
            "creep_rate": 1e3 * numpy.polyfit(curve.time[half], curve.depth[half], 1)[0]}


def can_creep(curve, hold):
    return hold is not None and curve.time is not None and hold.end - hold.begin >= FEWEST_POINTS - 1


def sensitivity_of_hold(curve, hold, constants, reduced_modulus=None):
    """m = d ln H / d ln r of the hardness H and the rate r = (dh/dt) / h of the depth h, as the program's
    hold_rate_sensitivity, and a sentence; m is None where the hold does not say it. constants: with a tip.
    reduced_modulus: for the contact depth, by the method of Oliver and Pharr, in GPa; None: that is the depth."""
    if not can_creep(curve, hold):
        return None, ""
    time, depth = curve.time[hold.begin:hold.end + 1], curve.depth[hold.begin:hold.end + 1]
    rows = time > time[0] + FIRST_PART * (time[-1] - time[0])
    if rows.sum() < FEWEST_POINTS or not depth[rows].min() > 0.:
        return None, ""
    force = float(curve.force[hold.begin:hold.end + 1].mean())
    found = rate_sensitivity(time[rows], depth[rows],
                             lambda depths: numpy.log(hardness(depths, force, constants, reduced_modulus)))
    if found is None:
        return None, ("the depth in its hold does not grow slower and slower so that a rate sensitivity would stand "
                      "out from noise and drift")
    return found, ("" if reduced_modulus is not None else
                   "its rate sensitivity is that of the section of the tip at the depth itself, as no unloading gives "
                   "the contact depth")


def hardness(depths, force, constants, reduced_modulus):
    """Of the force over the section of the tip at the contact depths, h - epsilon F / S with the stiffness S = 2 beta
    E_r sqrt(A / pi) of a section A that grows; not a number where the tip has none."""
    tip = constants.tip
    epsilon = tip.depth_factor if constants.epsilon is None else constants.epsilon
    contact_depths = depths
    areas = sections(tip, depths)
    for _ in range(MOST_ITERATIONS if reduced_modulus else 0):
        sink_in = epsilon * force * numpy.sqrt(numpy.pi / areas) / (2. * constants.beta * reduced_modulus)
        before, contact_depths = contact_depths, depths - sink_in
        areas = sections(tip, contact_depths)
        if not (numpy.abs(contact_depths - before) > TOLERANCE * depths).any():
            break
    return force / areas


def sections(tip, heights):
    areas = numpy.array([tip.area(height) if height > 0. else numpy.nan for height in heights], float)
    return numpy.where(areas > 0., areas, numpy.nan)


def rate_sensitivity(time, depth, log_hardness):
    """m such that depths whose rate is r = r_1 (H / H_1)^(1 / m) fit the measured ones best by least squares: there, ln
    H over ln r is a line of the slope m. None if they do not determine m. log_hardness: a function of depths.

    (A line through measured rates would have too small a slope, because of their noise.)"""
    margin = BEYOND * numpy.ptp(depth)
    depths = numpy.linspace(max(depth.min() - margin, 0.1 * depth.min()), depth.max() + margin, N_DEPTHS)
    middle, rate, slope = first_guess(time, depth)
    if not (margin > 0. and rate > 0.):
        return None
    with numpy.errstate(all="ignore"):  # (what is not finite is None)
        logs = log_hardness(depths) - log_hardness(numpy.array([middle]))
        if not numpy.isfinite(logs).all():
            return None
        fall = numpy.interp(middle + margin, depths, logs) / margin * rate  # of ln H in time
        start = numpy.array([min(max(slope / fall, 1.), 1e4), numpy.log(rate / middle), time.mean()])

        def at_measured_times(parameters):
            exponent, log_rate, time_of_middle = parameters
            spent = integral(numpy.exp(-exponent * logs - log_rate) / depths, depths)
            return numpy.interp(time, time_of_middle + spent - numpy.interp(middle, depths, spent), depths)

        found = least_squares(at_measured_times, depth, start)
    return None if found is None or 1. / found > LARGEST else 1. / found


def first_guess(time, depth):
    """The depth in the middle of a parabola through the points, its rate, and the derivative of ln (rate / depth)."""
    curvature, rate, middle = numpy.polyfit(time - time.mean(), depth, 2)
    return middle, rate, 2. * curvature / rate - rate / middle if rate != 0. else 0.


def integral(values, places):
    """From the first place to each."""
    return numpy.append(0., numpy.cumsum(0.5 * (values[1:] + values[:-1]) * numpy.diff(places)))


def least_squares(model, measured, start):
    """The first parameter of the fit, by Levenberg's and Marquardt's method; None if it is not above two of its
    standard errors."""
    parameters, damping = start, 1e-3
    residuals = model(parameters) - measured
    sizes = numpy.array([abs(start[0]), 1., numpy.ptp(measured) and 1.])
    for _ in range(MOST_ITERATIONS):
        steps = 1e-5 * sizes
        jacobian = numpy.column_stack([(model(parameters + step) - model(parameters - step)) / (2. * step.max())
                                       for step in numpy.diag(steps)])
        normal = jacobian.T @ jacobian
        change = numpy.linalg.lstsq(normal + damping * numpy.diag(numpy.diag(normal)), -jacobian.T @ residuals,
                                    rcond=None)[0]
        tried = model(parameters + change) - measured
        if tried @ tried <= residuals @ residuals:
            parameters, residuals, damping = parameters + change, tried, 0.1 * damping
            if (numpy.abs(change) <= TOLERANCE * sizes).all():
                break
        else:
            damping *= 10.
    variance = residuals @ residuals / max(len(measured) - 3, 1) * numpy.linalg.pinv(normal)[0, 0]
    return parameters[0] if parameters[0] > 2. * variance ** 0.5 else None
