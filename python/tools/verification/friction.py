# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Verification of friction and of indenters that move to the side; see verify."""

import math
import pathlib
import tempfile

from elasto_plastic_contact.program import command_line
from elasto_plastic_contact.tables import read_tables
from .imprint import largest_difference

MINDLIN = "friction/mindlin_cylinder.prm"
MU = 0.3
# Pressed, then pushed to the side.
PUSHED = ("Loading/History=1: force 836.8 | 2: force 836.8", "Loading/Path=1: 0 | 2: 0.003")
# A mesh that does not follow the contact, and few steps, for what does not depend on them.
COARSE = ("Geometry/Local refinements=7", "Refinement/Elements over contact radius=0", "Loading/Number of steps=8",
          "Nonlinear solver/Tolerance=1e-11")
# At the nodes x (mm): displacements (um) in two columns of code_aster's SSNV128, published and of its finite elements.
SSNV128 = {0.0: (28.6, 28.65), 1.25: (27.2, 27.27), 5.0: (22.8, 22.92), 7.5: (19.8, 19.93), 11.25: (15.0, 15.61)}


def ssnv128(runner):
    """A plate that is pushed along a rigid plane (code_aster SSNV128)."""
    profile = runner.tables("friction/ssnv128.prm", "Geometry/Initial refinements=6")["surface_profile"]
    displacements = {row["x"]: 1e3 * row["displacement_x"] for row in profile}
    for x, (published, computed) in SSNV128.items():
        if abs(computed / published - 1) < 0.01:
            runner.compare(f"u_x (um) at x = {x}", displacements[x], computed, 0.01)
        else:
            runner.verify(f"u_x (um) at x = {x}: {displacements[x]:.4g}, between {published} and {computed}",
                          published <= displacements[x] <= computed)
    runner.verify("stick or slip as Coulomb demands", all(
        abs(row["contact_shear_x"]) <= row["contact_pressure"] * (1 if row["stick"] == 1 else 1 + 1e-6)
        for row in profile))


def bonded_punch(runner):
    """A flat circular punch that is bonded to the body, against a smooth one."""
    bonded, smooth = (runner.run("friction/bonded_punch.prm", f"Contact/Friction coefficient={coefficient}")[-1]["force"]
                      for coefficient in ("stick", "0"))
    nu = 0.3
    runner.compare("force, bonded over smooth", bonded / smooth, (1 - nu) * math.log(3 - 4 * nu) / (1 - 2 * nu), 2e-3)


def adhesion(runner):
    """A sphere and a cone that stick to the body: depth and force grow as under bonded flat punches that become wider."""
    shear_modulus, nu = 2e5 / 2.6, 0.3
    stiffness = 4 * shear_modulus * math.log(3 - 4 * nu) / (1 - 2 * nu)  # dP/d(depth) over the radius
    sphere = ("Loading/History=1: depth 0.0004 | 2: force 0",)
    cone = ("Loading/History=1: depth 0.004 | 2: force 0", "Indenter/Type=cone", "Indenter/Semi-apex angle=85")
    # (In ten steps; the error is proportional to their length.)
    for name, indenter, exponent, degree, tolerance in (("sphere", sphere, 2, 1, 0.005), ("cone", cone, 1, 2, 0.01)):
        rows = runner.history("indentation/sphere_axisymmetric.prm", *indenter, "Loading/Number of steps=20",
                              "Refinement/Elements over contact radius=12",
                              "Material/Law=linear elastic", "Contact/Friction coefficient=stick",
                              f"Discretization/Polynomial degree={degree}",
                              f"Discretization/Volumetric treatment={'B-bar' if degree == 1 else 'standard'}")
        runner.verify(f"{name}, degree {degree}: no step is cut", len(rows) == 20)
        pressed, freed = rows[9], rows[19]
        radius = math.sqrt(pressed["contact_area"] / math.pi)
        runner.compare(f"{name}, degree {degree}: force",
                       pressed["force"] / (radius * pressed["depth"] * exponent / (exponent + 1)), stiffness,
                       tolerance)
        runner.compare(f"{name}, degree {degree}: energy left", freed["elastic_energy"] / pressed["elastic_energy"],
                       0, 1e-12, absolute=True)
        most = max(row["newton_iterations"] for row in rows)
        runner.verify(f"{name}, degree {degree}: at most {most:.0f} Newton steps in a load step", most <= 25)


def spence(runner):
    """A flat circular punch with friction: the same stick radius at all loads."""
    for coefficient in (0.05, 0.1, 0.2):
        rows = runner.history("friction/bonded_punch.prm", f"Contact/Friction coefficient={coefficient}",
                              "Loading/Number of steps=5")
        radii = [math.sqrt(row["stick_area"] / row["contact_area"]) for row in rows]
        print(f"  coefficient {coefficient}: stick radius {radii[-1]:.4f}", flush=True)
        runner.verify("some stick, some slip", 0 < radii[-1] < 1)
        runner.compare("largest over smallest stick radius", max(radii) / min(radii), 1, 1e-2)


def mindlin_cylinder(runner):
    """A cylinder pushed to the side: stick width by Cattaneo and Mindlin; full slip."""
    rows = runner.history(MINDLIN, *PUSHED, "Loading/Number of steps=6", "Refinement/Elements over contact radius=12")
    for row in rows:
        ratio = row["tangential_force_x"] / (MU * row["force"])
        if row["time"] > 1:
            runner.compare(f"Q/(mu P) = {ratio:.3f}: c/a", row["stick_area"] / row["contact_area"], math.sqrt(1 - ratio),
                           0.02)
    check_energy(runner, rows)
    row = runner.history(MINDLIN, *COARSE, "Loading/Path=1: 0 | 2: 0.02", "Loading/History=2: force 836.8")[-1]
    runner.compare("full slip: Q", row["tangential_force_x"], MU * row["force"], 1e-8)
    runner.compare("full slip: stick area", row["stick_area"], 0, 0, absolute=True)


