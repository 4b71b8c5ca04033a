# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Verification: a thick sphere under internal pressure; see verify.

Exact solution: Hill, The mathematical theory of plasticity (1950), chapter V.
"""

import math

INNER, OUTER, E, NU, Y = 100.0, 200.0, 210000.0, 0.3, 240.0


def thick_sphere_axisymmetric(runner):
    """A thick sphere under internal pressure, axisymmetric body, Q2 and B-bar (exact)."""
    for elements in (("Discretization/Polynomial degree=2",),
                     ("Discretization/Polynomial degree=1", "Discretization/Volumetric treatment=B-bar")):
        check(runner, 1 / 2, "verification/thick_sphere_axisymmetric.prm", *elements)


def thick_sphere(runner):
    """A thick sphere under internal pressure, an eighth of it, Q2 (exact)."""
    check(runner, 1 / 8, "verification/thick_sphere_3d.prm")


def check(runner, part, case, *entries):
    """Pressure 200, 0, 300: how far the outside moves, and how far the plastic zone reaches."""
    tables, fields = runner.tables_with_fields(case, "solution", *entries)
    steps = tables["history"]
    elastic = 3 * 200 * INNER**3 * OUTER * (1 - NU) / (2 * E * (OUTER**3 - INNER**3))
    exact = (expansion(200), expansion(200) - elastic, expansion(300))
    for pressure, published, value in zip((200, 0, 300), (0.0312122, 0.0026408, 0.0782325), exact):
        runner.compare(f"closed form at {pressure}", value, published, 2e-5)  # its digits
    for name, data, value, allowed in zip(("at 200", "unloaded", "at 300"), fields[1:], exact,
                                          (0.005, 0.01, 0.005)):
        runner.compare(f"displacement of the outside, {name}", outer_displacement(data), value, allowed)
    for step, pressure in ((steps[0], 200), (steps[2], 300)):
        volume = 4 / 3 * math.pi * part
        runner.compare(f"radius of the plastic zone at {pressure}",
                       (step["plastic_volume"] / volume + INNER**3) ** (1 / 3),
                       plastic_radius(pressure), 0.01)


def plastic_radius(pressure):
    """By bisection."""
    low, high = INNER, OUTER
    for _ in range(60):
        c = 0.5 * (low + high)
        carried = 2 * Y * math.log(c / INNER) + 2 * Y / 3 * (1 - c**3 / OUTER**3)
        low, high = (c, high) if carried < pressure else (low, c)
    return c


def expansion(pressure):
    """Radial displacement of the outside while the pressure grows."""
    return Y * plastic_radius(pressure) ** 3 * (1 - NU) / (E * OUTER**2)


def outer_displacement(fields):
    """Mean radial displacement of the nodes at the outer radius."""
    radial = [sum(x * u for x, u in zip(point, displacement)) / math.hypot(*point)
              for point, displacement in zip(fields["points"], fields["displacement"])
              if math.hypot(*point) > OUTER * (1 - 1e-5)]
    return sum(radial) / len(radial)
