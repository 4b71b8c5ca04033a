# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Verification where the last digit of a displacement is a large force; see verify."""

from .runner import E


def contrast(runner):
    """A confined block of two layers, of which one is 1e8 times as stiff (exact)."""
    nu, depth, stiff, soft = 0.3, 0.0037, E, 1e-8 * E
    row = runner.run("verification/confined_block.prm", "Material/Law=linear elastic, linear elastic",
                     f"Material/Young's modulus={stiff}, {soft}", "Geometry/Material id=if(z > 0.5, 0, 1)",
                     "Geometry/Initial refinements=3", f"Loading/Depth={depth}")[-1]
    confined = (1 - nu) / ((1 + nu) * (1 - 2 * nu))
    exact = depth * confined / (0.5 / stiff + 0.5 / soft)
    runner.compare("force", row["force"], exact, 1e-6)
    runner.verify(f"after {row['newton_iterations']:.0f} iterations", row["newton_iterations"] <= 10)


def nearly_incompressible(runner):
    """Uniaxial stress of bodies that hardly change their volume, with B-bar (exact)."""
    for nu in (0.4999, 0.499999, 0.499999999):
        for solver in ("multigrid", "direct"):
            step = runner.history("verification/uniaxial_stress.prm", "Material/Law=linear elastic",
                                  f"Material/Poisson's ratio={nu}", "Geometry/Initial refinements=3",
                                  "Discretization/Volumetric treatment=B-bar",
                                  f"Linear solver/Type={solver}")[-1]
            runner.compare(f"stress at nu = {nu}, {solver}", step["top_z"], 0.02 * E, 1e-6)


def direct_contact(runner):
    """A sphere on quadratic elements, whose matrix gets new patterns as the edge moves: both linear solvers."""
    entries = ("Geometry/Lower corner=0, -0.96", "Geometry/Upper corner=0.96, 0", "Geometry/Initial refinements=3",
               "Geometry/Local refinements=4", "Geometry/Local radius=0.7293", "Loading/History=1: depth 0.002",
               "Loading/Number of steps=10", "Refinement/Elements over contact radius=0",
               "Discretization/Polynomial degree=2", "Discretization/Volumetric treatment=standard")
    direct, multigrid = (runner.history("indentation/sphere_axisymmetric.prm", *entries, f"Linear solver/Type={solver}")
                         for solver in ("direct", "multigrid"))
    for quantity in ("force", "contact_area", "max_pressure"):
        runner.compare(quantity, direct[-1][quantity], multigrid[-1][quantity], 1e-7)


def moved_body(runner):
    """A body, free of forces as a whole, that leaves a sphere and comes back, or the sphere does so: the same forces."""
    body = ("indentation/sphere_axisymmetric.prm", "Geometry/Initial refinements=3", "Geometry/Local refinements=3",
            "Refinement/Elements over contact radius=0", "Loading/Number of steps=6")
    sphere = runner.history(*body, "Loading/History=1: depth -0.001 | 2: depth 0.01")
    moved = runner.history(*body, "Loading/History=", "Loading/Depth=0*t", "Loading/Final time=2", "Boundary conditions/Fixed=",
                           "Boundary conditions/Prescribed displacement=bottom: 0; if(t < 1, -0.001*t, -0.012 + 0.011*t)")
    for of_sphere, of_body in zip(sphere, moved):
        runner.compare(f"force at t = {of_sphere['time']:.3g}", of_body["force"], of_sphere["force"], 1e-9,
                       absolute=of_sphere["force"] == 0)
    runner.verify(f"contact at the end: force {moved[-1]['force']:.4g}", moved[-1]["force"] > 0)
