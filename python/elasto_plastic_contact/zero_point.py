# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The zero point of a measured curve of force over depth: the depth at which the tip first touches
(ISO 14577-1). Instruments count the depth from there; a curve that does not is found out by its
loading, continued down to the force zero. Needs NumPy."""

import numpy

from .errors import UserError

# The shares of the largest force between which the loading is fitted, and how many points that takes.
LOWEST_SHARE, HIGHEST_SHARE, FEWEST_POINTS = 0.01, 0.50, 5

# Smaller parts of the loading, by their largest share of the force. Where no power law holds, as under a ball from the
# elastic to the plastic, these begin elsewhere.
SMALLER_PARTS = (0.20, 0.10)

# The exponents of the loading: 1 of a flat end, 1.5 of an elastic sphere, 2 of a cone or pyramid.
EXPONENTS = numpy.linspace(1., 2., 21)

# How far the depth zero may lie from the continued loading, relative to the depth from there on.
TOLERANCE = 0.1


def loading(depth, force, noise, highest):
    """The points at which the force is larger than ever before, between the lowest share of its largest value and the
    highest one."""
    before = numpy.maximum.accumulate(numpy.append(-numpy.inf, force))[:-1]
    share = force / force.max()
    rows = (force > before) & (share >= max(LOWEST_SHARE, noise)) & (share <= highest)
    return depth[rows], force[rows]


def continued_loading(depth, force, noise, highest=HIGHEST_SHARE):
    """Where depth = zero point + factor force^(1 / exponent), with the exponent that fits best, has no force;
    None if there are too few points of a loading."""
    depth, force = loading(depth, force, noise, highest)
    if len(depth) < FEWEST_POINTS:
        return None
    fits = []
    for exponent in EXPONENTS:
        terms = numpy.column_stack([numpy.ones(len(force)), (force / force.max()) ** (1. / exponent)])
        coefficients = numpy.linalg.lstsq(terms, depth, rcond=None)[0]
        fits.append((((terms @ coefficients - depth) ** 2).sum(), coefficients[0]))
    return float(min(fits)[1])


def by_smaller_parts(depth, force, noise):
    """Where smaller parts of the loading begin, by their shares, as far as they have the points."""
    found = {share: continued_loading(depth, force, noise, share) for share in SMALLER_PARTS}
    return {share: zero for share, zero in found.items() if zero is not None}


def is_far(found, depth):
    """Whether the continued loading begins too far from the depth zero for that to be the first contact."""
    return found is not None and found < depth.max() and abs(found) > TOLERANCE * (depth.max() - found)


def find_zero_point(depth, force, chosen, noise):
    """chosen: the depth of the zero point, 'fit' for that of the continued loading, or None: the depth zero, which
    must not be far from that."""
    if chosen is not None and chosen != "fit":
        return chosen
    found = continued_loading(depth, force, noise)
    if chosen == "fit":
        if found is None:
            raise UserError(f"the measured curve has too few points to fit its zero point: that takes {FEWEST_POINTS} of a "
                            f"loading between {100. * LOWEST_SHARE:g} and {100. * HIGHEST_SHARE:g} % of its largest force, "
                            "beyond the noise. Give the depth at the first contact by --zero-point DEPTH")
        return found
    if is_far(found, depth):
        raise UserError(f"the depth of the measured curve is not counted from the first contact: its loading, continued "
                        f"down to the force zero, begins at the depth {found:.4g}, and the largest one is {depth.max():.4g}. "
                        "Take that as the zero point by --zero-point fit, or say where the tip first touches by --zero-point "
                        "DEPTH (0 to keep the depths as they are)")
    return 0.
