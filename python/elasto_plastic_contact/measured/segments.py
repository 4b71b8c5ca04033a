# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The segments of a measured curve: loads, holds and unloads, found from its force over time."""

from dataclasses import dataclass

import numpy

# A hold lasts that many times as long as the load and the unload beside it need for the next change of the force of the
# same size. (Loads at a constant rate of the depth begin slowly, without a hold.)
LONGER = 4.

# How much the force may change during a hold, relative to the rise or fall beside it: to find it, and to find its ends.
BAND, FINE_BAND = 0.01, 0.001

# So many standard deviations of what is not smooth are no turning point of the force.
SCATTER = 6.

# So many points must there be to tell noise from the curvature of a smooth path.
ENOUGH_FOR_SCATTER = 50

# The fewest points of a hold.
FEWEST_POINTS = 5


@dataclass(frozen=True)
class Segment:
    """From the point 'begin' to the point 'end', the first one of the next segment. kind: load, hold or unload."""
    kind: str
    begin: int
    end: int


@dataclass(frozen=True)
class Cycle:
    """A load, the hold at its largest force (None: nothing is held), and what is unloaded then, with holds on the way."""
    load: Segment
    hold: Segment
    unload: Segment


def deviation_of_noise(values):
    """The standard deviation of what is not smooth."""
    return 1.4826 * float(numpy.median(numpy.abs(numpy.diff(values, 2)))) / 6. ** 0.5 if len(values) > 4 else 0.


def scatter_of(force):
    """How far it may turn back by its noise alone; 0 with few points, of which a curved path would look like noise."""
    return SCATTER * deviation_of_noise(force) if len(force) >= ENOUGH_FOR_SCATTER else 0.


def turning_points(force, tolerance):
    """The first point, those where the force turns by more than the tolerance, and the last one."""
    points, direction, extreme = [0], 0, 0
    for i, value in enumerate(force):
        if direction == 0:
            if abs(value - force[extreme]) > tolerance:
                direction, extreme = (1 if value > force[extreme] else -1), i
        elif (value - force[extreme]) * direction >= 0.:
            extreme = i
        elif (force[extreme] - value) * direction > tolerance:
            points.append(extreme)
            direction, extreme = -direction, i
    return [*points, len(force) - 1]


def extent(force, point, band, first, last):
    """The first and the last point around a point between which the force stays within the band."""
    inside = numpy.abs(force[first:last + 1] - force[point]) <= band
    outside = numpy.flatnonzero(~inside) + first
    before, after = outside[outside < point], outside[outside > point]
    return (int(before[-1]) + 1 if len(before) else first), (int(after[0]) - 1 if len(after) else last)


class Flank:
    """What lies between two turning points."""

    def __init__(self, time, force, begin, end, noise):
        self.time, self.force, self.begin, self.end = time, force, begin, end
        self.height = abs(force[end] - force[begin])
        self.band, self.fine_band = (max(share * self.height, 4. * noise) for share in (BAND, FINE_BAND))
        self.kind = "load" if force[end] > force[begin] else "unload"

    def holds_inside(self, begin, end):
        """Pairs of points between which the force stays, on the way."""
        force, time = self.force[begin:end + 1], self.time[begin:end + 1]
        if len(force) < 20 or self.height < 20. * self.band:
            return []
        spent = numpy.gradient(time)
        levels = numpy.arange(force.min() + 2. * self.band, force.max() - 2. * self.band, self.band)
        found = []
        durations = numpy.array([spent[numpy.abs(force - level) <= self.band].sum() for level in levels])
        for i in range(3, len(levels) - 3):
            is_longest = durations[i] == durations[i - 2:i + 3].max()
            if is_longest and durations[i] > LONGER * max(durations[i - 3], durations[i + 3]):
                rows = begin + numpy.flatnonzero(numpy.abs(force - levels[i]) <= self.band)
                if len(rows) >= FEWEST_POINTS and (not found or rows[0] > found[-1][1]):
                    found.append((int(rows[0]), int(rows[-1])))
        return found


def hold_at(point, before, after):
    """The hold around a turning point between two Flanks, as first and last point; the point itself without one."""
    flanks = [flank for flank in (before, after) if flank is not None]
    band = min(flank.band for flank in flanks)
    time, force = flanks[0].time, flanks[0].force
    limits = before.begin if before else point, after.end if after else point
    first, last = extent(force, point, band, *limits)
    wider_first, wider_last = extent(force, point, 2. * band, *limits)
    beside = time[first] - time[max(wider_first - 1, limits[0])] + time[min(wider_last + 1, limits[1])] - time[last]
    if last - first < FEWEST_POINTS or time[last] - time[first] <= LONGER * beside:
        return point, point
    held = force[first:last + 1]
    level = numpy.sort(held)[len(held) // 2]
    rows = numpy.flatnonzero(numpy.abs(held - level) <= min(flank.fine_band for flank in flanks))
    return first + int(rows[0]), first + int(rows[-1])


def find_segments(curve, noise=0.01):
    """The Segments of a curve, and its Cycles. noise: how much the force may turn back without a turning point, relative to
    the largest one; more where it scatters more."""
    force = curve.force
    time = numpy.arange(len(force), dtype=float) if curve.time is None else curve.time
    deviation = deviation_of_noise(force)
    points = turning_points(force, max(noise * force.max(), scatter_of(force)))
    flanks = [Flank(time, force, begin, end, deviation) for begin, end in zip(points, points[1:]) if end > begin]
    holds = [hold_at(flank.begin, before, flank) for before, flank in zip([None, *flanks], flanks)]
    holds.append(hold_at(flanks[-1].end, flanks[-1], None))
    segments, cycles, open_load = [], [], None
    for flank, at_begin, at_end in zip(flanks, holds, holds[1:]):
        if at_begin[1] > at_begin[0]:
            segments.append(Segment("hold", *at_begin))
        parts = split(flank, at_begin[1], max(at_end[0], at_begin[1]))
        segments += parts
        whole = Segment(flank.kind, at_begin[1], max(at_end[0], at_begin[1]))
        if flank.kind == "load":
            open_load = whole
        elif open_load is not None:
            hold = Segment("hold", *at_begin) if at_begin[1] > at_begin[0] else None
            cycles.append(Cycle(open_load, hold, whole))
            open_load = None
    if holds[-1][1] > holds[-1][0]:
        segments.append(Segment("hold", *holds[-1]))
    return [segment for segment in segments if segment.end > segment.begin], cycles


def split(flank, begin, end):
    """A flank with the holds on its way."""
    parts = []
    for first, last in flank.holds_inside(begin, end):
        parts += [Segment(flank.kind, begin, first), Segment("hold", first, last)]
        begin = last
    return [*parts, Segment(flank.kind, begin, end)]
