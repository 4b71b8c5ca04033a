# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""How large a contact will be, before it is computed: enough to choose a mesh.

The mean pressure is that of elasticity (Hertz for a sphere, Sneddon for a cone) or 2.8 times the stress at the
representative
strain, 0.2 times the slope of the tip at the edge (Tabor 1951), whichever is less. The surface sinks in by
epsilon F / S with S = 2 E* a (Oliver and Pharr 1992), which is exact in elasticity. Pile-up is not known beforehand: it
makes contacts of soft metals up to a quarter larger (doc/lookup/new_cases.md compares)."""

import math
from dataclasses import dataclass

from ..errors import UserError

STICK = "stick"  # in place of a coefficient of friction: what touches does not slide
CONSTRAINT = 2.8  # mean pressure over the representative stress (Tabor)
STRAIN_OF_SLOPE = 0.2  # representative strain over the slope at the edge (Tabor)


@dataclass(frozen=True)
class Tip:
    """A body of revolution: a sphere (slope: None), a cone (radius: None) or a cone with a spherical cap that is
    tangent to it. radius in µm; slope: that of the cone, the cotangent of its semi-apex angle."""
    radius: float | None = None
    slope: float | None = None

    @property
    def end_of_cap(self):
        """The distance from the axis at which the sphere ends."""
        if self.radius is None:
            return 0.
        return self.radius if self.slope is None else self.radius * self.slope / math.hypot(1., self.slope)

    def height(self, distance):
        """Above its lowest point, at a distance from the axis."""
        on_cap = min(distance, self.end_of_cap)
        cap = 0. if self.radius is None else self.radius - math.sqrt(self.radius ** 2 - on_cap ** 2)
        return cap + (self.slope * (distance - on_cap) if distance > on_cap else 0.)

    def slope_at(self, distance):
        if distance >= self.end_of_cap and self.slope is not None:
            return self.slope
        return distance / math.sqrt(self.radius ** 2 - distance ** 2)

    def is_sphere_at(self, distance):
        return distance < self.end_of_cap

    @property
    def widest(self):
        """The largest contact radius that makes sense: a sphere ends."""
        return 0.9 * self.radius if self.slope is None else math.inf


def cone(angle):
    """By its semi-apex angle in degrees."""
    return Tip(None, 1. / math.tan(math.radians(angle)))


def mean_pressure(tip, material, radius):
    """Of a contact of this radius, in GPa."""
    factor = 4. / (3. * math.pi) if tip.is_sphere_at(radius) else 0.5
    slope = tip.slope_at(radius)
    elastic = factor * material.plane_strain_modulus * slope
    return elastic if material.is_elastic else min(elastic, CONSTRAINT * material.stress(STRAIN_OF_SLOPE * slope))


def force_at(tip, material, radius):
    """In mN."""
    return math.pi * radius ** 2 * mean_pressure(tip, material, radius)


def depth_at(tip, material, radius):
    """How deep the tip is when the contact has this radius, in µm."""
    epsilon = 0.75 if tip.is_sphere_at(radius) else 2. - 4. / math.pi
    sink_in = epsilon * math.pi * radius * mean_pressure(tip, material, radius) / (2. * material.plane_strain_modulus)
    return tip.height(radius) + sink_in


def radius_where(value, target, widest, goal):
    """Where a value that grows with the radius reaches the target, by bisection. goal: what the target is, in words.
    Raises UserError."""
    upper = 1.
    while value(min(upper, widest)) < target:
        if upper >= widest:
            raise UserError(f"{goal} is too large for this ball: the contact would reach its equator. Take less, a "
                            "larger ball or a harder material")
        upper *= 2.
    lower, upper = 0., min(upper, widest)
    for _ in range(100):
        middle = 0.5 * (lower + upper)
        lower, upper = (middle, upper) if value(middle) < target else (lower, middle)
    return upper


def expected_radius(tip, materials, *, depth=None, force=None, goal=None):
    """The contact radius in µm at a depth in µm or a force in mN; of several materials (film and substrate), the
    largest. goal: what says depth or force, for messages; unless told, the option. Raises UserError."""
    if depth is not None:
        return max(radius_where(lambda a, m=m: depth_at(tip, m, a), depth, tip.widest, goal or "--depth")
                   for m in materials)
    return max(radius_where(lambda a, m=m: force_at(tip, m, a), force, tip.widest, goal or "--force")
               for m in materials)
