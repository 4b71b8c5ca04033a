# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cases of verify: stresses in equilibrium, limit loads, guaranteed error bounds."""

import math

from .stress_distance import stress_distance
from .runner import E, E_STAR, NU

LAWS = ("linear elastic", "isotropic hardening", "perfectly plastic")
PRANDTL = 2 + math.pi
BOUND = "Analysis=contact with error bound"
# Where nothing flows, the side of a block can be held: it then bears what a large one does, the half plane under a strip punch.
HELD = ("Boundary conditions/Free=", "Boundary conditions/Fixed=bottom, right")
HELD_BLOCK = (*HELD, "Geometry/Lower corner=0, -2", "Geometry/Upper corner=4, 0", "Geometry/Repetitions=8, 4")
# Of cylinder_2d.prm: a first mesh that is fine where the stresses are large.
AROUND_CONTACT = ("Geometry/Initial refinements=3", "Geometry/Local refinements=3", "Geometry/Local radius=2")
# Of error_bound/sphere.prm, with which two uniform meshes show the order of convergence.
AROUND_SPHERE = ("Geometry/Initial refinements=2", "Geometry/Local refinements=4", "Geometry/Local radius=3")
QUADRATIC = ("Discretization/Polynomial degree=2", "Discretization/Volumetric treatment=standard")


def limit_load(runner):
    """Limit load of a strip punch between two bounds (exact), the same on any number of ranks."""
    case, held = "limit_load/strip_punch.prm", (*HELD_BLOCK, "Refinement/Refinement fraction=0.3")
    rows = runner.tables(case, *held, "Refinement/Number of cycles=4")["limit_load"]
    for row in rows:
        runner.verify(f"{row['lower_bound']:.6g} <= {PRANDTL:.6g} <= {row['upper_bound']:.6g}",
                      row["lower_bound"] <= PRANDTL <= row["upper_bound"])
    runner.compare("largest error of the stresses", max(row["stress_error"] for row in rows), 0,
                   1e-10, absolute=True)
    runner.compare("largest error of the velocities", max(row["velocity_error"] for row in rows), 0,
                   1e-9, absolute=True)
    runner.compare("lower bound", rows[-1]["lower_bound"], PRANDTL, 0.01)
    runner.compare("upper bound", rows[-1]["upper_bound"], PRANDTL, 0.01)
    two = "Refinement/Number of cycles=2"
    with runner.on_ranks(2 if runner.ranks == 1 else 1):
        other = runner.tables(case, *held, two)["limit_load"]
    runner.compare("lower bound on another number of ranks", other[-1]["lower_bound"], rows[1]["lower_bound"], 1e-9)

    curved = runner.tables(case, *held, two, "Indenter/Type=cylinder", "Indenter/Radius=3", "Indenter/Reach=1")["limit_load"]
    runner.compare("a cylinder that reaches as far", curved[-1]["lower_bound"], rows[1]["lower_bound"], 1e-6)
    small = runner.tables(case, "Refinement/Number of cycles=6", "Geometry/Lower corner=0, -5", "Geometry/Upper corner=5, 0",
                          "Geometry/Repetitions=5, 5")["limit_load"]
    runner.compare("block of 5 by 5 half-widths", small[-1]["lower_bound"], 4.2, 0.015)
    strip = runner.tables(case, "Refinement/Number of cycles=3", "Geometry/Lower corner=0, -1", "Geometry/Upper corner=10, 0",
                          "Geometry/Repetitions=10, 1", "Boundary conditions/Roller=left, bottom",
                          "Boundary conditions/Fixed=", "Geometry/Initial refinements=1")["limit_load"][-1]
    # both fields are exact
    for bound in ("lower_bound", "upper_bound"):
        runner.compare(f"strip of one half-width on a smooth base, {bound}", strip[bound], 2, 1e-5)


