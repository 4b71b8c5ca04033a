# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours and lines on quadrilaterals."""

import numpy
from matplotlib.collections import LineCollection, TriMesh
from matplotlib.colors import LinearSegmentedColormap
from matplotlib.tri import Triangulation

DARK, PLASTIC, INDENTER = "#1f2933", "#ee2b38", "#d9dce1"

# From no pressure to the highest: white, yellow, red, black.
PRESSURE = LinearSegmentedColormap.from_list("pressure", [
    (0., (1., 1., 1.)), (0.15, (1., 0.93, 0.62)), (0.4, (0.99, 0.68, 0.32)),
    (0.65, (0.88, 0.32, 0.19)), (0.85, (0.60, 0.10, 0.24)), (1., (0.24, 0.03, 0.22))])


def with_centres(quads, values, n_points):
    """The values with those in the middle of each quadrilateral behind them, and the four triangles
    around each middle."""
    centres = n_points + numpy.arange(len(quads))
    triangles = [numpy.column_stack([quads[:, i], quads[:, (i + 1) % 4], centres]) for i in range(4)]
    return numpy.concatenate([values, values[quads].mean(axis=1)]), numpy.stack(triangles, axis=1).reshape(-1, 3)


def draw_field(axes, skin, values, colours):
    """Colour by the values at the points. As pixels also in files of lines, where it would be large."""
    n = 4 * len(skin.quads)
    own_points = numpy.arange(n).reshape(-1, 4)
    positions, triangles = with_centres(own_points, skin.positions[skin.quads].reshape(n, 2), n)
    values, _ = with_centres(own_points, values[skin.quads].reshape(n), n)
    colour = colours.to_rgba(values)
    colour[:, :3] *= numpy.concatenate([numpy.repeat(skin.light, 4), skin.light])[:, None]
    mesh = TriMesh(Triangulation(*positions.T, triangles), rasterized=True)
    mesh.set_facecolor(colour)
    axes.add_collection(mesh)


def draw_mesh(axes, skin, nodes, scale):
    """The sides of the quadrilaterals, thinner where they are shorter so that they do not hide the
    field. scale: points of the printer (1/72 inch) to a unit of length."""
    quads = nodes[skin.quads]
    pairs = numpy.concatenate([numpy.stack([quads[:, i], quads[:, (i + 1) % 4]], axis=1) for i in range(4)])
    ends = numpy.concatenate([numpy.stack([skin.quads[:, i], skin.quads[:, (i + 1) % 4]], axis=1) for i in range(4)])
    _, first = numpy.unique(numpy.sort(pairs, axis=1), axis=0, return_index=True)
    lines = skin.positions[ends[first]]
    lengths = scale * numpy.linalg.norm(lines[:, 1] - lines[:, 0], axis=1)
    axes.add_collection(LineCollection(lines, colors=DARK, alpha=0.55, linewidths=(0.03 * lengths).clip(0.02, 0.35)))


def draw_contour(axes, skin, nodes, values, level):
    """The line where the continuous values reach the level. Returns whether it is in the window."""
    if not values.min() <= level < values.max():
        return False
    n_nodes = nodes.max() + 1
    places, at_nodes = numpy.zeros((n_nodes, 2)), numpy.zeros(n_nodes)
    places[nodes], at_nodes[nodes] = skin.positions, values
    quads = nodes[skin.quads]
    positions, triangles = with_centres(quads, places, n_nodes)
    at_points, _ = with_centres(quads, at_nodes, n_nodes)
    lines = axes.tricontour(Triangulation(*positions.T, triangles), at_points, levels=[level], colors=PLASTIC,
                            linewidths=1.8)
    lower, upper = numpy.transpose([axes.get_xlim(), axes.get_ylim()])
    return any(((lower <= line) & (line <= upper)).all(axis=1).any() for line in lines.allsegs[0])
