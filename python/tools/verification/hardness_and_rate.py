# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Verification: how hardness depends on the rate (doc/theory/rate_dependence.md, "Hardness and rate"); see verify."""

import importlib.util
import math
import pathlib
import tempfile

from elasto_plastic_contact.program import command_line
from elasto_plastic_contact.tables import read_tables

CASE = "creep/rate_jump.prm"
EXPONENT, UNIT, REFERENCE_RATE = 5, 100.0, 0.001  # of the case, in N, mm, s

# A flat punch of radius 1 on an almost rigid body (where multigrid does not converge).
PUNCH = ("Geometry/Lower corner=0, -8", "Geometry/Upper corner=8, 0", "Indenter/Type=circular punch", "Indenter/Radius=1",
         "Contact/Edge=at nodes", "Loading/History=", "Loading/Depth=t", "Linear solver/Type=direct")


def creep_hardness(runner):
    """A cone on a creeping body: constant hardness at constant strain rates; jumps of the rate, and a hold (1 / exponent)."""
    tables = runner.tables(CASE, "Loading/History=0.5: depth 0.1 | 15: strain rate 0.05 | 45: strain rate 0.01 | "
                           "55: strain rate 0.05 | 75: force rate 0", "Loading/Number of steps=150")
    hardness = {}
    for begin, end, rate in ((0.5, 15, 0.05), (15, 45, 0.01), (45, 55, 0.05)):
        late = {step["step"]: step["force"] / step["contact_area"] for step in tables["history"]
                if 0.5 * (begin + end) <= step["time"] <= end}
        settled = [value for step, value in late.items() if not has_new_mesh(tables, step)]
        hardness[begin] = sum(settled) / len(settled)
        for name, value in (("largest", max(settled)), ("smallest", min(settled))):
            runner.compare(f"rate {rate}, up to t = {end}: {name} hardness", value, hardness[begin], 0.01)
        # Stresses that are interpolated to another mesh are those of the flow only after some strain.
        runner.compare(f"rate {rate}, up to t = {end}: smallest, also on new meshes", min(late.values()), hardness[begin], 0.03)
    runner.compare("hardness at the same rate, before and after", hardness[45], hardness[0.5], 0.01)
    *jumps, hold = tables["indentation"]
    runner.verify(f"jumps at t = {', '.join(str(row['time']) for row in jumps)}", [row["time"] for row in jumps] == [45, 55])
    for row in jumps:
        runner.compare(f"t = {row['time']}, sensitivity by the jump", row["jump_rate_sensitivity"], 1 / EXPONENT, 0.05)
    runner.compare("sensitivity by the hold", hold["hold_rate_sensitivity"], 1 / EXPONENT, 0.05)
    if importlib.util.find_spec("numpy"):  # (which measured curves need)
        runner.compare("sensitivity by the hold, from its depths", sensitivity_as_measured(tables), 1 / EXPONENT, 0.05)
    history = {step["time"]: step["depth"] for step in tables["history"]}
    runner.verify(f"depth grows in the hold, by {hold['creep_depth']:.3g}",
                  0 < hold["creep_depth"] < history[75] - history[55] + 1e-2 * history[55])


def sensitivity_as_measured(tables):
    """As 'epc evaluate' finds it of a curve that is not unloaded: the area of a cone is the section at the depth."""
    import numpy  # (which what needs no curve does without)
    from elasto_plastic_contact.measured.creep import FIRST_PART, rate_sensitivity
    held = [step for step in tables["history"] if step["time"] > 55 + FIRST_PART * (75 - 55)]
    time, depth = (numpy.array([step[column] for step in held]) for column in ("time", "depth"))
    return rate_sensitivity(time, depth, lambda depths: -2. * numpy.log(depths))


def has_new_mesh(tables, step):
    """Whether the mesh has changed before this step, or up to three before it."""
    return any(0 < step - change["step"] <= 4 for change in tables["mesh_changes"])


