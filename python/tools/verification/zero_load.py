# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Verification of load histories that pass through zero load; see verify."""

import math

from . import uniaxial
from .runner import E

STRAIN = "0.02*if(t <= 1, t, if(t <= 2, 3 - 2*t, t - 3))"
N_STEPS = 60
# Complementarity counts what is left on free nodes times their gap, which is 1e5 times the depth here.
TIGHT = "Nonlinear solver/Tolerance=1e-13"
BODIES = {
    "bar": ("material/uniaxial_isotropic.prm", (), "top_z"),
    "sheet": ("material/plane_stress_tension.prm", (), "top_y"),
}
LAWS = {
    "perfectly plastic": uniaxial.Law(E, 400),
    "linear elastic": uniaxial.Law(E, 1e30),
    "Armstrong-Frederick": uniaxial.Law(E, 400, back=((30000, 150),)),
}


def entries(name):
    """Of a law; the simple ones by their own names, which is another path in the program."""
    return (LAWS[name].entries() if name == "Armstrong-Frederick" else
            (f"Material/Law={name}", "Material/Yield stress=400"))


def zero_stress(runner):
    """Bar and sheet whose stress passes through zero, pulled, pushed and taken back (exact)."""
    strains = [0.02 * (t if t <= 1 else 3 - 2 * t if t <= 2 else t - 3)
               for t in (3 * (step + 1) / N_STEPS for step in range(N_STEPS))]
    for name, law in LAWS.items():
        exact = [stress for stress, _, _ in uniaxial.steps(law, strains)]
        largest = max(map(abs, exact))
        for body, (case, more, column) in BODIES.items():
            steps = runner.history(case, *more, *entries(name))
            runner.verify(f"{body}, {name}: no step is cut", len(steps) == N_STEPS)
            error = max(abs(step[column] - stress) for step, stress in zip(steps, exact))
            runner.compare(f"{body}, {name}, largest error of a stress", error / largest, 0, 1e-8,
                           absolute=True)


def far_indenter(runner):
    """A force that pushes an indenter from far above: the way to the body is no deformation."""
    depths = [runner.history("indentation/sphere_axisymmetric.prm", "Geometry/Local refinements=4", "Geometry/Local radius=4",
                             "Refinement/Elements over contact radius=0", "Material/Law=linear elastic", "Loading/Control=force", "Loading/History=",
                             "Loading/Force=0.02", "Loading/Number of steps=1",
                             f"Indenter/Initial gap={gap}", TIGHT)[-1]["depth"] - gap for gap in (0, 10)]
    runner.compare("depth below the surface, from afar and from near", *reversed(depths), 1e-7)


def zero_force(runner):
    """An elastic sphere problem whose force is taken back to zero: the indenter just touches."""
    sphere = ("indentation/sphere_axisymmetric.prm", "Geometry/Local refinements=4", "Geometry/Local radius=4",
              "Refinement/Elements over contact radius=0", "Loading/Number of steps=12")
    force = ("Loading/Control=force", "Loading/History=", "Loading/Force=20*if(t<1,t,2-t)",
             "Loading/Final time=2")
    for name, depth, load in (
        ("from a depth", 0.002, ("Material/Law=linear elastic",)),
        ("from a depth, with an initial gap", 0.012,
         ("Material/Law=linear elastic", "Indenter/Initial gap=0.01",
          "Loading/History=1: depth 0.012 | 2: force 0 | 3: depth 0.012")),
        ("below first yield", 1e-5, ("Loading/History=1: depth 1e-5 | 2: force 0 | 3: depth 1e-5", TIGHT)),
        ("by a force", None, ("Material/Law=linear elastic", *force)),
    ):
        steps = runner.history(*sphere, *load)
        runner.verify(f"{name}: no step is cut", len(steps) == 12)
        loaded, unloaded = (next(step for step in steps if math.isclose(step["time"], time))
                            for time in (1, 2))
        gap = 0.01 if "gap" in name else 0
        if depth is not None:
            runner.compare(f"{name}: depth", loaded["depth"], depth, 1e-14)
            runner.compare(f"{name}: force when loaded again", steps[-1]["force"], loaded["force"], 1e-9)
        runner.compare(f"{name}: residual depth", (unloaded["depth"] - gap) / (loaded["depth"] - gap), 0,
                       1e-9, absolute=True)
        runner.verify(f"{name}: the depth is none", gap > 0 or unloaded["depth"] == 0)
        runner.verify(f"{name}: no force, no contact",
                      unloaded["force"] == 0 and unloaded["active_nodes"] == 0)
