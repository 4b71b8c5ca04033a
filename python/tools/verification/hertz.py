# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Verification against Hertz' theory: pressure, contact zone, first yield; see verify."""

import math

from .runner import E_STAR, NU

AXISYMMETRIC = ("indentation/sphere_axisymmetric.prm", "Loading/History=", "Loading/Depth=0.004",
                "Geometry/Initial refinements=5", "Geometry/Local refinements=7", "Geometry/Local radius=4",
                "Refinement/Elements over contact radius=0", "Loading/Number of steps=1", "Indenter/Type=paraboloid",
                "Discretization/Volumetric treatment=standard")
# In a coarse mesh no node but that on the axis, which is no candidate, is within the depth.
FROM_COARSE_QUADRATIC = ("Geometry/Initial refinements=3", "Geometry/Local refinements=0",
                         "Discretization/Polynomial degree=2", "Refinement/Elements over contact radius=20")


def hertz(runner):
    """Hertz' paraboloid: force against contact radius and peak pressure (exact)."""
    row = runner.run("verification/hertz_sphere.prm")[-1]
    force, radius = 4 * row["force"], 10.0
    runner.compare("peak pressure", row["max_pressure"], sphere_peak(force, radius), 0.02)
    runner.compare("contact radius", math.sqrt(4 * row["contact_area"] / math.pi),
                   (3 * force * radius / (4 * E_STAR)) ** (1 / 3), 0.02)


def hertz_axisymmetric(runner):
    """Hertz' paraboloid as an axisymmetric body (exact)."""
    for name, settings in (("linear, on a fine mesh", ()),
                           ("quadratic, from a coarse mesh that follows the contact", FROM_COARSE_QUADRATIC)):
        print(f"  {name}", flush=True)
        row = runner.run(*AXISYMMETRIC, "Material/Law=linear elastic", *settings)[-1]
        force = row["force"]
        runner.compare("peak pressure", row["max_pressure"], sphere_peak(force, 1), 0.01)
        runner.compare("contact area", row["contact_area"],
                       math.pi * (3 * force / (4 * E_STAR)) ** (2 / 3), 0.01)


def hertz_cylinder(runner):
    """Hertz' line contact in plane strain (exact)."""
    row = runner.run("verification/hertz_cylinder.prm")[-1]
    runner.compare("peak pressure", row["max_pressure"], E_STAR * 0.2 / 20, 0.005)
    runner.compare("contact half-width", row["contact_area"], 0.2, 0.02)


def first_yield(runner):
    """A sphere, in space and as an axisymmetric body, and a cylinder: where the body yields first (exact)."""
    for name, stress, published in (("sphere", stress_under_sphere, 1.612797),
                                    ("cylinder", stress_under_cylinder, 1.79)):
        runner.compare(f"{name}, p0 / Y at first yield", 1 / largest(stress), published, 5e-3)
    for case, peak_under, stress in (
        (("verification/hertz_sphere.prm", "Refinement/Number of cycles=5"),
         lambda force: sphere_peak(4 * force, 10), stress_under_sphere),
        (AXISYMMETRIC, lambda force: sphere_peak(force, 1), stress_under_sphere),
        (("verification/hertz_cylinder.prm",),
         lambda force: cylinder_peak(2 * force, 10), stress_under_cylinder),
    ):
        peak = peak_under(runner.run(*case, "Material/Law=linear elastic")[-1]["force"])
        for load, yields in ((0.97, False), (1.03, True)):
            row = runner.run(*case, "Material/Law=perfectly plastic",
                             f"Material/Yield stress={peak * largest(stress) / load}")[-1]
            runner.verify(f"plastic volume at {load} of the load of first yield: "
                          f"{row['plastic_volume']:.2e}", (row["plastic_volume"] > 0) == yields)


def sphere_peak(force, radius):
    """The largest pressure under a paraboloid (Hertz)."""
    return (6 * force * E_STAR**2 / (math.pi**3 * radius**2)) ** (1 / 3)


def cylinder_peak(force, radius):
    """The largest pressure under a cylinder, force per unit length (Hertz)."""
    return math.sqrt(force * E_STAR / (math.pi * radius))


def largest(stress):
    """The largest value over the depth, from the surface to three contact radii."""
    return max(stress(i / 10000) for i in range(1, 30000))


def stress_under_sphere(z):
    """Von Mises stress on the axis over p0, z in contact radii (Johnson 1985, (3.45))."""
    vertical = -1 / (1 + z**2)
    horizontal = -(1 + NU) * (1 - z * math.atan(1 / z)) + 0.5 / (1 + z**2)
    return abs(vertical - horizontal)


def stress_under_cylinder(z):
    """Von Mises stress on the axis over p0, z in half-widths (Johnson 1985, (4.45))."""
    root = math.sqrt(1 + z**2)
    x, y = -((1 + 2 * z**2) / root - 2 * z), -1 / root
    along = NU * (x + y)
    return math.sqrt(0.5 * ((x - y) ** 2 + (y - along) ** 2 + (along - x) ** 2))
