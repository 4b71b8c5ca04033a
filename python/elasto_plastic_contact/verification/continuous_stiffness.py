# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Verification of the stiffness of a small unloading at each load step (UnloadingStiffness); see verify."""

import math

from .runner import E_STAR

SWITCHED_ON = "Evaluation/Continuous stiffness=true"
FIXED_MESH = ("Refinement/Elements over contact radius=0", "Geometry/Local refinements=5", "Geometry/Local radius=1")
CONE = "indentation/cone_axisymmetric.prm"


def slope_of_small_unloading(runner, case, depth, *entries):
    """The stiffness at the largest depth, and the slope of a real unloading by a millionth of it."""
    back = depth * (1 - 1e-6)
    steps = runner.history(case, SWITCHED_ON, *entries, f"Loading/History=1: depth {depth} | 1.2: depth {back:.15g}",
                           "Loading/Number of steps=6", "Nonlinear solver/Tolerance=1e-13")
    deepest, after = steps[-2:]
    return deepest["contact_stiffness"], (deepest["force"] - after["force"]) / (deepest["depth"] - after["depth"])


def continuous_stiffness(runner):
    """That of a small real unloading, of an elastic sphere, and of any number of ranks; it changes nothing else."""
    for name, case, depth, entries in (
        ("cone", CONE, 0.02, FIXED_MESH),
        ("cone, friction", CONE, 0.02, FIXED_MESH + ("Contact/Friction coefficient=0.3",)),
        ("cone, contact ends at nodes", CONE, 0.02, FIXED_MESH + ("Contact/Edge=at nodes",)),
        ("cone, finite strain", CONE, 0.02, FIXED_MESH + ("Strain=logarithmic",)),
        ("sphere in space, multigrid", "indentation/sphere_3d.prm", 0.01, ()),
    ):
        stiffness, slope = slope_of_small_unloading(runner, case, depth, *entries)
        runner.compare(f"{name}: stiffness against the slope of a small unloading", stiffness, slope, 1e-4)

    elastic = runner.history("indentation/sphere_axisymmetric.prm", SWITCHED_ON, "Material/Law=linear elastic",
                             "Loading/History=1: depth 0.002", "Loading/Number of steps=4")[-1]
    runner.compare("elastic sphere: 2 E* a", elastic["contact_stiffness"],
                   2 * E_STAR * math.sqrt(elastic["contact_area"] / math.pi), 0.02)
    continuous_stiffness_of_ranks(runner)


def continuous_stiffness_of_ranks(runner):
    """The run is the same without; the stiffness is the same on each number of ranks."""
    loading = (*FIXED_MESH, "Loading/History=1: depth 0.02", "Loading/Number of steps=4")
    without = runner.history(CONE, *loading)
    runner.verify("not a number without the entry", all(math.isnan(step["contact_stiffness"]) for step in without))
    reference = runner.history(CONE, SWITCHED_ON, *loading)
    for name in ("depth", "force", "contact_area", "plastic_work", "linear_iterations"):
        runner.verify(f"{name}: all digits as without the entry",
                      [step[name] for step in without] == [step[name] for step in reference])
    for n in (2, 3):
        with runner.on_ranks(n):
            there = runner.history(CONE, SWITCHED_ON, *loading)
        runner.compare(f"{n} ranks", there[-1]["contact_stiffness"], reference[-1]["contact_stiffness"], 1e-6)
