# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Verification of the deformed surface and of probes; see verify."""

import math

from .hertz import AXISYMMETRIC
from .runner import E, E_STAR, NU

ELASTIC = (*AXISYMMETRIC, "Material/Law=linear elastic")


def height_beside_sphere(r, a, radius):
    """The vertical displacement of the surface outside of Hertz' contact (Johnson 1985, (3.42b))."""
    return -((2 * a**2 - r**2) * math.asin(a / r) + a * math.sqrt(r**2 - a**2)) / (math.pi * radius)


def imprint(runner):
    """The surface beside Hertz' contact, its radius, and how far its edge sinks in (exact)."""
    tables = runner.tables(*ELASTIC)
    row, profile = tables["history"][-1], tables["surface_profile"]
    a = (3 * row["force"] / (4 * E_STAR)) ** (1 / 3)
    runner.compare("contact radius", row["contact_radius"], a, 0.005)
    runner.compare("sink-in of the edge", row["pile_up"], -a**2 / 2, 0.02)
    runner.verify("the profile begins at the axis and ends at the side",
                  profile[0]["x"] == 0 and profile[-1]["x"] == 8)
    # (the body is finite: it is softer by a uniform displacement)
    beside = [point for point in profile if 1.2 * a < point["x"] < 5 * a]
    shift = row["depth"] - a**2
    deviation = max(abs(point["displacement_y"] + shift - height_beside_sphere(point["x"], a, 1)) for point in beside)
    runner.compare(f"surface at {len(beside)} nodes beside the contact, over the depth",
                   deviation / row["depth"], 0, 0.002, absolute=True)
    within = [point for point in profile if point["x"] < 0.95 * a]
    runner.compare("largest gap in the contact, over the depth",
                   max(abs(point["gap"]) for point in within) / row["depth"], 0, 1e-9, absolute=True)


def largest_difference(rows, others):
    """Between two tables, relative to the largest number of a column."""
    if len(rows) != len(others) or not rows:
        return math.inf
    largest = 0.
    for column in rows[0]:
        scale = max(abs(row[column]) for row in rows) or 1.
        differences = [abs(a[column] - b[column]) for a, b in zip(rows, others) if not math.isnan(a[column])]
        largest = max([largest, *(difference / scale for difference in differences)])
    return largest


def imprint_ranks(runner):
    """Surface, radius, pile-up and probes of a body in space: the same on 1 and 3 ranks."""
    case = ("indentation/sphere_3d.prm", "Loading/History=1: depth 0.005 | 2: force 0", "Loading/Number of steps=4",
            "Refinement/Elements over contact radius=5", "Output/Profile lines=0, 0; 2, 0 | 0, 0; 0.3, 0.3", "Nonlinear solver/Tolerance=1e-12",
            "Output/Probe points=below: 0.01, 0.02, -0.05 | between: 0.5, 0.25, -0.5 | corner: 2, 2, 0")
    tables = []
    for n in (1, 3):
        with runner.on_ranks(n):
            tables.append(runner.tables(*case))
    for name, columns in (("surface_profile", ()), ("probes", ()), ("history", ("contact_radius", "pile_up"))):
        one, more = ([{key: row[key] for key in columns or row} for row in rows[name]] for rows in tables)
        runner.compare(f"{name} on 3 ranks", largest_difference(one, more), 0, 1e-6, absolute=True)
    profile = [point for point in tables[0]["surface_profile"] if point["step"] == 2]
    diagonal = [point for point in profile if point["line"] == 2]
    runner.verify(f"the diagonal has {len(diagonal)} points with x = y",
                  len(diagonal) > 10 and all(abs(point["x"] - point["y"]) < 1e-12 for point in diagonal))


def probes(runner):
    """Stress and strain at a point and between boundaries, displacement and stress control (exact)."""
    hardening, strain = 2000., 0.02
    stress = (400. + hardening * strain) * E / (E + hardening)
    lateral = -NU * stress / E - 0.5 * (strain - stress / E)
    for name, condition in (
            ("displacement", "Boundary conditions/Prescribed displacement=top: free; free; 0.02*t"),
            ("stress", f"Boundary conditions/Traction=top: 0; 0; {stress!r}*t")):
        row = runner.tables("verification/uniaxial_stress.prm", "Boundary conditions/Prescribed displacement=",
                            condition, "Output/Probe points=centre: 0.5, 0.5, 0.5 | edge: 1, 0.3, 1")["probes"][-1]
        runner.compare(f"{name} control: strain between the ends",
                       row["top_displacement_z"] - row["bottom_displacement_z"], strain, 1e-8)
        for point in ("centre", "edge"):
            for quantity, exact in (("strain_zz", strain), ("strain_xx", lateral), ("stress_zz", stress),
                                    ("equivalent_plastic_strain", strain - stress / E)):
                runner.compare(f"{name} control, {point}: {quantity}", row[f"{point}_{quantity}"], exact, 1e-8)
        runner.compare(f"{name} control: displacement of the edge", row["edge_displacement_x"], lateral, 1e-8)


def mean_strain_of_rings(runner):
    """A disc in tension along its axis: mean displacements are weighted with the area of the rings (exact)."""
    row = runner.tables("verification/uniaxial_stress.prm", "Dimension=2", "Kinematics=axisymmetric",
                        "Boundary conditions/Roller=left, bottom", "Boundary conditions/Free=right",
                        "Boundary conditions/Prescribed displacement=top: free; 0.001*t",
                        "Output/Probe points=rim: 1, 0.5")["probes"][-1]
    runner.verify("the axis has no mean displacement", "left_displacement_x" not in row)
    runner.compare("mean radial displacement of the end", row["top_displacement_x"], -NU * 0.001 * 2 / 3, 1e-8)
    for quantity in ("strain_xx", "strain_zz"):
        runner.compare(f"{quantity} at the rim", row[f"rim_{quantity}"], -NU * 0.001, 1e-8)