def at_rate(runner, rate, n_steps):
    """The last step at a constant strain rate, up to twice the depth."""
    return runner.history(CASE, f"Loading/History=0.5: depth 0.1 | {0.5 + 0.725 / rate}: strain rate {rate}",
                          f"Loading/Number of steps={n_steps}")[-1]


def power_law(n):
    """Entries of an elastic body with the stress UNIT strain^(1/n), in one step."""
    strain = 1e-6
    return ("Material/Law=nonlinear hardening", "Material/Rate law=none", "Material/Isotropic hardening modulus=0",
            f"Material/Yield stress={UNIT * strain ** (1 / n)}", f"Material/Power law exponent={1 / n}",
            f"Material/Power law reference strain={strain}", "Loading/Final time=1", "Loading/Number of steps=1")


def creep_punch(runner):
    """A flat punch on a creeping body: as nonlinear elasticity with the same exponent; large exponents: perfect plasticity."""
    def force(*entries):
        return runner.history(CASE, *PUNCH, *entries)[-1]["force"]

    creep = ("Loading/Final time=0.1", "Loading/Number of steps=10", "Material/Reference rate=1")
    for n in (3, 10):
        elastic = force(*power_law(n))
        for speed in (1, 8):
            runner.compare(f"n = {n}, rate {speed}: force", force(*creep, f"Material/Rate exponent={n}",
                                                                  f"Loading/Depth={speed}*t"), elastic * speed ** (1 / n), 0.01)
    plastic = force("Material/Law=perfectly plastic", f"Material/Yield stress={UNIT}", "Material/Rate law=none", *creep)
    runner.compare("n = 1000: force", force(*creep, "Material/Rate exponent=1000"), plastic, 0.01)


def creep_similarity(runner):
    """A cone on a creeping body: its exponent from two rates; force over a^2 as of an elastic punch with this exponent."""
    punch = runner.history(CASE, *PUNCH, *power_law(EXPONENT), "Refinement/Elements over contact radius=32")[-1]
    coefficient = punch["force"] / punch["contact_area"] / UNIT
    pressures, hardness = [], []
    for rate, n in ((0.01, 15), (0.05, 15), (0.05, 30)):
        step = at_rate(runner, rate, n)
        hardness.append(step["force"] / step["contact_area"])
        velocity = rate * step["depth"] / math.sqrt(step["contact_area"] / math.pi)
        pressures.append(hardness[-1] / UNIT / (velocity / REFERENCE_RATE) ** (1 / EXPONENT))
    # with equally many steps, and so the same error of them
    runner.compare("exponent", math.log(hardness[1] / hardness[0]) / math.log(5), 1 / EXPONENT, 0.02)
    # the first order of the error in the size of the steps taken away
    runner.compare("coefficient of the pressure", 2 * pressures[2] - pressures[1], coefficient, 0.01)


# Coarse and short.
COARSE = ("Refinement/Elements over contact radius=5", "Geometry/Initial refinements=3", "Loading/Number of steps=30",
          "Loading/History=1: depth 0.1 | 6: strain rate 0.1 | 16: strain rate 0.01 | 30: force rate 0")