def limit_load_revolution(runner):
    """Limit loads of smooth and rough circular punches, of a ring, and of a cone in a pit, against strict bounds on finer meshes."""
    # A mechanism lifts as much weight as the pit would hold (Archimedes).
    buoyancy = 0.3 * math.tan(math.radians(30)) / 3
    held = (*HELD, "Refinement/Refinement fraction=0.3", "Geometry/Lower corner=0, -1.5", "Geometry/Upper corner=2.5, 0",
            "Geometry/Repetitions=5, 3")
    held_ring = (*HELD_BLOCK, "Refinement/Refinement fraction=0.2")
    cases = {"smooth circular punch": ("circular_punch", 4, 1, 3.0140, 3.0147, held),
             "rough circular punch": ("circular_punch", 4, 1, 3.1766, 3.189, (*held, "Indenter/Surface=rough")),
             "ring": ("ring_punch", 4, 3, 2.967, 2.977, held_ring),
             "cone in a pit, with weight": ("conical_pit", 4, 1, 2.6233 + buoyancy, 2.6307 + buoyancy, ("Body force=0; -0.3",))}
    for name, (case, n_cycles, area, lower, upper, entries) in cases.items():
        rows = runner.tables(f"limit_load/{case}.prm", f"Refinement/Number of cycles={n_cycles}", *entries)["limit_load"]
        for row in rows:
            below, above = (row[bound] / (area * math.pi) for bound in ("lower_bound", "upper_bound"))
            runner.verify(f"{name}: {below:.6g} <= limit load <= {above:.6g}", below <= upper and above >= lower)
        runner.compare(f"{name}: difference of the bounds", rows[-1]["relative_difference"], 0, 0.014, absolute=True)
        runner.compare(f"{name}: largest error of stresses and velocities",
                       max(max(row["stress_error"], row["velocity_error"]) for row in rows), 0, 1e-9, absolute=True)

    def of_ring(unit):
        """Both bounds on a coarse mesh, with all lengths in another unit."""
        row, = runner.tables("limit_load/ring_punch.prm", "Refinement/Number of cycles=1", "Geometry/Repetitions=5, 5",
                             f"Geometry/Lower corner=0, {-5 * unit!r}", f"Geometry/Upper corner={5 * unit!r}, 0",
                             f"Indenter/Half width={0.5 * unit!r}", f"Indenter/Position={1.5 * unit!r}")["limit_load"]
        return [row[bound] / unit**2 for bound in ("lower_bound", "upper_bound")]

    references = of_ring(1.)
    for unit in (1e-7, 1e6):
        for bound, value, reference in zip(("lower", "upper"), of_ring(unit), references):
            runner.compare(f"ring, lengths of {unit:g}: {bound} bound", value, reference, 1e-8)


def limit_load_space(runner):
    """Limit loads in space: a square punch against bounds on a finer mesh, a slab between rollers against (2 + pi) k (exact)."""
    case, limit = "limit_load/square_punch_3d.prm", (2.976, 3.088)  # 17,170 tetrahedra, another program
    # (What flows does not come to the sides, which can be held: the bounds are those of the larger block.)
    rows = runner.tables(case, "Refinement/Number of cycles=1", "Geometry/Lower corner=0, 0, -2", "Geometry/Upper corner=3, 3, 0",
                         "Geometry/Repetitions=3, 3, 2", "Boundary conditions/Free=",
                         "Boundary conditions/Fixed=bottom, right, back")["limit_load"]
    for row in rows:
        runner.verify(f"{row['lower_bound']:.6g} <= limit load <= {row['upper_bound']:.6g}",
                      row["lower_bound"] <= limit[1] and row["upper_bound"] >= limit[0])
    runner.compare("difference of the bounds", rows[-1]["relative_difference"], 0, 0.2, absolute=True)
    runner.compare("largest error of stresses and velocities",
                   max(max(row["stress_error"], row["velocity_error"]) for row in rows), 0, 1e-9, absolute=True)

    held = runner.tables(case, "Refinement/Number of cycles=3", "Refinement/Refinement fraction=0.3",
                         "Indenter/Type=strip punch", "Indenter/Half width=1", "Boundary conditions/Free=",
                         "Boundary conditions/Fixed=bottom, right", "Boundary conditions/Roller=left, front, back",
                         "Geometry/Lower corner=0, 0, -2", "Geometry/Upper corner=4, 1, 0",
                         "Geometry/Repetitions=4, 1, 2")["limit_load"]
    exact = PRANDTL / math.sqrt(3)
    for row in held:
        runner.verify(f"slab held at its sides: {row['lower_bound']:.6g} <= {exact:.6g} <= {row['upper_bound']:.6g}",
                      row["lower_bound"] <= exact <= row["upper_bound"])
    for earlier, later in zip(held, held[1:]):
        runner.verify("slab held at its sides: a finer mesh is closer", later["relative_difference"] < earlier["relative_difference"])
    runner.compare("slab held at its sides: difference of the bounds", held[-1]["relative_difference"], 0, 0.05, absolute=True)


