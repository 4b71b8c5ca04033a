# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of limit loads between two bounds; see command."""

import math

from .recipe import Content, count, measured_table, percent, table

N_CYCLES = "Refinement/Number of cycles={}"


def bounds(row, unit=1.0, digits=4):
    """The cells of both bounds, over a unit of force."""
    return [f"{row[name] / unit:.{digits}f}" for name in ("lower_bound", "upper_bound")]


def meshes(rows, unit):
    """A row of the table for each mesh: triangles, bounds, difference."""
    return [[count(row["triangles"]), *bounds(row, unit), percent(row["relative_difference"])] for row in rows]


@table(150)
def strip_punch_bounds(runs):
    """The limit load of a strip punch, every second mesh."""
    return Content(meshes(runs.limit_load("strip_punch", N_CYCLES.format(11))[::2], 1))


@table(150)
def strip_punch_variants(runs):
    """The same punch on other bodies."""
    block = ("Geometry/Lower corner=0, -5", "Geometry/Upper corner=5, 0", "Geometry/Repetitions=5, 5")
    variants = {"block": ("strip_punch", *block), "plane_stress": ("strip_punch", "Kinematics=plane stress"),
                "thin_layer": ("two_layer_block",),
                "thick_layer": ("two_layer_block", "Geometry/Material id=if(y > -1, 0, 1)")}
    numbers = {}
    for name, case in variants.items():
        lower, upper = bounds(runs.limit_load(*case)[-1], digits=4 if name == "plane_stress" else 3)
        numbers |= {f"{name}_lower": lower, f"{name}_upper": upper}
    return Content(numbers=numbers)


@table(150)
def rolled_strip_punch(runs):
    """A strip punch on rolled metal, its axes along and at 45 degrees to the surface: every second mesh."""
    along, between = (meshes(runs.limit_load("strip_punch_rolled", f"Material/Axes={axes}"), 1) for axes in ("0", "45"))
    return Content([first + second for first, second in zip(along[::2], between[::2])])


CIRCULAR_PUNCH_IN_SPACE = ("circular_punch_3d", math.pi / 4, 4, N_CYCLES.format(6))


@table(700)
def limit_load_benchmarks(runs):
    """Limit loads of several bodies, most of them with the cases' own meshes."""
    strain, stress = "Kinematics=plane strain", "Kinematics=plane stress"
    problems = (("strip_punch", 1, 4, N_CYCLES.format(11)), ("circular_punch", math.pi, 4), CIRCULAR_PUNCH_IN_SPACE,
                ("ring_punch", 3 * math.pi, 4), ("vertical_cut", 1, 4), ("plate_with_hole", 1, 5),
                ("notched_bar", 1, 5, strain), ("notched_bar", 1, 5, stress), ("notched_bar", 1, 5))
    rows = []
    for case, unit, digits, *entries in problems:
        row = runs.limit_load(case, *entries)[-1]
        rows.append([None, None, *bounds(row, unit, digits), count(row["triangles"]), None])
    section = [f"{4 * value:.3f}" for value in (row["lower_bound"], row["upper_bound"])]
    return Content(rows, dict(zip(("notch_lower", "notch_upper"), section)))


@table(400)
def circular_punch(runs):
    """Smooth and rough circular punch, some of the meshes and the last one."""
    smooth = meshes(runs.limit_load("circular_punch"), math.pi)
    rough = meshes(runs.limit_load("circular_punch", N_CYCLES.format(9), "Indenter/Surface=rough"), math.pi)
    return Content([smooth[n] + rough[n] for n in (0, 4, 6, 8)] + [smooth[-1] + [""] * 4])


@table(60)
def conical_pit(runs):
    """A cone in a pit whose flanks fall by 30 degrees; that of 10 degrees has another mesh, made by Gmsh."""
    row, = meshes(runs.limit_load("conical_pit", "Limit load/Stresses=linear")[-1:], math.pi)
    return Content([[None] * 5, [None, *row]])


@table(2400)
def square_punch(runs):
    """Smooth and rough square punch in space (11 GB)."""
    smooth, rough = (meshes(runs.limit_load("square_punch_3d", N_CYCLES.format(7), f"Indenter/Surface={surface}"), 1)
                     for surface in ("smooth", "rough"))
    return Content([left + right for left, right in zip(smooth, rough)])


@table(300)
def circular_punch_in_space(runs):
    """A circular punch in space, on a quarter of a block (3 GB)."""
    case, unit, _, *entries = CIRCULAR_PUNCH_IN_SPACE
    return Content(meshes(runs.limit_load(case, *entries), unit))


# Of the table: case, and numbers of cycles with linear and with quadratic stresses.
DEGREES = (("circular_punch", 9, 8), ("circular_punch", 11, 10), ("strip_punch", 8, 6), ("strip_punch", None, 7),
           ("strip_punch", None, 8), ("vertical_cut", 7, 6), ("plate_with_hole", 3, 3))