def creep_runs(runner):
    """A cone on a creeping body: the same on 1 and 2 ranks, stopped and resumed, in seconds and hours; new meshes take no time."""
    entries = {"Output/Fields": "never"} | dict(entry.split("=", 1) for entry in COARSE)
    in_hours = {"Material/Reference rate": f"{3600 * REFERENCE_RATE}",
                "Loading/History": f"{1 / 3600}: depth 0.1 | {6 / 3600}: strain rate 360 | {16 / 3600}: strain rate 36 | "
                                   f"{30 / 3600}: force rate 0"}
    with tempfile.TemporaryDirectory() as folder:
        def run(changes, name, *options, ranks=runner.ranks):
            directory = pathlib.Path(folder) / name
            runner.start(command_line(runner.program, runner.case(CASE), changes, directory, *options, ranks=ranks))
            return read_tables(directory)

        whole = run(entries, "whole")
        changes = whole["mesh_changes"]
        runner.verify(f"{len(changes)} changes of the mesh, without creep",
                      len(changes) > 1 and all(change["plastic_work"] == change["dissipation"] == 0 for change in changes))
        run(entries | {"Loading/History": "1: depth 0.1 | 6: strain rate 0.1 | 16: strain rate 0.01",
                       "Loading/Number of steps": "16"}, "stopped")
        for name, other in (("2 ranks", run(entries, "ranks", ranks=2)),
                            ("resumed", run(entries, "stopped", "--resume")),
                            ("hours", run(entries | in_hours, "hours"))):
            for table, columns in (("history", ("depth", "force", "contact_area", "plastic_work")),
                                   ("indentation", ("hardness", "max_depth"))):
                runner.verify(f"{name}: rows of {table}", len(other[table]) == len(whole[table]))
                for column in columns:
                    largest = max(row[column] for row in whole[table])
                    difference = max(abs(a[column] - b[column]) for a, b in zip(whole[table], other[table])) / largest
                    runner.compare(f"{name}: {column}", difference, 0, 1e-9, absolute=True)


def creep_units(runner):
    """Creep and friction, under a cone with logarithmic strains, a sphere in space, and on quadratic elements: the same in hours and kPa."""
    cone, sphere = "indentation/cone_finite_strain.prm", "indentation/sphere_3d.prm"
    coarse = ("Geometry/Initial refinements=3", "Geometry/Local refinements=6")
    for name, case, depth, body in (
            ("logarithmic strains", cone, 0.02, coarse),
            ("in space", sphere, 0.005, ("Geometry/Initial refinements=2", "Refinement/Elements over contact radius=2")),
            ("quadratic elements", cone, 0.02, (*coarse, "Strain=small", "Discretization/Polynomial degree=2"))):
        def last_row(second, megapascal):
            return runner.tables(
                case, *body, "Contact/Friction coefficient=0.3", f"Loading/History={second}: depth {depth} | {9 * second}: hold",
                "Loading/Number of steps=6", "Material/Law=linear elastic", f"Material/Young's modulus={2e5 * megapascal}",
                "Material/Rate law=Norton", f"Material/Rate exponent={EXPONENT}", f"Material/Rate stress={400 * megapascal}",
                f"Material/Reference rate={REFERENCE_RATE / second}", "Nonlinear solver/Tolerance=1e-11")["history"][-1]

        one, other = last_row(1, 1), last_row(1 / 3600, 1000)
        for column, unit in (("depth", 1), ("force", 1000), ("contact_area", 1), ("plastic_work", 1000)):
            runner.compare(f"{name}: {column}", other[column] / unit, one[column], 1e-8)


def hold_before_path(runner):
    """A sphere that is held before it moves sideways: corners of 'Loading/Path' change nothing of what the hold says."""
    entries = ("Geometry/Lower corner=0, -1, -1", "Geometry/Upper corner=1, 1, 0", "Geometry/Repetitions=1, 2, 1",
               "Boundary conditions/Roller=left", "Boundary conditions/Free=right, back, front",
               "Refinement/Elements over contact radius=0", "Material/Law=linear elastic", "Material/Rate law=Norton",
               f"Material/Rate exponent={EXPONENT}", f"Material/Reference rate={REFERENCE_RATE}", "Material/Rate stress=400",
               "Loading/History=1: force 100 | 11: hold | 12: force 0", "Loading/Number of steps=24")
    rows, of_path = (runner.tables("indentation/sphere_3d.prm", *entries, *path)["indentation"]
                     for path in ((), ("Loading/Path=6: 0, 0 | 11: 0, 0 | 12: 0, 1e-7",)))
    runner.verify("one row of the hold", [row["time"] for row in rows] == [row["time"] for row in of_path] == [11])
    for column in ("creep_depth", "hold_rate_sensitivity"):
        runner.compare(column, of_path[0][column], rows[0][column], 1e-6)
