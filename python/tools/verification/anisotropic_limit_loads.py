# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cases of verify: limit loads and error bounds of bodies that obey Hill's yield criterion."""

import math

from .equilibrium import AROUND_CONTACT, AROUND_SPHERE, BOUND, HELD_BLOCK, coarse_and_fine, order, verify_energies, verify_interval
from .yield_criteria import coefficients, hill

STRIP = "limit_load/strip_punch_rolled.prm"
YIELD = math.sqrt(3)  # of that case
BOUNDS = ("lower_bound", "upper_bound")
# For what holds on any mesh: a quarter of the elements of square_punch_3d.prm.
COARSE_IN_SPACE = ("Refinement/Number of cycles=1", "Geometry/Repetitions=4, 4, 1", "Geometry/Lower corner=0, 0, -1")


def half_axes(ratios):
    """Of the ellipse of ((s_11 - s_22) / 2, s_12) in plane strain: what s_33 admits at most, in units of sigma_Y."""
    f, g, h = coefficients(ratios)
    return 0.5 / math.sqrt(h + f * g / (f + g)), ratios[3] / math.sqrt(3)


def half_perimeter(a, b):
    """Of an ellipse, by the trapezoidal rule, exact to rounding for a periodic function."""
    n = 400
    return math.pi / n * sum(math.hypot(a * math.sin(angle), b * math.cos(angle)) for angle in (math.pi * i / n for i in range(n)))


def punch_pressure(ratios, degrees):
    """The pressure of a flat punch on a half plane by slip lines, in units of sigma_Y (Hill 1950, chapter XII).

    Along a slip line, the mean stress changes by the length of the way of ((s_x - s_y) / 2, s_xy) on the yield ellipse,
    which is turned by twice the angle of the axes. From the surface beside the punch to that under it, this is half of
    its perimeter, from the point (-X, 0) to (X, 0); the mean stress there is -X, and X less than the pressure."""
    a, b = half_axes(ratios)
    twice = math.radians(2 * degrees)
    x = 1 / math.hypot(math.cos(twice) / a, math.sin(twice) / b)
    return 2 * x + half_perimeter(a, b)


def verify_bounds(runner, name, limit, difference, case, *entries):
    """The bounds of all meshes are on both sides of a limit load, close on the last one, and the fields are admissible."""
    rows = runner.tables(case, *entries)["limit_load"]
    for row in rows:
        runner.verify(f"{name}: {row['lower_bound']:.7g} <= {limit:.7g} <= {row['upper_bound']:.7g}",
                      row["lower_bound"] <= (1 + 1e-9) * limit and row["upper_bound"] >= (1 - 1e-9) * limit)
    runner.compare(f"{name}: difference of the bounds", rows[-1]["relative_difference"], 0, difference, absolute=True)
    runner.compare(f"{name}: largest error of stresses and velocities",
                   max(max(row["stress_error"], row["velocity_error"]) for row in rows), 0, 1e-9, absolute=True)
    return rows


