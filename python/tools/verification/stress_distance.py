# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far two stresses of the equilibrium method are from each other (equilibrium.pvd)."""

import math

# Corners of a triangle weigh so much at the points of a formula that is exact for quadratic functions.
WEIGHTS = ((2 / 3, 1 / 6, 1 / 6), (1 / 6, 2 / 3, 1 / 6), (1 / 6, 1 / 6, 2 / 3))


def stress_distance(field, reference, young, poisson):
    """The norm sqrt(int d : C^-1 d dx) of the difference d of two fields of one body.

    It is integrated over the triangles of the reference, which should be the finer ones.
    """
    stress_at = piecewise_linear(field)
    square = 0
    for corners, stresses in triangles(reference):
        (x0, y0), (x1, y1), (x2, y2) = corners
        area = abs((x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)) / 2
        for weights in WEIGHTS:
            other = stress_at(*combine(weights, corners))
            difference = [a - b for a, b in zip(combine(weights, stresses), other)]
            trace = difference[0] + difference[4] + difference[8]
            square += area / 3 * ((1 + poisson) * sum(value**2 for value in difference) - poisson * trace**2) / young
    return math.sqrt(square)


def triangles(field):
    """Corners and stresses at the corners of each triangle."""
    for cell in field["cells"]:
        yield [field["points"][point][:2] for point in cell], [field["stress"][point] for point in cell]


def combine(weights, values):
    return [sum(w * v for w, v in zip(weights, components)) for components in zip(*values)]


def piecewise_linear(field):
    """The stress as a function of x and y. A grid of boxes knows the triangles near a point."""
    x_min, y_min = (min(point[d] for point in field["points"]) for d in (0, 1))
    size = math.sqrt(2 * extent(field["points"], 0) * extent(field["points"], 1) / len(field["cells"]))
    boxes = {}
    for triangle in triangles(field):
        x, y = zip(*triangle[0])
        for i in range(int((min(x) - x_min) / size), int((max(x) - x_min) / size) + 1):
            for j in range(int((min(y) - y_min) / size), int((max(y) - y_min) / size) + 1):
                boxes.setdefault((i, j), []).append(triangle)

    def stress_at(x, y):
        near = boxes[int((x - x_min) / size), int((y - y_min) / size)]
        # points are stored with seven digits: take the triangle that has the point most clearly inside
        weights, stresses = max(((barycentric(corners, x, y), stresses) for corners, stresses in near),
                                key=lambda candidate: min(candidate[0]))
        return combine(weights, stresses)

    return stress_at


def extent(points, direction):
    return max(point[direction] for point in points) - min(point[direction] for point in points)


def barycentric(corners, x, y):
    (x0, y0), (x1, y1), (x2, y2) = corners
    determinant = (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)
    first = ((x - x0) * (y2 - y0) - (x2 - x0) * (y - y0)) / determinant
    second = ((x1 - x0) * (y - y0) - (x - x0) * (y1 - y0)) / determinant
    return 1 - first - second, first, second