def openblas_kernels():
    """Names of the plainest and the widest kernel of OpenBLAS that this processor can run; without it, they are ignored."""
    with open("/proc/cpuinfo", encoding="ascii") as file:
        flags = file.read().split()
    return ["Prescott", "SkylakeX" if "avx512f" in flags else "Haswell" if "avx2" in flags else "Nehalem"]


def blas_kernels(runner):
    """Bounds do not depend on the order in which a BLAS kernel adds up: rounding errors decide on none."""
    coarse = "Refinement/Number of cycles=1"
    layers = ("limit_load/two_layer_block.prm", *HELD_BLOCK)
    cases = {"two layers": (*layers, "Refinement/Number of cycles=3"),
             "two layers, edge of the punch inside a side": (*layers, coarse, "Indenter/Half width=0.83"),
             "footing on soil": ("limit_load/footing.prm", "Refinement/Number of cycles=2"),
             "sphere": ("error_bound/sphere.prm", coarse),
             "paraboloid in space": ("error_bound/paraboloid_3d.prm", coarse)}
    for name, case in cases.items():
        rows = {}
        for kernel in openblas_kernels():
            with runner.in_environment(OPENBLAS_CORETYPE=kernel):
                tables = runner.tables(*case)
            rows[kernel] = (tables.get("limit_load") or tables["error_bound"])[-1]
        first = next(iter(rows.values()))
        for kernel, row in rows.items():
            title = f"{name}, {kernel}: "
            if "lower_bound" in row:
                runner.verify(f"{title}{row['lower_bound']:.8g} <= {row['upper_bound']:.8g}",
                              row["lower_bound"] <= row["upper_bound"])
                runner.compare(title + "lower bound", row["lower_bound"], first["lower_bound"], 1e-6)
                runner.compare(title + "upper bound", row["upper_bound"], first["upper_bound"], 1e-6)
            else:
                runner.verify(f"{title}bound {row['bound']:.8g}", row["bound"] > 0)
                runner.compare(title + "complementary energy", row["complementary_energy"],
                               first["complementary_energy"], 1e-9)


def safe_load(runner):
    """A force of 0.995 times a lower bound of the limit load has an equilibrium.

    So has a small one after a depth that is a larger number than the limit load.
    """
    case, three = "limit_load/strip_punch.prm", "Refinement/Number of cycles=3"
    lower = runner.tables(case, *HELD_BLOCK, three, "Refinement/Refinement fraction=0.3")["limit_load"][-1]["lower_bound"]
    row = runner.run(case, *HELD_BLOCK, three, "Analysis=contact", "Loading/Control=force", f"Loading/Force={0.995 * lower}",
                     *QUADRATIC)[-1]
    runner.compare("force", row["force"], 0.995 * lower, 1e-9)
    runner.compare("forces on free nodes", row["residual"], 0, 1e-8, absolute=True)
    row = runner.run(case, "Analysis=contact", "Indenter/Initial gap=9.99",
                     "Loading/History=1: depth 10 | 2: force 1", "Loading/Number of steps=8",
                     "Refinement/Number of cycles=1")[-1]
    runner.compare("force after a depth", row["force"], 1, 1e-9)


def coarse_and_fine(runner, case, n_meshes, *entries):
    """Tables and fields of stresses in equilibrium on uniform meshes of linear elements, and those of finer meshes."""
    coarse = runner.tables_with_fields(case, "equilibrium", BOUND, *entries, "Refinement/Strategy=global",
                                       "Discretization/Polynomial degree=1", f"Refinement/Number of cycles={n_meshes}")
    fine = runner.tables_with_fields(case, "equilibrium", BOUND, *entries, "Refinement/Strategy=adaptive",
                                     f"Refinement/Number of cycles={n_meshes + 1}")
    return coarse, fine


