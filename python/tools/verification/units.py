# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Verification that results do not depend on the units of length and stress; see verify."""

import math

from .runner import E

ITERATIONS = "linear_iterations"
CASE = "indentation/sphere_axisymmetric.prm"
TIPS = {
    "sphere": lambda length: ("Indenter/Type=sphere", f"Indenter/Radius={length}"),
    "punch that ends at a node": lambda length: ("Indenter/Type=circular punch", f"Indenter/Radius={0.25 * length}"),
    "cone by an expression, finite strains": lambda length: (
        "Indenter/Type=expression", "Indenter/Expression=0.1*abs(x)", "Strain=logarithmic"),
}


def steps_in(runner, tip, length, stress):
    """The history of a small block in these units of length and stress, in those of 1 and 1."""
    def size(*values):
        return ", ".join(f"{value * length:.17g}" for value in values)

    rows = runner.history(
        CASE, f"Geometry/Lower corner={size(0, -1)}", f"Geometry/Upper corner={size(1, 0)}", "Geometry/Initial refinements=4",
        "Geometry/Local refinements=0", "Refinement/Elements over contact radius=0", "Linear solver/Type=multigrid",
        f"Loading/History=1: depth {size(0.02)} | 2: force 0", "Loading/Number of steps=8", f"Material/Young's modulus={E * stress}",
        f"Material/Yield stress={2000 * stress}", f"Material/Isotropic hardening modulus={1000 * stress}", *TIPS[tip](length))
    powers = {"depth": length, "force": stress * length ** 2, "contact_area": length ** 2, "active_nodes": 1., ITERATIONS: 1.}
    return [{name: row[name] / unit for name, unit in powers.items()} for row in rows]


def units(runner):
    """A block under several tips in other units of length, and with forces that single precision does not know."""
    for tip in TIPS:
        usual = steps_in(runner, tip, 1., 1.)
        for name, length, stress in (("large lengths", 1e6, 1.), ("small lengths", 1e-6, 1e6), ("small forces", 1e-6, 1e-25)):
            steps = steps_in(runner, tip, length, stress)
            runner.verify(f"{tip}, {name}: as many steps", len(steps) == len(usual))
            for quantity, largest in ((key, max(row[key] for row in usual)) for key in usual[0] if key != ITERATIONS):
                difference = max(abs(a[quantity] - b[quantity]) for a, b in zip(steps, usual)) / largest
                runner.compare(f"{tip}, {name}: {quantity}", difference, 0, 1e-6, absolute=True)
            # (with a factorisation, which takes over where multigrid fails, they are half as many)
            runner.compare(f"{tip}, {name}: iterations", *(sum(row[ITERATIONS] for row in rows) for rows in (steps, usual)), 0.2)


def prescribed_from_nothing(runner):
    """A bar pulled by a displacement whose expression is no number at t = 0, with both linear solvers."""
    for solver in ("direct", "multigrid"):
        stress = runner.history("verification/uniaxial_stress.prm", "Material/Law=linear elastic", "Geometry/Initial refinements=3",
                                "Boundary conditions/Prescribed displacement=top: free; free; 0.02*sin(t)/t",
                                f"Linear solver/Type={solver}")[-1]["top_z"]
        runner.compare(f"stress, {solver}", stress, 0.02 * math.sin(1.) * E, 1e-8)
