# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is subtracted from a measured curve on request: thermal drift, compliance of the frame, depth at the first
contact. Each gives the corrected curve and a sentence on what was subtracted, and from what it is known."""

from dataclasses import replace

import numpy

from ..errors import UserError
from ..zero_point import FEWEST_POINTS, by_smaller_parts, continued_loading, is_far

# Drift is measured in holds below this share of the largest force, in their second half.
LOW_FORCE = 0.35


def drift_in_hold(curve, segments):
    """The change of depth in time in the last hold at a low force after the first load. Raises UserError."""
    peak = int(curve.force.argmax())
    holds = [segment for segment in segments if segment.kind == "hold" and segment.begin > peak
             and abs(curve.force[segment.begin]) < LOW_FORCE * curve.force[peak]]
    if not holds:
        raise UserError(f"the indent '{curve.name}' has no hold below {100. * LOW_FORCE:g} % of its largest force "
                        "after the unloading, in which its drift would be seen: give the rate by --drift '0.05 nm/s', "
                        "or leave it out")
    hold = holds[-1]
    half = slice((hold.begin + hold.end) // 2, hold.end + 1)
    rate = float(numpy.polyfit(curve.time[half], curve.depth[half], 1)[0])
    return rate, (f"the second half of the hold at {curve.force[half].mean():.3g} mN, {curve.time[half][0]:.4g} to "
                  f"{curve.time[half][-1]:.4g} s")


def without_drift(curve, chosen, segments):
    """chosen: a rate, 'hold' or 'instrument'. Raises UserError."""
    if curve.time is None:
        raise UserError(f"the indent '{curve.name}' has no time, and its drift is a rate: choose the column by "
                        "--columns time=3, or leave out --drift")
    if chosen == "hold":
        rate, source = drift_in_hold(curve, segments)
    elif chosen == "instrument":
        rate, source = known(curve.notes.drift_rate, "drift rate", "--drift '0.05 nm/s'", curve), "the file"
    else:
        rate, source = chosen, "--drift"
    drift = rate * (curve.time - curve.time[0])
    return replace(curve, depth=curve.depth - drift), (
        f"drift: {1e3 * rate:.4g} nm/s, by {source}: {1e3 * drift[curve.force.argmax()]:.3g} nm at the largest force")


def without_frame(curve, chosen):
    """chosen: a compliance, or 'instrument'. Raises UserError."""
    compliance, source = chosen, "--frame-compliance"
    if chosen == "instrument":
        compliance = known(curve.notes.frame_compliance, "frame compliance", "--frame-compliance '0.3 nm/mN'", curve)
        source = "the file"
    depth, force = changes_of_unloading(curve)
    if not compliance * force < depth:
        raise UserError(f"the frame compliance of the indent '{curve.name}', {1e3 * compliance:.4g} nm/mN by {source}, is "
                        f"too large: the frame would take {1e3 * compliance * force:.5g} nm of a depth that changes by "
                        f"{1e3 * depth:.4g} nm. Give a smaller one by --frame-compliance '0.3 nm/mN'")
    stiffness = curve.stiffness
    if stiffness is not None:
        stiffness = stiffness / (1. - compliance * stiffness)
    return replace(curve, depth=curve.depth - compliance * curve.force, stiffness=stiffness), (
        f"frame: {1e3 * compliance:.4g} nm/mN, by {source}: {1e3 * compliance * curve.force.max():.4g} nm at the "
        "largest force")


def changes_of_unloading(curve):
    """Of depth and force, from the largest force to the smallest one behind it; of the whole curve if it does not unload
    by half."""
    peak = int(curve.force.argmax())
    low = peak + int(curve.force[peak:].argmin())
    if curve.force[low] < 0.5 * curve.force[peak]:
        return curve.depth[peak] - curve.depth[low], curve.force[peak] - curve.force[low]
    return numpy.ptp(curve.depth), numpy.ptp(curve.force)


def known(value, what, example, curve):
    if value is None:
        raise UserError(f"the file of the indent '{curve.name}' does not say the {what} of the instrument: give it by "
                        f"{example}")
    return value


def from_zero_point(curve, chosen, noise):
    """chosen: a depth, 'fit', or None: depths stay, and the sentence says how far the loading begins from there, which
    must not be far. Raises UserError."""
    found = continued_loading(curve.depth, curve.force, noise)
    if chosen is None:
        return curve, remark_on_zero_point(curve, found)
    if chosen == "fit" and found is None:
        raise UserError(f"the indent '{curve.name}' has too few points of a loading to fit its zero point, "
                        f"{FEWEST_POINTS} are needed: give the depth at the first contact by --zero-point '5 nm'")
    zero, source = chosen, "--zero-point"
    if chosen == "fit":
        zero, source = found, "where the loading, continued, has no force" + "".join(
            f"; by its first {100. * share:g} % of the largest force, {1e3 * part:.4g} nm"
            for share, part in by_smaller_parts(curve.depth, curve.force, noise).items())
    if not curve.depth.max() > zero:
        raise UserError(f"the indent '{curve.name}' has no depth beyond its zero point, {1e3 * zero:.4g} nm: its "
                        f"largest one is {1e3 * curve.depth.max():.4g} nm. Give another --zero-point")
    return replace(curve, depth=curve.depth - zero), f"zero point: {1e3 * zero:.4g} nm, {source}"


def remark_on_zero_point(curve, found):
    if found is None:
        return "zero point: as in the file"
    deepest = curve.depth.max()
    if is_far(found, curve.depth):
        raise UserError(f"the depth of the indent '{curve.name}' is not counted from the first contact: its loading, "
                        f"continued down to the force zero, begins at {1e3 * found:.4g} nm, and the largest depth is "
                        f"{1e3 * deepest:.4g} nm. Take that as the zero point by --zero-point fit, or say where the tip "
                        "first touches by --zero-point '5 nm' ('0 nm' to keep the depths as they are); in the problem of a "
                        "fit by \"zero point\"")
    return (f"zero point: 0, as in the file; the loading, continued, begins at {1e3 * found:.4g} nm, "
            f"{100. * abs(found) / max(deepest - found, 1e-300):.2g} % of the depth")
