# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of contact in one load step; see command."""

import math

from ..verification.equilibrium import QUADRATIC, depths_for_hardening
from ..verification.hertz import cylinder_peak, sphere_peak
from ..verification.indentation import at_time
from ..verification.runner import E_STAR
from ..verification.thick_sphere import INNER, outer_displacement
from .recipe import Content, count, decimals, percent, signed_percent, table

N_CYCLES = "Refinement/Number of cycles={}"
STRIP_PUNCH = "verification/strip_punch.prm"
STANDARD = "Discretization/Volumetric treatment=standard"


@table(3)
def sphere_3d(runs):
    """The default case on its last two meshes."""
    rows = runs.run("sphere_3d.prm")
    mean = rows[-1]["force"] / rows[-1]["contact_area"] / 400
    return Content([[count(row["dofs"]), *decimals(row, force=4, contact_area=5, max_pressure=1)] for row in rows[-2:]],
                   {"mean_pressure": f"{mean:.1f}"})


@table(2)
def cylinder_2d(runs):
    """A cylinder on a block, the last four meshes."""
    return Content([[count(row["dofs"]), *decimals(row, force=3, contact_area=3, max_pressure=1)]
                    for row in runs.run("cylinder_2d.prm")[-4:]])


@table(50)
def flat_punch(runs):
    """A strip punch on a perfectly plastic block: the force for elements of several kinds and sizes."""
    limit = (2 + math.pi) / math.sqrt(3)
    # the first mesh of the one case is coarser by one refinement than that of the other
    elements = {"B-bar": (STRIP_PUNCH, 1), "Q2": ("flat_punch_2d.prm", 0), "standard": (STRIP_PUNCH, 1, STANDARD)}
    rows, numbers = [], {}
    for name, (case, first, *entries) in elements.items():
        forces = [row["force"] for row in runs.run(case, N_CYCLES.format(4), *entries)][first:]
        cells = [f"{force:.4f} (+{percent(force / limit - 1)})" for force in forces]
        rows.append([None, *cells, *[""] * (4 - len(cells))])
        deeper = runs.run(case, N_CYCLES.format(3 + first), *entries, "Loading/Depth=0.16")[-1]["force"]
        numbers[f"growth_{name.replace('-', '_')}"] = percent(deeper / forces[2] - 1).removesuffix(" %")
    early = runs.run(STRIP_PUNCH, N_CYCLES.format(4), "Loading/Depth=0.03")[-1]
    return Content(rows, numbers | {"early": f"{early['force']:.3f}"})


@table(4)
def flat_punch_force(runs):
    """The same punch under a force of 84 % of the limit load: the depth for four sizes of elements."""
    rows = runs.run("flat_punch_force_2d.prm", N_CYCLES.format(4))
    return Content([[f"{row['depth']:.5f}" for row in rows]])


@table(240)
def rough_surface(runs):
    """A rough surface: force and area on the last two meshes."""
    rows = runs.run("rough_surface_3d.prm")
    return Content(numbers={"area": f"{100 * rows[-1]['contact_area']:.0f}", "coarse": f"{rows[-2]['force']:.2f}",
                            "fine": f"{rows[-1]['force']:.2f}"})


@table(5)
def johnson_mu(runs):
    """Johnson's way from hardening to perfect plasticity."""
    entries = (N_CYCLES.format(4), *QUADRATIC)
    limit = runs.run("johnson/perfect.prm", *entries)[-1]["depth"]
    depths = depths_for_hardening(runs, (1, 0.1, 0.01, 0.001, 0.0001), entries)
    return Content([[None, *(f"{depth:.4f}" for depth in (*depths, limit))],
                    [None, *(f"{limit - depth:.4f}" for depth in depths), ""]])


@table(2)
def johnson(runs):
    """Johnson's stationary problem in the plane."""
    return Content(numbers={name: f"{runs.run(f'johnson/{case}.prm')[-1]['depth']:.4f}" for name, case in
                            (("isotropic", "isotropic"), ("kinematic", "kinematic"), ("perfect", "perfect"))})


@table(20)
def johnson_space(runs):
    """Johnson's problem in space."""
    isotropic, kinematic = (runs.run(f"johnson/{law}_3d.prm") for law in ("isotropic", "kinematic"))
    perfect = runs.run("johnson/perfect_3d.prm")[-1]
    return Content([[count(row["dofs"]), f"{row['depth']:.4f}", f"{other['depth']:.4f}"]
                    for row, other in zip(isotropic, kinematic)],
                   {"perfect": f"{perfect['depth']:.4f}", "unknowns": count(perfect["dofs"])})