def hill_strip_punch(runner):
    """A strip punch on an orthotropic half-plane around the slip-line value, with axes along, across and oblique to the surface."""
    runner.compare("slip lines without anisotropy", punch_pressure((1,) * 6, 0) * YIELD, 2 + math.pi, 1e-12)
    half = (*HELD_BLOCK, "Refinement/Refinement fraction=0.2", "Refinement/Number of cycles=4")
    first = (*half, "Refinement/Number of cycles=1")
    stiff_in_shear, all_ratios = (1.0, 1.0, 1.0, 1.25, 1.0, 1.0), (1.0, 1.2, 0.9, 0.7, 1.0, 1.0)
    known = {}
    for ratios in ((1.0, 1.0, 1.0, 0.8, 1.0, 1.0), stiff_in_shear, all_ratios):
        known[ratios] = verify_bounds(runner, f"{ratios[:4]}, axes at 0 degrees", punch_pressure(ratios, 0) * YIELD, 0.016, STRIP,
                                      *half, *hill(ratios, "0"))[0]
    # Turned by 45 degrees, shear and difference of the normal stresses change places; by 90 degrees, each remains what it is.
    # (Each program is solved to 1e-6.)
    for ratios, degrees, factor, other in (((1.0, 1.0, 1.0, 0.8, 1.0, 1.0), 45, 0.8, stiff_in_shear), (all_ratios, 90, 1, all_ratios)):
        runner.compare(f"{ratios[:4]}, axes at {degrees} degrees, pressure of slip lines", punch_pressure(ratios, degrees),
                       factor * punch_pressure(other, 0), 1e-12)
        turned, = runner.tables(STRIP, *first, *hill(ratios, f"{degrees}"))["limit_load"]
        for bound in BOUNDS:
            runner.compare(f"{ratios[:4]}, axes at {degrees} degrees, {bound}", turned[bound], factor * known[other][bound], 1e-6)
    # (Of the whole body, as the mirror image of such a material is another one.)
    whole = ("Geometry/Lower corner=-4, -2", "Geometry/Repetitions=16, 4", "Boundary conditions/Roller=",
             "Boundary conditions/Fixed=bottom, left, right")
    oblique = verify_bounds(runner, f"{all_ratios[:4]}, axes at 30 degrees", 2 * punch_pressure(all_ratios, 30) * YIELD, 0.016, STRIP,
                            *half, *whole, *hill(all_ratios, "30"))
    mirrored = runner.tables(STRIP, *first, *whole, *hill(all_ratios, "-30"))["limit_load"]
    for bound in BOUNDS:
        runner.compare(f"mirror image, {bound}", mirrored[0][bound], oblique[0][bound], 1e-9)


def hill_and_von_mises(runner):
    """With ratios of 1, the bounds are those of von Mises' criterion; axes that are turned with the ratios change nothing."""
    first_mesh, two_meshes = ((f"Refinement/Number of cycles={n}",) for n in (1, 2))
    for case, entries in (("strip_punch", (*HELD_BLOCK, *two_meshes)), ("circular_punch", two_meshes), ("plate_with_hole", first_mesh),
                          ("square_punch_3d", COARSE_IN_SPACE)):
        plain, ones = (runner.tables(f"limit_load/{case}.prm", *entries, *criterion)["limit_load"][-1]
                       for criterion in ((), hill((1.0,) * 6, "20")))
        for bound in BOUNDS:  # (in space, mechanisms of the first mesh are solved to 1e-3: rounding errors then leave more)
            runner.compare(f"{case}, ratios of 1, {bound}", ones[bound], plain[bound],
                           1e-6 if (case, bound) == ("square_punch_3d", "upper_bound") else 1e-9)
    here, there = (0.9, 1.1, 1.05, 0.8, 0.95, 1.2), (1.1, 0.9, 1.05, 0.8, 1.2, 0.95)
    for case, entries in ((STRIP, (*HELD_BLOCK, "Refinement/Number of cycles=1")), ("limit_load/square_punch_3d.prm", COARSE_IN_SPACE)):
        one, other = (runner.tables(case, *entries, *hill(ratios, axes))["limit_load"][-1]
                      for ratios, axes in ((here, "0"), (there, "90")))
        for bound in BOUNDS:
            runner.compare(f"{case}, turned axes, {bound}", other[bound], one[bound], 1e-6)


