# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Verification of the stiffness of a small unloading at each load step (UnloadingStiffness); see verify."""

import math

from .runner import E_STAR

SWITCHED_ON = "Evaluation/Continuous stiffness=true"
FIXED_MESH = ("Refinement/Elements over contact radius=0", "Geometry/Local refinements=5", "Geometry/Local radius=1")
CONE = "indentation/cone_axisymmetric.prm"


# A body that flows at a finite rate has no time for it in so short an unloading: all of it springs back elastically.
FAST = 1e-11
FLOWING = ("Material/Rate law=Duvaut-Lions", "Material/Relaxation time=0.1")
ELASTIC = ("Material/Law=linear elastic",)


def compare_with_unloading(runner, name, case, depth, allowed, *entries):
    """The stiffness at the largest depth with the slope of a real unloading by a millionth of it. Returns their ratio."""
    steps = runner.history(case, SWITCHED_ON, *entries, "Loading/Number of steps=5", "Nonlinear solver/Tolerance=1e-13",
                           f"Loading/History=1: depth {depth} | {1 + FAST:.15g}: depth {depth * (1 - 1e-6):.15g}")
    deepest, after = steps[-2:]
    slope = (deepest["force"] - after["force"]) / (deepest["depth"] - after["depth"])
    runner.compare(f"{name}: slope of a small unloading", deepest["contact_stiffness"], slope, allowed)
    return deepest["contact_stiffness"] / slope


def continuous_stiffness(runner):
    """That of a small real unloading, of an elastic sphere, and on three ranks; it changes nothing else."""
    for name, entries in (("cone", ()), ("cone, finite strain", ("Strain=logarithmic",))):
        compare_with_unloading(runner, name, CONE, 0.02, 1e-4, *FIXED_MESH, *FLOWING, *entries)
    for edge in ("within faces", "at nodes"):
        compare_with_unloading(runner, f"elastic cone, contact ends {edge}", CONE, 0.02, 1e-6, *FIXED_MESH, *ELASTIC,
                               f"Contact/Edge={edge}")
    compare_with_unloading(runner, "sphere in space, multigrid", "indentation/sphere_3d.prm", 0.01, 1e-4, *FLOWING,
                           "Geometry/Initial refinements=2", "Refinement/Elements over contact radius=2")
    # (at once some points at the edge of the contact flow on, which makes a real unloading softer)
    ratio = compare_with_unloading(runner, "cone that flows at once", CONE, 0.02, 0.01, *FIXED_MESH)
    runner.verify(f"the real one is not stiffer ({ratio:.5f})", ratio > 1. - 1e-6)

    elastic = runner.history("indentation/sphere_axisymmetric.prm", SWITCHED_ON, "Material/Law=linear elastic",
                             "Loading/History=1: depth 0.002", "Loading/Number of steps=4")[-1]
    runner.compare("elastic sphere: 2 E* a", elastic["contact_stiffness"],
                   2 * E_STAR * math.sqrt(elastic["contact_area"] / math.pi), 0.02)
    continuous_stiffness_of_ranks(runner)


def continuous_stiffness_of_ranks(runner):
    """The run is the same without; the stiffness is the same on another number of ranks."""
    loading = (*FIXED_MESH, "Loading/History=1: depth 0.02", "Loading/Number of steps=4")
    without = runner.history(CONE, *loading)
    runner.verify("not a number without the entry", all(math.isnan(step["contact_stiffness"]) for step in without))
    reference = runner.history(CONE, SWITCHED_ON, *loading)
    for name in ("depth", "force", "contact_area", "plastic_work", "linear_iterations"):
        runner.verify(f"{name}: all digits as without the entry",
                      [step[name] for step in without] == [step[name] for step in reference])
    with runner.on_ranks(3):
        there = runner.history(CONE, SWITCHED_ON, *loading)
    runner.compare("3 ranks", there[-1]["contact_stiffness"], reference[-1]["contact_stiffness"], 1e-6)
