# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of iterations, times and memory; see command."""

import pathlib
import platform
import re

from elasto_plastic_contact.errors import UserError
from elasto_plastic_contact.program import checkout
from ..verification.equilibrium import BOUND
from ..verification.runner import EULER
from ..verification.step42_comparison import CASES, run_both, times_to_accuracy
from .recipe import Content, count, measured_table, table

N_CYCLES = "Refinement/Number of cycles={}"
TIGHT = "Nonlinear solver/Loosest linear reduction=1e-8"
UNIFORM = "step42/sphere_uniform_q{}.prm"
ADAPTIVE = "step42/sphere_adaptive_q{}.prm"


def machine(runs):
    """The processor and the number of ranks, without blanks and brackets, which end a place of the text."""
    info = pathlib.Path("/proc/cpuinfo")
    text = info.read_text(encoding="ascii") if info.exists() else ""
    model = re.search(r"^model name\s*: (.*)$", text, re.MULTILINE)
    ranks = f"{runs.ranks} rank" + "s" * (runs.ranks > 1)
    name = re.sub(r" ?\([^)]*\)", "", model[1] if model else platform.processor())
    return f"{name}, {ranks}".replace(" ", "&nbsp;")


def mean_iterations(rows):
    """Conjugate gradient steps per Newton step, on each mesh."""
    return [f"{row['linear_iterations'] / row['newton_iterations']:.1f}" for row in rows]


def padded(cells, n_cells):
    return [None, *cells, *[""] * (n_cells - len(cells))]


@table(130)
def multigrid_iterations(runs):
    """Conjugate gradient steps on adaptive and uniform meshes, linear elements."""
    case = ADAPTIVE.format(1)
    sequences = ((case, 6), (case, 6, "Material/Isotropic hardening modulus=23.08"),
                 (case, 5, "Material/Law=linear elastic"), (UNIFORM.format(1), 4))
    return Content([padded(mean_iterations(runs.tables(case, N_CYCLES.format(n), TIGHT, *entries)["statistics"]), 6)
                    for case, n, *entries in sequences])


@table(150)
def multigrid_plane(runs):
    """The same in plane strain, quadratic elements."""
    multigrid = ("cylinder_2d.prm", TIGHT, "Linear solver/Type=multigrid")
    adaptive = runs.tables(*multigrid, N_CYCLES.format(11))["statistics"]
    uniform = runs.tables(*multigrid, "Refinement/Strategy=global", N_CYCLES.format(6))["statistics"]
    return Content([padded(mean_iterations(rows), 11) for rows in (adaptive, uniform)],
                   {"adaptive": count(adaptive[-1]["dofs"]), "uniform": count(uniform[-1]["dofs"])})


# Of the table: case, number of meshes, how many of them are shown, entries.
DIFFICULT = (
    (ADAPTIVE.format(1), 5, 3, "Material/Law=perfectly plastic"),
    ("rough_surface_3d.prm", 3, 3),
    ("rough_surface_3d.prm", 2, 2, "Indenter/Type=expression", "Geometry/Initial refinements=5",
     "Indenter/Expression=0.02*(1-sin(64*x)*sin(64*y))+0.002*sin(7*x)*cos(5*y)"),
    ("flat_punch_2d.prm", 4, 4, "Linear solver/Type=multigrid"),
    ("verification/hertz_sphere.prm", 7, 3, "Boundary conditions/Fixed=", "Boundary conditions/Roller=left, front, bottom",
     "Material/Law=isotropic hardening", "Material/Yield stress=400", "Material/Isotropic hardening modulus=1000",
     "Loading/Depth=0.05"),
    ("sphere_3d.prm", 5, 3, "Material/Poisson's ratio=0.499"),
    ("sphere_3d.prm", 5, 3, "Material/Poisson's ratio=0.4999"),
    ("sphere_3d.prm", 4, 3, "Material/Poisson's ratio=0.4999", "Discretization/Polynomial degree=2",
     "Geometry/Initial refinements=2"),
    ("sphere_3d.prm", 3, 3, "Material/Poisson's ratio=0.499", "Discretization/Polynomial degree=2",
     "Discretization/Volumetric treatment=standard", "Geometry/Initial refinements=2"),
)


@table(900)
def difficult_problems(runs):
    """Newton and conjugate gradient steps of difficult problems."""
    rows = []
    for case, n_meshes, n_shown, *entries in DIFFICULT:
        last = runs.tables(case, N_CYCLES.format(n_meshes), *entries)["statistics"][-n_shown:]
        rows.append([None, "; ".join(count(row["dofs"]) for row in last),
                     "; ".join(f"{row['newton_iterations']:.0f} ({row['linear_iterations']:.0f})" for row in last)])
    return Content(rows)


@measured_table(50)
def cost_of_cases(runs):
    """Time and memory of this program on step-42's cases."""
    rows = []
    for case, n_cycles in ((UNIFORM.format(1), 4), (ADAPTIVE.format(1), 6), (ADAPTIVE.format(2), 5)):
        tables, time = runs.timed(case, N_CYCLES.format(n_cycles))
        first, *_, last = tables["statistics"]
        kilobytes = 1024 * (last["memory_mb"] - first["memory_mb"]) / last["dofs"]
        unknowns = sum(row["dofs"] for row in tables["statistics"])
        rows.append([None, count(last["dofs"]), f"{time:.0f} s", f"{1e6 * time / unknowns:.0f} µs",
                     f"{kilobytes:.2f} KB"])
    return Content(rows, {"machine": machine(runs)})


