# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Verification of what --validate says of a job before it is done; see verify."""

import math
import re
import time

ONE_MESH = ("Loading/History=1: depth 0.001", "Loading/Number of steps=2", "Refinement/Elements over contact radius=0")

# Case, entries, and how far cells and unknowns of first and last mesh may be off.
CASES = [
    ("sphere_3d.prm", ("Refinement/Number of cycles=3",), 0, 0.15),
    ("cylinder_2d.prm", ("Refinement/Number of cycles=4",), 0, 0.1),
    ("rough_surface_3d.prm", ("Refinement/Number of cycles=1",), 0, 0),
    ("step42/sphere_uniform_q1.prm", ("Refinement/Number of cycles=2",), 0, 0),
    ("step42/sphere_uniform_q2.prm", ("Refinement/Number of cycles=2",), 0, 0),
    ("verification/thick_sphere_3d.prm", ("Loading/Number of steps=1",), 0, 0.1),
    ("indentation/hardened_steel.prm", ONE_MESH, 0, 0),
    ("indentation/cone_axisymmetric.prm", ONE_MESH, 0, 0),
    ("indentation/sphere_3d.prm", ONE_MESH, 0, 0),
    ("indentation/sphere_axisymmetric.prm", ("Loading/History=1: depth 0.002", "Loading/Number of steps=6"), 0, 0.3),
    # too large to be made for a look: without local refinements exact, with them an estimate
    ("verification/confined_block.prm", ("Geometry/Initial refinements=5",), 0, 0),
    ("verification/confined_block.prm", ("Geometry/Initial refinements=4", "Discretization/Polynomial degree=2"), 0, 0),
    ("indentation/sphere_axisymmetric.prm", (*ONE_MESH, "Geometry/Initial refinements=7"), 0.1, 0.1),
]


def numbers(text):
    return [float(number) for number in re.findall(r"(?<![\w.])[0-9]+", text)][-2:]


def job_preview(runner):
    """Cells and unknowns as --validate says them, against those of the run; in about a second."""
    for case, entries, off_at_first, off_at_last in CASES:
        preview = runner.preview(case, *entries)
        rows = runner.tables(case, *entries)["statistics"]
        for title, row, off in (("First mesh", rows[0], off_at_first), ("Last mesh", rows[-1], off_at_last)):
            text = preview.get(title, preview["First mesh"]).split(";")[0]
            for name, value in zip(("cells", "dofs"), numbers(text)):
                # (the last mesh is said to three digits)
                digits = 0.005 if title in preview and title == "Last mesh" else 0
                runner.compare(f"{case}, {title.lower()}, {name}", value, row[name], max(off, digits))
    with runner.results("cylinder_2d.prm", ("Refinement/Number of cycles=1",)) as folder:
        runner.verify("results are noticed",
                      "holds results already" in runner.preview("cylinder_2d.prm", directory=folder)["Results"])
    usual, incompressible = (numbers(runner.preview("sphere_3d.prm", f"Material/Poisson's ratio={nu}")["Memory"])[0]
                             for nu in (0.3, 0.499))
    runner.verify(f"pressures need memory, too: {usual} MB, {incompressible} MB", incompressible > 1.4 * usual)
    box = ("Refinement/Elements over contact radius=0", "Geometry/Initial refinements=5")
    small, finite = (numbers(runner.preview("indentation/sphere_3d.prm", *box, f"Strain={strain}")["Memory"])[0]
                     for strain in ("small", "logarithmic"))
    runner.verify(f"so do finite strains: {small} MB, {finite} MB (245 and 306 were measured)", finite > 1.1 * small)
    begin = time.monotonic()
    preview = runner.preview("step42/sphere_uniform_q1.prm", "Geometry/Initial refinements=7")
    runner.compare("unknowns of a mesh that is not made", numbers(preview["First mesh"].split(";")[0])[1],
                   3 * (2 ** 7 + 1) ** 3, 0)
    seconds = time.monotonic() - begin
    runner.verify(f"said in {seconds:.1f} s", seconds < 3)


def curved_body(runner):
    """A cone that fills a conical pit: no horizontal section of it is a contact to expect, nor the area that it overlaps."""
    case = ("limit_load/conical_pit.prm", "Analysis=contact", "Material/Law=linear elastic", "Refinement/Strategy=none",
            "Refinement/Number of cycles=1", "Loading/History=1: depth 0.6 | 2: force 0", "Loading/Number of steps=40")
    runner.verify("no contact radius is expected", "Contact radius" not in runner.preview(*case))
    unloading, = runner.tables(*case)["indentation"]
    runner.compare("all of the pit is overlapped", unloading["tip_area"], math.pi, 1e-12)
    runner.compare("the contact area is that of the flank", unloading["contact_area"], math.pi / math.cos(math.pi / 6), 1e-6)
    runner.compare("contact begins at the bottom of the pit", unloading["contact_depth"],
                   unloading["max_depth"] - math.tan(math.pi / 6)
                   - (2 - 4 / math.pi) * unloading["max_force"] / unloading["stiffness"], 1e-6)
    runner.compare("hardness by the overlap", unloading["tip_hardness"], unloading["max_force"] / math.pi, 1e-12)

    # A node below the equator of the indenter, where its flank is vertical, is not reached.
    beside = ("cylinder_2d.prm", "Material/Law=linear elastic", "Indenter/Radius=1", "Loading/Depth=0.005",
              "Refinement/Strategy=none", "Refinement/Number of cycles=1", "Geometry/Local refinements=3",
              "Geometry/Local radius=0.5")
    normal, vertical = (runner.run(*beside, f"Contact/Geometry={geometry}")[-1] for geometry in ("normal", "vertical"))
    runner.compare("contact area, normal over vertical gap", normal["contact_area"] / vertical["contact_area"], 1, 0.02)
