# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The section of a pyramid whose tip and edges are rounded by a ball: all points within the radius of the ball from the
sharp pyramid in which its centre moves (Indenter/Rounding radius). Needs NumPy."""

import numpy

N_DIRECTIONS = 200


def distance_to_pyramid(radius, angle, height, n_faces, face_angle):
    """From points to a sharp pyramid with its apex at the height 0, which opens upwards: 0 within it. radius and angle: polar
    coordinates, the angle from the middle of a face, at most pi / n_faces."""
    tangent, slope = numpy.tan(numpy.pi / n_faces), 1. / numpy.tan(face_angle)
    x, y = radius * numpy.cos(angle), radius * numpy.sin(angle)
    above_face = x * numpy.cos(face_angle) - height * numpy.sin(face_angle)
    foot_x = x - above_face * numpy.cos(face_angle)
    edge = numpy.array([1., tangent, slope]) / numpy.sqrt(1. + tangent ** 2 + slope ** 2)
    along = numpy.maximum(x * edge[0] + y * edge[1] + height * edge[2], 0.)
    to_edge = numpy.sqrt((x - along * edge[0]) ** 2 + (y - along * edge[1]) ** 2 + (height - along * edge[2]) ** 2)
    return numpy.where(above_face <= 0., 0., numpy.where(y <= tangent * foot_x, above_face, to_edge))


def section(height, n_faces, face_angle, rounding):
    """The area at a height above the lowest point. face_angle: between axis and faces, in degrees."""
    if not height > 0.:
        return 0.
    angles = (numpy.arange(N_DIRECTIONS) + 0.5) * numpy.pi / n_faces / N_DIRECTIONS
    face = numpy.radians(face_angle)
    inside = numpy.zeros(N_DIRECTIONS)
    outside = inside + (height + rounding) * numpy.tan(face) / numpy.cos(numpy.pi / n_faces) + 2. * rounding
    for _ in range(60):
        middle = 0.5 * (inside + outside)
        is_inside = distance_to_pyramid(middle, angles, height - rounding, n_faces, face) <= rounding
        inside, outside = numpy.where(is_inside, middle, inside), numpy.where(is_inside, outside, middle)
    return float(numpy.pi * (inside ** 2).mean())