def uniform_meshes(runner, law, n_meshes):
    """Rows of error_bound.csv, and that of a finer mesh.

    'distance' is that of the stresses from those on the finer mesh, in the norm of the energy.
    """
    (tables, fields), (fine_tables, fine_fields) = coarse_and_fine(
        runner, "cylinder_2d.prm", n_meshes, f"Material/Law={law}", "Geometry/Initial refinements=3")
    for row, field in zip(tables["error_bound"], fields):
        row["distance"] = stress_distance(field, fine_fields[-1], E, NU)
    return tables["error_bound"], fine_tables["error_bound"][-1]


def verify_energies(runner, law, rows, fine):
    """The bound is positive and above the errors of both energies.

    The least of the energy is between minus the complementary energy and the energy of any mesh.
    """
    runner.verify(f"{law}: positive", all(row["bound"] > 0 for row in rows))
    for row in rows:
        of_displacement = row["energy"] - fine["energy"]
        of_stress = row["complementary_energy"] - fine["complementary_energy"]
        larger = max(of_displacement, of_stress)
        runner.verify(f"errors {of_displacement:.3g} and {of_stress:.3g}, "
                      f"bound {row['bound']:.3g}, efficiency index {math.sqrt(row['bound'] / larger):.3f}",
                      0 < larger and min(of_displacement, of_stress) > -fine["bound"] and larger < row["bound"])


def error_bound(runner):
    """Uniform meshes: the bound is positive, above all errors, and of order h^2."""
    for law, n_meshes in zip(LAWS, (3, 2, 2)):  # (an elastic body reaches this order on finer meshes)
        rows, fine = uniform_meshes(runner, law, n_meshes)
        verify_energies(runner, law, rows, fine)
        for row in rows:
            largest = math.sqrt(2 * row["bound"])
            runner.verify(f"distance from finer stresses {row['distance']:.3g}, bound {largest:.3g}",
                          row["distance"] < largest)
        runner.compare("order of the bound", order(rows, "bound"), 2, 0.15)
        stress_order = order(rows, "distance")
        runner.verify(f"order of the stresses {stress_order:.2f}", stress_order > 0.5)


def error_bound_revolution(runner):
    """Bodies of revolution: the bound is above the errors and converges, the force is between its bounds; Hertz."""
    case = "error_bound/sphere.prm"
    plastic = ("Loading/Control=depth", "Loading/Depth=0.1", "Material/Yield stress=2000",
               "Material/Isotropic hardening modulus=10000", "Geometry/Local refinements=3")
    three = "Refinement/Number of cycles=3"
    for law, n_meshes, first_mesh, width in (
            (LAWS[0], 2, ("Geometry/Initial refinements=1", "Geometry/Local refinements=4"), 0.03),
            (LAWS[2], 2, AROUND_SPHERE, 0.09)):
        entries = (f"Material/Law={law}", *plastic)
        (tables, _), (fine, _) = coarse_and_fine(runner, case, n_meshes, *entries, *first_mesh)
        rows = tables["error_bound"]
        verify_energies(runner, law, rows, fine["error_bound"][-1])
        runner.compare("order of the bound", order(rows, "bound"), 2, 0.15)
        exact = runner.run(case, "Analysis=contact", *entries, "Refinement/Strategy=Kelly",
                           "Refinement/Number of cycles=7")[-1]["force"]
        rows = runner.tables(case, BOUND, *entries, three, "Refinement/Goal=force")["error_bound"]
        verify_interval(runner, f"{law}, force", rows, exact, width)
        runner.compare("largest error of the stresses", max(row["stress_error"] for row in rows), 0, 1e-9,
                       absolute=True)
    row = runner.tables(case, "Refinement/Number of cycles=1", "Geometry/Initial refinements=2",
                        "Geometry/Local refinements=8")["error_bound"][-1]
    radius, reach = 10, 0.2
    runner.compare("Hertz, largest pressure", row["equilibrium_max_pressure"], 2 * E_STAR * reach / (math.pi * radius),
                   0.005)
    runner.compare("Hertz, contact area", row["equilibrium_contact_area"], math.pi * reach**2, 0.01)