def mindlin_sphere(runner):
    """A sphere pushed to the side: stick radius by Mindlin; some 4 minutes on one processor."""
    for row in runner.history("friction/mindlin_sphere.prm")[1:]:
        ratio = row["tangential_force_x"] / (MU * row["force"])
        runner.compare(f"Q/(mu P) = {ratio:.3f}: c/a", math.sqrt(row["stick_area"] / row["contact_area"]),
                       (1 - ratio) ** (1 / 3), 0.02)


def sliding_mesh(runner):
    """A cylinder that slides farther than its contact is wide: the mesh goes with it."""
    rows = runner.history(MINDLIN, "Loading/History=1: force 836.8 | 2: force 836.8", "Loading/Path=1: 0 | 2: 0.5",
                          "Loading/Number of steps=12", "Refinement/Elements over contact radius=5",
                          "Contact/Friction coefficient=0.1")
    sliding = [row for row in rows if row["time"] > 1.2]
    for name in ("depth", "contact_area"):
        values = [row[name] for row in sliding]
        runner.compare(f"largest over smallest {name}", max(values) / min(values), 1, 0.02)
    for row in (sliding[0], sliding[-1]):
        runner.compare("full slip: Q", row["tangential_force_x"], 0.1 * row["force"], 1e-8)
    runner.compare("contact width", sliding[-1]["contact_area"], 0.4, 0.02)


def friction_symmetries(runner):
    """A cylinder pushed the other way, and in other units: the same."""
    rows = of_curve(runner.history(MINDLIN, *COARSE, *PUSHED))
    mirrored = of_curve(runner.history(MINDLIN, *COARSE, PUSHED[0], "Loading/Path=1: 0 | 2: -0.003"))
    for row in mirrored:
        row["tangential_force_x"] *= -1
    runner.compare("pushed the other way", largest_difference(rows, mirrored), 0, 1e-9, absolute=True)
    in_metres = of_curve(runner.history(
        MINDLIN, *COARSE, "Geometry/Lower corner=-0.016, -0.016", "Geometry/Upper corner=0.016, 0", "Geometry/Local radius=0.008",
        "Material/Young's modulus=200e9", "Indenter/Radius=0.01", "Loading/History=1: force 836.8e3 | 2: force 836.8e3",
        "Loading/Path=1: 0 | 2: 3e-6"))
    powers = {"depth": -3, "force": 3, "tangential_force_x": 3, "contact_area": -3, "frictional_dissipation": 0}
    for row in in_metres:
        for name, power in powers.items():
            row[name] /= 10 ** power
    runner.compare("in metres, pascals", largest_difference(rows, in_metres), 0, 1e-9, absolute=True)


def check_energy(runner, rows):
    """The work of the indenter, by the trapezoidal rule, reaches the body or is friction."""
    work, before = 0, {"depth": 0, "force": 0, "tangential_force_x": 0, "path": 0}
    for row in rows:
        row["path"] = 0.003 * max(0, row["time"] - 1)
        work += sum(0.5 * (row[force] + before[force]) * (row[way] - before[way])
                    for force, way in (("force", "depth"), ("tangential_force_x", "path")))
        before = row
    runner.compare("work of the indenter", work, rows[-1]["external_work"] + rows[-1]["frictional_dissipation"], 0.01)
    losses = [row["frictional_dissipation"] for row in rows]
    runner.verify("dissipation of friction never falls", losses[0] >= 0 and losses == sorted(losses))


def of_curve(rows):
    """What does not depend on the way to it."""
    return [{name: row[name] for name in ("depth", "force", "tangential_force_x", "contact_area",
                                          "frictional_dissipation")} for row in rows]


def friction_ranks(runner):
    """A cylinder to and fro: the same on 1 and 2 ranks."""
    for coefficient in (MU, "stick"):
        job = (MINDLIN, *COARSE, f"Contact/Friction coefficient={coefficient}")
        tables = {}
        for n in (1, 2):
            with runner.on_ranks(n):
                tables[n] = of_curve(runner.tables(*job)["history"])
        runner.compare(f"coefficient {coefficient}, 2 ranks: forces, depth and contact area",
                       largest_difference(tables[1], tables[2]), 0, 1e-8, absolute=True)


def friction_resume(runner):
    """A cylinder to and fro, stopped in between and resumed, as in one run."""
    for coefficient in (MU, "stick"):
        resume_with(runner, coefficient)


def resume_with(runner, coefficient):
    """See friction_resume()."""
    entries = {"Output/Fields": "never", "Contact/Friction coefficient": str(coefficient),
               **dict(entry.split("=", 1) for entry in COARSE)}
    stopped = entries | {"Loading/History": "1: force 836.8 | 3: force 836.8", "Loading/Number of steps": "6"}
    with tempfile.TemporaryDirectory() as folder:
        def run(changes, name, *options):
            directory = pathlib.Path(folder) / name
            runner.start(command_line(runner.program, runner.case(MINDLIN), changes, directory, *options, ranks=runner.ranks))
            return of_curve(read_tables(directory)["history"])
        whole = run(entries, "whole")
        run(stopped, "stopped")
        runner.compare(f"coefficient {coefficient}: forces, depth and contact area",
                       largest_difference(whole, run(entries, "stopped", "--resume")), 0, 1e-9, absolute=True)
