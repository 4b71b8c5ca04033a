# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of guaranteed error bounds; see command."""

import math

from ..verification.equilibrium import (BOUND, LAWS, QUADRATIC, coarse_and_fine, depths_for_hardening, order,
                                        uniform_meshes)
from .recipe import Content, count, decimals, percent, power, table

PARABOLA = "error_bound/parabola.prm"
N_CYCLES = "Refinement/Number of cycles={}"
# A sphere pressed to a depth into a body of revolution that yields.
PRESSED = ("Loading/Control=depth", "Loading/Depth=0.1", "Material/Yield stress=2000",
           "Material/Isotropic hardening modulus=10000", "Geometry/Local refinements=3")


@table(150)
def parabola(runs):
    """A parabola under 80 % of its limit load, and under other parts of it."""
    rows = runs.tables(PARABOLA)["error_bound"]
    low, high = (runs.tables(PARABOLA, f"Loading/Force={force}")["error_bound"][-1] for force in (1.1314, 2.8001))
    return Content([[count(row["dofs"]), count(row["triangles"]), *decimals(row, depth=4, equilibrium_depth=4),
                     percent(row["relative_bound"])] for row in rows],
                   {"low": percent(low["relative_bound"]).removesuffix(" %"),
                    "high": percent(high["relative_bound"]).removesuffix(" %"), "high_depth": f"{high['depth']:.1f}"})


@table(30)
def residual_stress_bounds(runs):
    """Bounds of the depth of a paraboloid on a body with residual stress."""
    row = runs.tables("error_bound/residual_stress.prm")["error_bound"][-1]
    return Content(numbers={"triangles": count(row["triangles"]), "lower": f"{row['depth_lower_bound']:.5f}",
                            "upper": f"{row['depth_upper_bound']:.5f}"})


@table(55)
def efficiency(runs):
    """The efficiency index and the orders of the bound on uniform meshes, in plane strain and of revolution."""
    numbers = {}
    for body in ("plane", "revolution"):
        indices = []
        for law in LAWS:
            if body == "plane":
                rows, fine = uniform_meshes(runs, law, 3)
            else:
                entries = (f"Material/Law={law}", *PRESSED, "Geometry/Initial refinements=2")
                (tables, _), (fine_tables, _) = coarse_and_fine(runs, "error_bound/sphere.prm", 3, *entries)
                rows, fine = tables["error_bound"], fine_tables["error_bound"][-1]
            errors = [max(row[name] - fine[name] for name in ("energy", "complementary_energy")) for row in rows]
            indices += [math.sqrt(row["bound"] / error) for row, error in zip(rows, errors)]
            numbers[f"{body}_{law.split()[0]}"] = f"{order(rows, 'bound'):.2f}"
        numbers |= {f"{body}_least": f"{min(indices):.2f}", f"{body}_most": f"{max(indices):.2f}"}
    return Content(numbers=numbers)


@table(150)
def against_kelly(runs):
    """Refinement by the bound against Kelly's estimator."""
    rows, last = [], {}
    for law in LAWS:
        cells = [None]
        for strategy in ("adaptive", "Kelly"):
            entries = (f"Material/Law={law}", f"Refinement/Strategy={strategy}", "Geometry/Initial refinements=3")
            row = runs.tables("cylinder_2d.prm", BOUND, *entries, N_CYCLES.format(6))["error_bound"][-1]
            last[law, strategy] = row
            cells += [count(row["dofs"]), power(row["bound"], 3)]
        rows.append(cells)
    hardening, kelly = last[LAWS[1], "adaptive"], last[LAWS[1], "Kelly"]
    force, other = (row["force"] for row in (hardening, kelly))
    return Content(rows, {"energy": f"{hardening['energy']:.4f}", "energy_of_kelly": f"{kelly['energy']:.4f}",
                          "least_energy": f"{-hardening['complementary_energy']:.4f}",
                          "force": f"{100 * abs(force / other - 1):.3f}"})


@table(80)
def hertz_equilibrium(runs):
    """Hertz' line and point contact by stresses in equilibrium."""
    line = runs.tables("error_bound/elastic_cylinder.prm")["error_bound"][-1]
    point = runs.tables("error_bound/sphere.prm")["error_bound"][-1]
    return Content(numbers={name: value for prefix, row in (("line", line), ("point", point)) for name, value in (
        (f"{prefix}_pressure", f"{row['equilibrium_max_pressure']:.2f}"),
        (f"{prefix}_energy", power(row["relative_bound"], 2)),
        (f"{prefix}_area", f"{row['equilibrium_contact_area']:.4f}"))})


@table(25)
def johnson_equilibrium(runs):
    """By how much the depth under hardening differs from that of the equilibrium method."""
    entries, values = (N_CYCLES.format(4), *QUADRATIC), (1, 0.1, 0.01, 0.001, 0.0001)
    depth = runs.tables("johnson/perfect.prm", BOUND, *entries)["error_bound"][-1]["equilibrium_depth"]
    differences = [percent(abs(1 - other / depth)) for other in depths_for_hardening(runs, values, entries)]
    return Content([[None, *differences]], {"depth": f"{depth:.4f}"})


def force_cells(row):
    """Triangles, the force between its bounds, and their difference."""
    lower, force, upper = (row[name] for name in ("force_lower_bound", "force", "force_upper_bound"))
    return count(row["triangles"]), (lower, force, upper), percent((upper - lower) / force)


@table(200)
def cylinder_force_bounds(runs):
    """The force of a cylinder between its bounds, the last four of six meshes."""
    rows = []
    for row in runs.tables("cylinder_2d.prm", BOUND, "Loading/Depth=0.01", "Refinement/Strategy=adaptive",
                           "Refinement/Goal=force")["error_bound"][-4:]:
        triangles, (lower, force, upper), difference = force_cells(row)
        rows.append([count(row["dofs"]), triangles, f"{lower:.1f}", f"{force:.2f}", f"{upper:.1f}", difference])
    return Content(rows)


@table(400)
def sphere_force_bounds(runs):
    """The force of a sphere on a body of revolution between its bounds."""
    rows = []
    for law in LAWS:
        row = runs.tables("error_bound/sphere.prm", f"Material/Law={law}", *PRESSED, "Refinement/Goal=force",
                          N_CYCLES.format(6))["error_bound"][-1]
        triangles, forces, difference = force_cells(row)
        rows.append([None, triangles, *(f"{force:.1f}" for force in forces), difference])
    return Content(rows)


@table(600)
def paraboloid_in_space(runs):
    """A paraboloid on a block in space: forces, their bounds, and the bound of the energies."""
    rows = []
    for law in LAWS:
        tables = runs.tables("error_bound/paraboloid_3d.prm", f"Material/Law={law}", N_CYCLES.format(4))["error_bound"]
        for row in tables if law == LAWS[0] else tables[-1:]:
            lower, upper = (f"{row[f'force_{side}_bound']:.0f}" for side in ("lower", "upper"))
            rows.append([None, count(row["dofs"]), count(row["triangles"]), *decimals(row, force=1, equilibrium_force=1),
                         f"{lower} and {upper}", percent(row["relative_bound"])])
    return Content(rows)
