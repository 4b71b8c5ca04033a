# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is seen of a body: quadrilaterals in the plane of the picture."""

from dataclasses import dataclass

import numpy

from .joined import FACES, Joined

# Which way it is to the eye, and which way is up, for bodies cut at right angles to an axis.
OBLIQUELY = {"none": ((-0.55, -0.70, 0.46), (0., 0., 1.)),
             "x": ((-0.78, -0.42, 0.46), (0., 0., 1.)),
             "y": ((-0.42, -0.78, 0.46), (0., 0., 1.))}


@dataclass
class Skin:
    """Positions in the picture of the points, and the quadrilaterals (four points each) from the
    rearmost to the foremost one, with the share of the light that each one reflects."""
    positions: numpy.ndarray
    quads: numpy.ndarray
    light: numpy.ndarray


def axes_of_view(direction, up):
    away = numpy.array(direction) / numpy.linalg.norm(direction)
    right = numpy.cross(up, away)
    right /= numpy.linalg.norm(right)
    return right, numpy.cross(away, right), away


def look(points, quads, view):
    """The quadrilaterals that turn their front to the eye."""
    right, upwards, away = axes_of_view(*view)
    first, second = (points[quads[:, i + 2]] - points[quads[:, i]] for i in (0, 1))
    normals = numpy.cross(first, second)
    lengths = numpy.linalg.norm(normals, axis=1)
    normals /= numpy.where(lengths > 0., lengths, 1.)[:, None]
    seen = normals @ away > 1e-6
    quads, normals = quads[seen], normals[seen]
    order = numpy.argsort(points[quads].mean(axis=1) @ away, kind="stable")
    lamp = 0.5 * away - 0.3 * right + 0.8 * upwards
    light = 0.8 + 0.2 * (normals @ (lamp / numpy.linalg.norm(lamp))).clip(min=0.)
    return Skin(points @ numpy.column_stack([right, upwards]), quads[order], light[order])


def look_at_plane(points, quads):
    """Of flat data all is seen, whichever way the corners go round."""
    return Skin(points[:, :2], quads, numpy.ones(len(quads)))


def cut_away(points, cells, axis, centre):
    """The cells behind the plane through the centre, as they are; all of them for the axis 'none'."""
    if axis == "none":
        return cells
    d = "xyz".index(axis)
    return cells[points[cells][:, :, d].min(axis=1) > centre[d] - 1e-6 * numpy.ptp(points)]


def outer_faces(points, cells):
    """The faces that hexahedra do not share with others, outwards. Four faces of small cells that
    meet a larger one are shared as well."""
    used, compact = numpy.unique(cells, return_inverse=True)
    cells_here = compact.reshape(cells.shape)
    joined = Joined(points[used], cells_here)
    faces = numpy.concatenate([cells_here[:, corners] for corners in FACES[8]])
    nodes = numpy.sort(joined.nodes[faces], axis=1)
    divided = divided_faces(joined)
    _, found, counts = numpy.unique(numpy.concatenate([nodes, divided]), axis=0,
                                    return_inverse=True, return_counts=True)
    return used[faces[counts[found[:len(nodes)]] == 1]]


def divided_faces(joined):
    """The faces that have a hanging node in the middle, and their quarters."""
    edges, faces = joined.hanging
    keys = edges[:, 1:].min(axis=1) * joined.n_nodes + edges[:, 1:].max(axis=1)
    order = numpy.argsort(keys)
    centres, corners = faces[:, 0], faces[:, 1:]
    parts = [corners]
    middles = []
    for i in range(4):
        pair = corners[:, [i, (i + 1) % 4]]
        place = numpy.searchsorted(keys, pair.min(axis=1) * joined.n_nodes + pair.max(axis=1), sorter=order)
        middles.append(edges[order[place.clip(max=max(len(order) - 1, 0))], 0] if len(order) else centres)
    for i in range(4):
        parts.append(numpy.column_stack([corners[:, i], middles[i], centres, middles[i - 1]]))
    return numpy.sort(numpy.concatenate(parts), axis=1)