def error_bound_space(runner):
    """Error bounds in space: above the errors, of order h^2; force and depth between their bounds; plane strain."""
    case, three, two = "error_bound/paraboloid_3d.prm", "Refinement/Number of cycles=3", "Refinement/Number of cycles=2"
    adapted = runner.tables(case, three)["error_bound"]
    rows = runner.tables(case, two, "Refinement/Strategy=global", "Discretization/Polynomial degree=1")["error_bound"]
    verify_energies(runner, "linear elastic", rows, adapted[-1])
    runner.verify(f"order of the bound {order(rows, 'bound'):.2f}", order(rows, "bound") > 1.9)

    displacements = ("Analysis=contact", "Geometry/Initial refinements=3", "Refinement/Number of cycles=1")
    for law, width in ((LAWS[0], 0.24), (LAWS[2], 0.8)):
        entries = (f"Material/Law={law}",)
        force = runner.run(case, *entries, *displacements)[-1]["force"]
        rows = adapted if law == LAWS[0] else runner.tables(case, *entries, two, "Refinement/Goal=force")["error_bound"]
        verify_interval(runner, f"{law}, force", rows, force, width)
        runner.compare("largest error of the stresses", max(row["stress_error"] for row in rows), 0, 1e-9, absolute=True)
    by_force = ("Loading/Control=force", f"Loading/Force={adapted[-1]['force']}")
    rows = runner.tables(case, two, *by_force)["error_bound"]
    depth = runner.run(case, *displacements, *by_force)[-1]["depth"]
    verify_interval(runner, "linear elastic, depth", rows, depth, 0.35)

    thickness = 0.25
    cylinder = ("Indenter/Type=cylinder", "Geometry/Initial refinements=0")
    slab = runner.tables(case, *cylinder, two, f"Geometry/Upper corner=1, {thickness}, 0", "Geometry/Repetitions=4, 1, 4",
                         "Boundary conditions/Roller=left, front, back", "Boundary conditions/Free=right")
    section = runner.tables("error_bound/elastic_cylinder.prm", *cylinder, three, "Indenter/Radius=4", "Loading/Control=depth",
                            "Loading/Depth=0.05", "Geometry/Lower corner=0, -1", "Geometry/Upper corner=1, 0",
                            "Geometry/Repetitions=8, 8", "Geometry/Local refinements=0")["error_bound"][-1]
    for row in slab["error_bound"]:
        lower, upper = row["force_lower_bound"] / thickness, row["force_upper_bound"] / thickness
        runner.verify(f"slab: {lower:.6g} <= {section['force_upper_bound']:.6g}, {upper:.6g} >= {section['force_lower_bound']:.6g}",
                      lower <= section["force_upper_bound"] and upper >= section["force_lower_bound"])
    runner.compare("slab: force", row["equilibrium_force"] / thickness, section["equilibrium_force"], 0.002)


def verify_interval(runner, title, rows, exact, width):
    """The exact force or depth is between its bounds, whose last distance is not more than this part of it."""
    name = title.split()[-1]
    for row in rows:
        lower, upper = row[f"{name}_lower_bound"], row[f"{name}_upper_bound"]
        runner.verify(f"{title}: {lower:.6g} <= {exact:.6g} <= {upper:.6g}", lower <= exact <= upper)
    runner.verify(f"within {width:.0%}", upper - lower < width * exact)


def force_bounds(runner):
    """A cylinder: force or depth of a finer mesh between their bounds, which close in; depth without hardening."""
    case, depth = "cylinder_2d.prm", 0.01
    for law, names in zip(LAWS, (("force",), ("force",), ("force", "depth"))):
        entries = (f"Material/Law={law}", "Refinement/Strategy=adaptive", *AROUND_CONTACT)
        force = runner.run(case, *entries, f"Loading/Depth={depth}", "Refinement/Number of cycles=4")[-1]["force"]
        bounds = {"force": (force, 2, 0.12, (f"Loading/Depth={depth}", "Refinement/Goal=force")),
                  "depth": (depth, 2, 0.2, ("Loading/Control=force", f"Loading/Force={force}"))}
        for name in names:
            exact, n_cycles, width, loading = bounds[name]
            rows = runner.tables(case, BOUND, f"Refinement/Number of cycles={n_cycles}", *entries, *loading)["error_bound"]
            verify_interval(runner, f"{law}, {name}", rows, exact, width)


