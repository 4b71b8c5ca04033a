# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The outline of the indenter in the plane y = 0."""

import math

import numpy

from ..oliver_pharr import Tip


def profile(results):
    """Horizontal distances from the tip and the heights above it; None for shapes that are not
    known here (expressions, images and STL surfaces)."""
    shape = results.parameters.get("Indenter/Type")
    if shape in ("sphere", "cylinder"):
        radius = results.number("Indenter/Radius")
        angle = numpy.linspace(-0.5 * math.pi, 0.5 * math.pi, 2001)
        return radius * numpy.sin(angle), radius * (1. - numpy.cos(angle))
    if shape == "paraboloid":
        radius = results.number("Indenter/Radius")
        distance = numpy.linspace(-radius, radius, 2001)
        return distance, distance ** 2 / (2. * radius)
    if shape in ("cone", "wedge"):
        slope = 1. / math.tan(math.radians(results.number("Indenter/Semi-apex angle")))
        reach = 1e3 * size_of_body(results)
        return numpy.array([-reach, 0., reach]), numpy.array([reach * slope, 0., reach * slope])
    if shape == "spheroconical tip":
        radius, angle = results.number("Indenter/Radius"), math.radians(results.number("Indenter/Semi-apex angle"))
        cap = numpy.linspace(0., 0.5 * math.pi - angle, 1001)
        flank = 1e3 * radius
        return mirrored(numpy.append(radius * numpy.sin(cap), radius * math.cos(angle) + flank * math.sin(angle)),
                        numpy.append(radius * (1. - numpy.cos(cap)),
                                     radius * (1. - math.sin(angle)) + flank * math.cos(angle)))
    if shape == "area function":
        height = size_of_body(results) * numpy.linspace(0., 1., 1001) ** 4
        area = Tip.polynomial(results.numbers("Indenter/Area coefficients")).area(height)
        return mirrored(numpy.sqrt(area / math.pi), height)
    if shape in ("circular punch", "strip punch", "rectangular punch"):
        half_width = results.number("Indenter/Radius" if shape == "circular punch" else "Indenter/Half width")
        return half_width * numpy.array([-1., -1., 1., 1.]), half_width * numpy.array([1e3, 0., 0., 1e3])
    return None


def mirrored(distance, height):
    """Both sides of an outline from that for distances >= 0."""
    return numpy.append(-distance[::-1], distance), numpy.append(height[::-1], height)


def size_of_body(results):
    return (results.numbers("Geometry/Upper corner") or [1.])[0]


def depth_at(results, time):
    """The depth at a time of the history, which begins at 0; that of its last step if it has no such
    time, as the meshes of a single step."""
    history = results.history
    if time == 0. and len(history) > 1:
        return 0.
    found = numpy.flatnonzero(numpy.isclose(history["time"], time))
    return history["depth"][found[-1] if len(found) and len(history) > 1 else -1]


def outline(results, top, time, scale):
    """Coordinates of the indenter above a surface at the height 'top', all vertical distances from it
    magnified like the displacement, so that the outline fits the drawn imprint; or None."""
    found = profile(results)
    if found is None or not results.has("history.csv"):
        return None
    distance, height = found
    centre = (results.numbers("Indenter/Position") or [0.])[0]
    gap = (results.numbers("Indenter/Initial gap") or [0.])[0]
    return centre + distance, top + scale * (gap - depth_at(results, time) + height)
