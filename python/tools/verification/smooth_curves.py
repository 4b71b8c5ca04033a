# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Smooth curves through what a load history gives, and how far it is from them."""

import math


class SmoothCurve:
    """The sum of some powers of x that is next to given values in the mean square."""

    def __init__(self, places, values, powers):
        self.powers, self.scale = powers, max(places)
        columns = [[(x / self.scale) ** power for x in places] for power in powers]
        self.coefficients = least_squares(columns, values)

    def __call__(self, place):
        return sum(c * (place / self.scale) ** power for c, power in zip(self.coefficients, self.powers))


def least_squares(columns, values):
    """The factors of the columns whose sum is next to the values: orthogonal columns first, then backwards."""
    rest, basis, factors = list(values), [], []
    for column in columns:
        parts = []
        for other in basis:
            part = inner(column, other)
            column = [a - part * b for a, b in zip(column, other)]
            parts.append(part)
        length = math.sqrt(inner(column, column))
        basis.append([a / length for a in column])
        factors.append((parts, length, inner(rest, basis[-1])))
        rest = [a - factors[-1][2] * b for a, b in zip(rest, basis[-1])]
    coefficients = [0.0] * len(columns)
    for i in reversed(range(len(columns))):
        known = sum(factors[j][0][i] * coefficients[j] for j in range(i + 1, len(columns)))
        coefficients[i] = (factors[i][2] - known) / factors[i][1]
    return coefficients


def inner(a, b):
    """The sum of the products."""
    return sum(x * y for x, y in zip(a, b))


def waves(places, values, powers):
    """The largest deviation from the smooth curve through the values, over the largest of them."""
    curve = SmoothCurve(places, values, powers)
    return max(abs(value - curve(place)) for place, value in zip(places, values)) / max(map(abs, values))


def initial_slope(depths, forces):
    """Of an unloading, whose first point is where it begins: of the parabola through its points."""
    way = [depths[0] - depth for depth in depths[1:]]
    fall = [forces[0] - force for force in forces[1:]]
    return SmoothCurve(way, fall, (1, 2)).coefficients[0] / max(way)


def at_place(places, values, place):
    """From linear interpolation between places that grow; constant outside."""
    if place <= places[0]:
        return values[0]
    for (a, u), (b, v) in zip(zip(places, values), zip(places[1:], values[1:])):
        if place <= b:
            return u + (v - u) * (place - a) / (b - a)
    return values[-1]