@measured_table(250)
def degrees_of_stresses(runs):
    """Time and difference of the bounds with linear and with quadratic stresses."""
    rows = []
    for case, *numbers in DEGREES:
        cells = []
        for degree, n_cycles in zip(("linear", "quadratic"), numbers):
            if n_cycles is None:
                cells += [""] * 3
                continue
            tables, time = runs.timed(f"limit_load/{case}.prm", f"Limit load/Stresses={degree}", N_CYCLES.format(n_cycles))
            row = tables["limit_load"][-1]
            cells += [f"{n_cycles}, {count(row['triangles'])}", f"{time:.1f} s", percent(row["relative_difference"])]
        rows.append([None, *cells])
    return Content(rows)


# Of the table: case, number of cycles with one pass, and with three and this refinement fraction.
PASSES = (("circular_punch", 11, 5, 0.4), ("strip_punch", 11, 5, 0.4), ("vertical_cut", 11, 5, 0.4),
          ("square_punch_3d", 4, 3, 0.2))


@measured_table(400)
def refinement_passes(runs):
    """Time and difference of the bounds with one pass of refinement from mesh to mesh, and with three."""
    rows = []
    for case, *numbers, fraction in PASSES:
        cells = []
        three = ("Refinement/Passes=3", f"Refinement/Refinement fraction={fraction}")
        for entries, n_cycles in zip(((), three), numbers):
            tables, time = runs.timed(f"limit_load/{case}.prm", *entries, N_CYCLES.format(n_cycles))
            row = tables["limit_load"][-1]
            cells += [f"{n_cycles}, {count(row['triangles'])}", f"{time:.1f} s", percent(row["relative_difference"])]
        rows.append([None, *cells])
    return Content(rows)


def last_mesh(runs, case, n_cycles, *entries):
    """Two cells for words and exact values, and those of the last mesh."""
    return [None, None] + meshes(runs.limit_load(case, N_CYCLES.format(n_cycles), *entries)[-1:], 1)[0]


@table(900)
def footings(runs):
    """Footings on weightless ground, the last meshes."""
    return Content([last_mesh(runs, "footing", n, f"Material/Friction angle={degrees}")
                    for degrees, n in ((10, 7), (20, 7), (30, 8))])


@table(1200)
def surcharges(runs):
    """A surcharge beside a footing, with hardly any cohesion and with some, the last meshes."""
    return Content([last_mesh(runs, "footing_surcharge", 8),
                    last_mesh(runs, "footing_surcharge", 9, "Indenter/Surface=rough"),
                    last_mesh(runs, "footing_surcharge", 8, "Material/Cohesion=1")])


@table(400)
def circular_footings(runs):
    """Circular footings on weightless ground in revolution, over the area, the last meshes."""
    return Content([[None, None] + meshes(runs.limit_load("footing_circular", f"Material/Friction angle={degrees}",
                                                          f"Indenter/Surface={surface}")[-1:], math.pi)[0]
                    for degrees in (10, 20, 30) for surface in ("smooth", "rough")])


@table(400)
def square_footings(runs):
    """Square footings on weightless ground in space, the third meshes."""
    return Content([last_mesh(runs, "footing_square", 3, f"Material/Friction angle={degrees}", f"Indenter/Surface={surface}")
                    for degrees, surface in ((10, "rough"), (20, "smooth"), (20, "rough"), (30, "rough"))])


@table(400)
def layers_of_ground(runs):
    """A footing on two layers, the last meshes."""
    return Content([last_mesh(runs, "footing_layers", 6, f"Geometry/Material id={layers}")
                    for layers in ("if(y > -1.5, 0, 1)", "if(y > -0.5, 0, 1)", "if(y > -0.5, 1, 0)")])


@table(80)
def little_friction(runs):
    """Footings on ground with a tenth of a degree, a strip and a circular one, and on clay above sand: the last meshes."""
    numbers = {}
    for name, case, unit, entry in (("strip", "footing", 1, "0.1"), ("clay", "footing_layers", 1, "0, 30"),
                                    ("circle", "footing_circular", math.pi, "0.1")):
        row = runs.limit_load(case, f"Material/Friction angle={entry}")[-1]
        lower, upper = bounds(row, unit)
        numbers |= {f"{name}_lower": lower, f"{name}_upper": upper, f"{name}_triangles": count(row["triangles"]),
                    f"{name}_difference": percent(row["relative_difference"], 2).removesuffix(" %")}
    return Content(numbers=numbers)


@table(900)
def heavy_ground(runs):
    """A footing on heavy ground and a vertical cut, the last meshes."""
    return Content([last_mesh(runs, "footing_weight", 10, "Indenter/Surface=smooth"),
                    last_mesh(runs, "footing_weight", 10),
                    last_mesh(runs, "vertical_cut_friction", 9)])