# Of the table: cases in indentation/, with entries. The last two stay on one mesh.
HISTORIES = (
    ("sphere_axisymmetric",), ("cone_axisymmetric",), ("hardened_steel",), ("sphere_3d",),
    ("sphere_axisymmetric", "Loading/History=1: depth 0.002 | 2: force 0", "Loading/Number of steps=200", EULER,
     "Refinement/Elements over contact radius=0", "Geometry/Lower corner=0, -4", "Geometry/Upper corner=4, 0",
     "Geometry/Initial refinements=5", "Geometry/Local refinements=6", "Geometry/Local radius=3",
     "Output/Fields=at times", "Output/Field times=1, 2"),
    ("berkovich_sector", "Geometry/Radius=45.056", "Geometry/Height=45.056", "Loading/Number of steps=40",
     "Loading/History=0.2: depth 0.002 | 0.5: depth 0.007 | 1: depth 0.02 | 1.3333333333: force 0"))


@measured_table(200)
def cost_of_histories(runs):
    """Time of load histories on meshes that follow the contact, and on one mesh."""
    rows = []
    for name, *entries in HISTORIES:
        tables, time = runs.timed(f"indentation/{name}.prm", *entries)
        solves, steps = tables["statistics"], tables["history"]
        meshes = sum(row["step"] == 1 for row in solves) + len(tables["mesh_changes"])
        rows.append([None, count(max(row["dofs"] for row in solves)), count(len(steps)), count(meshes),
                     *(count(sum(row[f"{kind}_iterations"] for row in solves)) for kind in ("newton", "linear")),
                     f"{time:.0f} s"])
    return Content(rows, {"machine": machine(runs)})


@measured_table(400)
def cost_of_equilibrium(runs):
    """Interior point iterations and times of the equilibrium method, on the last mesh."""
    hardening = (BOUND, N_CYCLES.format(1), "Geometry/Initial refinements=1", "Geometry/Repetitions=25, 25")
    bounds = (("limit_load/strip_punch.prm", N_CYCLES.format(7)), ("limit_load/strip_punch.prm", N_CYCLES.format(11)),
              ("limit_load/circular_punch.prm",), ("limit_load/square_punch_3d.prm",), ("cylinder_2d.prm", *hardening),
              ("error_bound/parabola.prm", N_CYCLES.format(6)))
    rows = []
    for case, *entries in bounds:
        tables = runs.tables(case, *entries)
        row = (tables.get("limit_load") or tables["error_bound"])[-1]
        names = ("lower_iterations", "upper_iterations") if "lower_iterations" in row else ("iterations",)
        iterations = " and ".join(count(row[name]) for name in names)
        rows.append([None, count(row["triangles"]), iterations, f"{row['wall_seconds']:.2g} s"])
    return Content(rows, {"machine": machine(runs)})


@measured_table(1500)
def large_problems(runs):
    """step-42's sphere to 21.6 million unknowns, linear elements (20 GB)."""
    return Content(columns_of_meshes(runs, 1, 5), {"machine": machine(runs)})


@measured_table(1000)
def large_problems_quadratic(runs):
    """The same with quadratic elements (10 GB)."""
    return Content(columns_of_meshes(runs, 2, 4), {"machine": machine(runs)})


def columns_of_meshes(runs, degree, n_cycles):
    """Iterations, time and memory of the last four meshes of a sequence of uniform ones."""
    rows = runs.tables(UNIFORM.format(degree), "Geometry/Repetitions=3, 3, 3", "Geometry/Initial refinements=2",
                       N_CYCLES.format(n_cycles))["statistics"][-4:]
    columns = [(count(row["newton_iterations"]), count(row["linear_iterations"]),
                f"{row['wall_seconds']:.3g} s", f"{1e6 * row['wall_seconds'] / row['dofs']:.0f} µs",
                f"{row['memory_mb'] / 1024:.2g} GB") for row in rows]
    return [[None, *cells] for cells in zip(*columns)]


@measured_table(2500)
def against_step42(runs):
    """Whole runs of this program and of step-42, which scripts/compare_with_step42.sh builds."""
    step42 = checkout() / "build/step-42/build/step-42"
    if not step42.exists():
        raise UserError(f"there is no '{step42}': scripts/compare_with_step42.sh builds it")
    pairs = {name: run_both(runs.program, str(step42), name, CASES[name].default_cycles, runs.ranks)
             for name in ("uniform_q1", "adaptive_q1", "adaptive_q2")}
    rows = []
    for ours, other in pairs.values():
        finest, their_finest = ours.meshes[-1], other.meshes[-1]
        rows.append([None, count(finest.dofs), *seconds((ours.seconds, other.seconds)),
                     f"{finest.newton_steps}, {their_finest.newton_steps}",
                     f"{finest.linear_iterations}, {2 * their_finest.linear_iterations}",  # BiCGStab has two products
                     ", ".join(f"{run.kilobytes_per_unknown(runs.ranks):.2f}" for run in (ours, other))])
    _, best = times_to_accuracy(pairs, runs.program, runs.ranks)
    return Content([*rows, [None, None, *seconds([values[0][0] for values in best.values()]), "", "", ""]],
                   {"machine": machine(runs)})


def seconds(times):
    """Of both programs, and their ratio."""
    ours, step42 = times
    return f"{ours:.3g} s", f"{step42:.3g} s", f"{step42 / ours:.2g}"