def hill_bodies(runner):
    """A bar in plane stress, a cube in shear, a tube and a cylinder in revolution with Hill's criterion: exact limit loads."""
    ratios = (0.9, 1.1, 1.05, 0.8, 0.95, 1.2)
    bar = ("limit_load/strip_punch_rolled.prm", "Kinematics=plane stress", "Geometry/Lower corner=0, 0", "Geometry/Upper corner=1, 2",
           "Geometry/Repetitions=2, 4", "Boundary conditions/Roller=left, bottom", "Boundary conditions/Fixed=",
           "Boundary conditions/Free=right", "Boundary conditions/Contact=", "Boundary conditions/Traction=top: 0; t",
           "Indenter/Type=none", "Limit load/Load=tractions", "Refinement/Number of cycles=1", "Material/Yield stress=1")
    between = (1.0, 1.0, 1.1, 0.9, 1.0, 1.0)  # as strong along 1 as along 2: tension between them causes no shear
    f, g, _ = coefficients(between)
    exact = {"along 1": (ratios, "90", ratios[0]), "along 2": (ratios, "0", ratios[1]), "along 3": (ratios, "0 | 90 | 0", ratios[2]),
             "at 45 degrees": (between, "45", 2 / math.sqrt(f + g + 3 / between[3]**2))}
    for name, (of_bar, axes, limit) in exact.items():
        verify_bounds(runner, f"bar {name}", limit, 1e-6, *bar, *hill(of_bar, axes))

    cube = ("limit_load/square_punch_3d.prm", "Geometry/Lower corner=0, 0, 0", "Geometry/Upper corner=1, 1, 1",
            "Geometry/Repetitions=1, 1, 1", "Boundary conditions/Roller=", "Boundary conditions/Free=front, back",
            "Boundary conditions/Fixed=bottom", "Boundary conditions/Contact=",
            "Boundary conditions/Traction=top: t; 0; 0 | right: 0; 0; t | left: 0; 0; -t", "Indenter/Type=none",
            "Limit load/Load=tractions", "Refinement/Number of cycles=1", "Material/Yield stress=1")
    for axes, ratio in (("0", ratios[4]), ("90", ratios[5]), ("0 | 90 | 0", ratios[3])):
        # (In space, the first mesh is solved up to a relative gap of 1e-3 of each bound.)
        verify_bounds(runner, f"cube in shear, axes {axes}", ratio / math.sqrt(3), 3e-4, *cube, *hill(ratios, axes))

    f, g, h = coefficients(ratios)
    tube = ("limit_load/circular_punch.prm", "Geometry/Lower corner=1, 0", "Geometry/Upper corner=2, 0.25",
            "Geometry/Repetitions=16, 4", "Boundary conditions/Roller=bottom, top", "Boundary conditions/Fixed=",
            "Boundary conditions/Free=right", "Boundary conditions/Contact=", "Boundary conditions/Traction=left: t; 0",
            "Indenter/Type=none", "Limit load/Load=tractions", "Refinement/Number of cycles=1")
    verify_bounds(runner, "tube under pressure", math.log(2) / math.sqrt(g + f * h / (f + h)), 1.5e-4, *tube, *hill(ratios))
    cylinder = ("limit_load/circular_punch.prm", "Geometry/Lower corner=0, 0", "Geometry/Upper corner=1, 1",
                "Geometry/Repetitions=4, 4", "Boundary conditions/Roller=left, bottom", "Boundary conditions/Fixed=",
                "Indenter/Radius=2", "Refinement/Number of cycles=1")
    isotropic_across = (1.0, 1.2, 1.0, 0.8, 1.0, 0.8)
    verify_bounds(runner, "cylinder between plates", 1.2 * math.pi, 1e-6, *cylinder, *hill(isotropic_across))