@table(2)
def material_tests(runs):
    """Plastic work per volume of a bar at the ends of three ways."""
    names = {"isotropic": "isotropic", "kinematic": "kinematic", "both": "combined"}
    return Content([[None, *(f"{at_time(steps, time)['plastic_work']:.4f}" for time in (1, 2, 3))] for steps in
                    (runs.history(f"material/uniaxial_{name}.prm") for name in names.values())])


@table(20)
def rolled_ring(runs):
    """The pressure at which a rolled ring collapses, on two meshes, and with axes that are the same everywhere."""
    def pressure(*entries):
        return f"{runs.history('material/rolled_ring.prm', *entries)[-1]['inner_x'] / 100:.2f}"

    return Content(numbers={"pressure": pressure(), "finer": pressure("Geometry/Initial refinements=2"),
                            "fixed_axes": pressure("Material/Axes=0")})


@table(20)
def step42_uniform(runs):
    """step-42's sphere on uniform meshes."""
    return Content([[count(row["dofs"]), *decimals(row, force=4), None]
                    for row in runs.run("step42/sphere_uniform_q1.prm", N_CYCLES.format(4))])


@table(20)
def step42_adaptive(runs):
    """step-42's sphere on adaptive meshes, linear elements."""
    return step42_meshes(runs, "adaptive_q1", 6)


@table(5)
def step42_quadratic(runs):
    """The same with quadratic elements."""
    return step42_meshes(runs, "adaptive_q2", 5)


@table(150)
def step42_finest(runs):
    """The same on a mesh of 1.8 million unknowns."""
    row = runs.run("step42/sphere_adaptive_q2.prm", N_CYCLES.format(7))[-1]
    return Content(numbers={"unknowns": count(row["dofs"]), "force": f"{row['force']:.4f}"})


def step42_meshes(runs, name, n_meshes):
    """Force and iterations on each mesh."""
    rows = runs.tables(f"step42/sphere_{name}.prm", N_CYCLES.format(n_meshes))["statistics"]
    return Content([[count(row["dofs"]), *decimals(row, force=4), count(row["newton_iterations"]),
                     count(row["linear_iterations"])] for row in rows])


@table(2)
def hertz_sphere(runs):
    """Hertz' point contact."""
    row = runs.run("verification/hertz_sphere.prm")[-1]
    area = math.pi / 4 * (3 * 4 * row["force"] * 10 / (4 * E_STAR)) ** (2 / 3)
    return Content([[None, f"{row['max_pressure']:.1f}", f"{sphere_peak(4 * row['force'], 10):.1f}"],
                    [None, f"{row['contact_area']:.4f}", f"{area:.4f}"]], {"unknowns": count(row["dofs"])})


@table(1)
def hertz_cylinder(runs):
    """Hertz' line contact."""
    row = runs.run("verification/hertz_cylinder.prm")[-1]
    return Content(numbers={"pressure": f"{row['max_pressure']:.2f}", "width": f"{row['contact_area']:.4f}",
                            "exact": f"{cylinder_peak(2 * row['force'], 10):.2f}"})


@table(3)
def elements_over_radius(runs):
    """Hertz' contact with few and many elements across the contact radius."""
    rows = [[None], [None], [None]]
    for refinements in range(2, 6):
        row = runs.run("verification/hertz_axisymmetric.prm", f"Geometry/Initial refinements={refinements}")[-1]
        peak, area = sphere_peak(row["force"], 1), math.pi * (3 * row["force"] / (4 * E_STAR)) ** (2 / 3)
        for cells, cell in zip(rows, (signed_percent(row["max_pressure"] / peak - 1),
                                      signed_percent(row["contact_area"] / area - 1), f"{row['depth']:.6f}")):
            cells.append(cell)
    return Content(rows)


@table(5)
def thick_sphere(runs):
    """A thick sphere under internal pressure."""
    columns = []
    for case, part, *entries in (("thick_sphere_axisymmetric", 1 / 2, "Discretization/Polynomial degree=2"),
                                 ("thick_sphere_axisymmetric", 1 / 2, "Discretization/Polynomial degree=1",
                                  "Discretization/Volumetric treatment=B-bar"), ("thick_sphere_3d", 1 / 8)):
        tables, fields = runs.tables_with_fields(f"verification/{case}.prm", "solution", *entries)
        volumes = [tables["history"][i]["plastic_volume"] / (4 / 3 * math.pi * part) for i in (0, 2)]
        columns.append([*(f"{outer_displacement(data):.7f}" for data in fields[1:]),
                        *(f"{(volume + INNER**3) ** (1 / 3):.3f}" for volume in volumes)])
    return Content([[None, None, *row] for row in zip(*columns)])