def order(rows, name):
    """Of convergence, from the last two uniform meshes."""
    return math.log2(rows[-2][name] / rows[-1][name])


def error_bound_refinement(runner):
    """A perfectly plastic body: refinement by the bound against that by Kelly's estimator, in the bound per unknown."""
    rows = {}
    for strategy in ("adaptive", "Kelly"):
        tables = runner.tables("cylinder_2d.prm", BOUND, "Material/Law=perfectly plastic",
                               f"Refinement/Strategy={strategy}", "Geometry/Initial refinements=3",
                               "Refinement/Number of cycles=5")
        rows[strategy] = tables["error_bound"][-1]
        runner.compare("estimated_error", tables["history"][-1]["estimated_error"],
                       math.sqrt(2 * rows[strategy]["bound"]), 1e-12)
    ratio = rows["Kelly"]["bound"] / rows["adaptive"]["bound"]
    runner.verify(f"{rows['adaptive']['dofs']:.0f} unknowns by the bound, "
                  f"{rows['Kelly']['dofs']:.0f} by Kelly, whose bound is {ratio:.2f} times as large",
                  rows["adaptive"]["dofs"] < rows["Kelly"]["dofs"] and ratio > 1.1)


def error_bound_ranks(runner):
    """Bounds and the meshes that they make are the same on 1 and 2 ranks."""
    for case, *entries in (("parabola", "Geometry/Initial refinements=0"), ("sphere",), ("paraboloid_3d",)):
        tables = []
        for ranks in (1, 2):
            with runner.on_ranks(ranks):
                tables.append(runner.tables(f"error_bound/{case}.prm", "Refinement/Number of cycles=2", *entries)["error_bound"])
        for alone, row in zip(*tables):
            runner.compare(f"{case}, triangles", row["triangles"], alone["triangles"], 0)
            runner.compare(f"{case}, bound", row["bound"], alone["bound"], 1e-9)


def equilibrium_hertz(runner):
    """Hertz' line contact by stresses in equilibrium: force control in plane strain (exact)."""
    row = runner.tables("verification/hertz_cylinder.prm", BOUND, "Geometry/Local refinements=8",
                        "Geometry/Local radius=8")["error_bound"][-1]
    half_width, radius = 0.2, 10
    runner.compare("peak pressure", row["equilibrium_max_pressure"], E_STAR * half_width / (2 * radius), 0.005)
    runner.compare("half-width", row["equilibrium_contact_area"], half_width, 0.02)
    runner.compare("depth", row["equilibrium_depth"], row["depth"], 1e-3)
    runner.compare("bound of the error, of the energy", row["relative_bound"], 0, 1e-3, absolute=True)


def depths_for_hardening(runner, values, entries):
    """Of the displacement method under Johnson's force, for values of his mu."""
    return [runner.run("johnson/isotropic.prm", *entries,
                       f"Material/Isotropic hardening modulus={1.5 * mu}")[-1]["depth"] for mu in values]


def equilibrium_limit(runner):
    """Johnson's mu to 0: the displacement method comes to the equilibrium method's solution."""
    entries = ("Refinement/Number of cycles=3", *QUADRATIC)
    row = runner.tables("johnson/perfect.prm", BOUND, *entries)["error_bound"][-1]
    missing = [abs(1 - depth / row["equilibrium_depth"])
               for depth in depths_for_hardening(runner, (1, 0.01, 0.0001), entries)]
    runner.verify("the difference of the depths falls: " + ", ".join(f"{value:.2%}" for value in missing),
                  all(a > b for a, b in zip(missing, missing[1:])))
    runner.compare("difference at mu = 0.0001", missing[-1], 0, 0.02, absolute=True)
