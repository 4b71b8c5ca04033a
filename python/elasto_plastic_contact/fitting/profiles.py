# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Regions by profile likelihood: how far one coordinate can go while all others do their best to keep the sum of
squares low. Each point is made of runs of the model, begun at the one before."""

import concurrent.futures
from dataclasses import dataclass

import numpy

from .optimisation import TOLERANCE, next_step, polish

# The end is found when the root of the rise of the sum of squares is as near to what is wanted, relatively.
NEAR = 0.03

MOST_POINTS = 9

# By how much the sum of squares of a better point is lower, relative to its rise at the end of a region.
BETTER = 0.1

# The largest step along the coordinate: a factor of 2 of a logarithmic one.
LARGEST_STEP = 0.7

# Coordinates are held here by polish() a little less strictly than at a minimum.
LOOSE = 5. * TOLERANCE

# How often their search is begun anew where it has not ended.
RESTARTS = 2

UNSETTLED = "the other parameters have not come to rest, so that it may lie farther away"


@dataclass(frozen=True)
class ProfileEnd:
    """x: where the region ends, or the last point that has been looked at. is_closed: whether it ends there; else
    'remark' says why not. points: pairs of coordinates and rise of the sum of squares, on the way."""
    x: numpy.ndarray
    is_closed: bool
    remark: str
    points: list


def profile_end(model, minimum, i, side, threshold, deviation):
    """The ProfileEnd of coordinate i to one side (1 or -1). deviation: its standard error, if sigma is that of
    the noise."""
    others = [j for j in range(len(minimum.x)) if j != i]
    bound = model.upper[i] if side > 0 else model.lower[i]
    room, wanted = abs(bound - minimum.x[i]), threshold ** 0.5
    way, root, points = [0.], [0.], []
    here, settled = minimum, True
    distance = min(deviation * wanted, LARGEST_STEP, room)
    if room <= 1e-9 * (model.upper[i] - model.lower[i]):
        return ProfileEnd(minimum.x, False, "it lies at its bound", [])
    for _ in range(MOST_POINTS):
        found = held(model, here, i, minimum.x[i] + side * distance, others)
        if found is None:
            return ProfileEnd(here.x, False, "runs fail beyond", points)
        rise = found.chi_square - minimum.chi_square
        points.append((found.x, rise))
        value = max(rise, 0.) ** 0.5
        settled = settled and found.converged
        if abs(value - wanted) <= NEAR * wanted:
            return ProfileEnd(found.x, True, "" if settled else UNSETTLED, points)
        if distance >= room and value < wanted:
            return ProfileEnd(found.x, False, "it reaches its bound", points)
        way.append(distance)
        root.append(value)
        if value < wanted:
            here = found
        distance = next_distance(way, root, wanted, room)
    if max(root) < wanted:
        return ProfileEnd(here.x, False, f"it is farther away than {MOST_POINTS} points reach", points)
    return ProfileEnd(here.x, True, "its end is less exact than usual" if settled else UNSETTLED, points)


def next_distance(way, root, wanted, room):
    """Where the root of the rise, nearly proportional to the distance, will be what is wanted: by secants, between the
    points that enclose it once there are some."""
    order = numpy.argsort(way)
    way, root = numpy.array(way)[order], numpy.array(root)[order]
    above = numpy.flatnonzero(root >= wanted)
    if len(above):
        k = above[0]
        share = (wanted - root[k - 1]) / max(root[k] - root[k - 1], 1e-300)
        return way[k - 1] + min(max(share, 0.1), 0.9) * (way[k] - way[k - 1])
    slope = (root[-1] - root[-2]) / (way[-1] - way[-2])
    ahead = (wanted - root[-1]) / slope if slope > 0. else numpy.inf
    return min(way[-1] + min(ahead, LARGEST_STEP, 2. * way[-1]), room)


def better_point(ends, threshold):
    """A point of the profiles that is clearly better than the minimum they begin at, None if there is none: there are
    several minima then, or the iteration has ended too early."""
    points = [point for pair in ends for end in pair for point in end.points]
    lowest = min(points, key=lambda point: point[1], default=(None, 0.))
    return lowest[0] if lowest[1] < -BETTER * threshold else None


def held(model, near, i, value, others):
    """The Minimum with coordinate i held at a value, from a point near it; None if the run there fails."""
    x = near.x.copy()
    x[i] = value
    if others:
        residuals = near.residuals + near.jacobian[:, i] * (value - near.x[i])
        step, _ = next_step(x[others], residuals, near.jacobian[:, others], model.lower[others], model.upper[others])
        x[others] += step
    found = polish(model, x, near.jacobian, others, LOOSE)
    for _ in range(RESTARTS):
        if found is None or found.converged:
            break
        found = polish(model, found.x, found.jacobian, others, LOOSE, found.residuals)
    return found


def profiles(model, minimum, threshold, deviations, report=lambda i, end: None):
    """For each coordinate its two ProfileEnds, lower and upper, all at the same time. report: is told of each end and
    the number of its coordinate."""
    ways = [(i, side) for i in range(len(minimum.x)) for side in (-1, 1)]

    def find(way):
        end = profile_end(model, minimum, *way, threshold, deviations[way[0]])
        report(way[0], end)
        return end

    with concurrent.futures.ThreadPoolExecutor(len(ways)) as pool:
        ends = list(pool.map(find, ways))
    return [tuple(ends[2 * i:2 * i + 2]) for i in range(len(minimum.x))]