def hill_layers(runner):
    """Two materials of Hill's and one of von Mises' in one body: layers that are the same, and the weaker and stronger alone."""
    case = "limit_load/two_layer_block.prm"
    one_mesh = (*HELD_BLOCK, "Refinement/Number of cycles=1")
    same_yield = (*one_mesh, f"Material/Yield stress={YIELD}, {YIELD}")
    weak, strong = "1 | 1 | 1 | 0.7 | 1 | 1", "1.2 | 1.2 | 1.2 | 1.2 | 1.2 | 1.2"

    def bounds(criteria, first, second):
        return runner.tables(case, *same_yield, f"Material/Yield criterion={criteria}", f"Material/Hill ratios={first}, {second}",
                             "Material/Axes=0, 0")["limit_load"][-1]

    soft, hard, both, with_metal = (bounds("Hill, Hill", weak, weak), bounds("Hill, Hill", strong, strong),
                                    bounds("Hill, Hill", weak, strong), bounds("Hill, von Mises", weak, strong))
    one = runner.tables(case, *same_yield, "Material/Yield criterion=Hill", f"Material/Hill ratios={weak}", "Material/Axes=0")["limit_load"][-1]
    metal = runner.tables(case, *one_mesh)["limit_load"][-1]
    beside = runner.tables(case, *one_mesh, "Material/Yield criterion=von Mises, Hill")["limit_load"][-1]
    for bound in BOUNDS:
        runner.compare(f"both layers weak, {bound}", soft[bound], one[bound], 1e-9)
        runner.compare(f"von Mises beside a layer with ratios of 1, {bound}", beside[bound], metal[bound], 1e-9)
        for name, row in (("weak on strong", both), ("weak on von Mises", with_metal)):
            runner.verify(f"{name}, {bound}: {soft[bound]:.6g} <= {row[bound]:.6g} <= {hard[bound]:.6g}",
                          soft[bound] < row[bound] < hard[bound])
    for name, row in (("weak on strong", both), ("weak on von Mises", with_metal)):
        runner.compare(f"{name}: difference of the bounds", row["relative_difference"], 0, 0.1, absolute=True)


def hill_error_bound(runner):
    """Error bounds with Hill's criterion: above the errors, of order h^2, the force between them; ratios of 1, turned axes."""
    cylinder, sphere = "cylinder_2d.prm", "error_bound/sphere.prm"
    of_sphere = ("Loading/Control=depth", "Loading/Depth=0.1", "Material/Yield stress=2000", "Geometry/Local refinements=3")
    film = hill((1.0, 1.2, 1.0, 0.8, 1.0, 0.8))  # the same in all directions across the axis
    # (The first meshes are fine where the stresses are large.)
    for case, law, body, first_mesh, n_meshes, adapted, width in (
            (cylinder, "isotropic hardening", hill((1.0, 1.2, 0.9, 0.7, 1.0, 1.0)),
             (*AROUND_CONTACT, "Geometry/Local refinements=2", "Geometry/Local radius=1"), 2,
             (*AROUND_CONTACT, "Refinement/Number of cycles=2"), 0.1),
            (sphere, "perfectly plastic", (*of_sphere, *film), AROUND_SPHERE, 2,
             ("Refinement/Number of cycles=3",), 0.1)):
        entries = (f"Material/Law={law}", *body)
        title = f"{case}, {law}"
        (tables, _), (finer, _) = coarse_and_fine(runner, case, n_meshes, *entries, *first_mesh)
        rows, fine = tables["error_bound"], finer["error_bound"][-1]
        verify_energies(runner, title, rows, fine)
        runner.compare(f"{title}, order of the bound", order(rows, "bound"), 2, 0.15)
        runner.compare(f"{title}, largest error of the stresses", max(row["stress_error"] for row in rows), 0, 1e-9, absolute=True)
        rows = runner.tables(case, BOUND, *entries, *adapted, "Refinement/Strategy=adaptive", "Refinement/Goal=force")["error_bound"]
        verify_interval(runner, f"{title}, force", rows, fine["force"], width)
    one_mesh = (BOUND, "Refinement/Number of cycles=1", "Geometry/Initial refinements=3", "Material/Law=perfectly plastic")
    for name, first, other in (
            ("ratios of 1", (), hill((1.0,) * 6, "20")),
            ("turned axes", hill((1.0, 1.2, 0.9, 0.7, 1.0, 0.8), "90"), hill((1.2, 1.0, 0.9, 0.7, 0.8, 1.0)))):
        one, two = (runner.tables(cylinder, *one_mesh, *criterion)["error_bound"][-1] for criterion in (first, other))
        for column in ("energy", "complementary_energy", "bound"):
            runner.compare(f"{name}, {column}", two[column], one[column], 1e-9)
