# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Verification: other yield criteria than that of von Mises; see verify."""

import math

from .runner import E, EULER, NU

YIELD = 400.0
PERFECT = ("Material/Law=perfectly plastic", f"Material/Yield stress={YIELD}")


def hill(ratios, axes="0"):
    return ("Material/Yield criterion=Hill", "Material/Hill ratios=" + " | ".join(f"{ratio!r}" for ratio in ratios),
            f"Material/Axes={axes}")


def coefficients(ratios):
    """F, G, H of the ratios R_11, R_22, R_33 (Hill 1948)."""
    one, two, three = (1 / ratio**2 for ratio in ratios[:3])
    return (two + three - one) / 2, (three + one - two) / 2, (one + two - three) / 2


def hill_tension(runner):
    """Uniaxial tension along and between the axes of Hill's criterion: stress, ratio of the strains (exact)."""
    along = (0.9, 1.1, 1.05, 1.0, 0.95, 1.2)
    between = (1.0, 1.0, 1.1, 0.9, 1.0, 1.0)  # as strong along 1 as along 2: tension between them causes no shear
    f, g, h = coefficients(along)
    f_45, g_45, h_45 = coefficients(between)
    n_45 = 1.5 / between[3] ** 2
    # The bar is stretched along z; strains across are those along x and y.
    for name, ratios, axes, stress, ratio in (
        ("along 1", along, "0 | 90 | 90", along[0], h / g),
        ("along 2", along, "0 | 90 | 0", along[1], h / f),
        ("along 3", along, "0", along[2], g / f),
        ("at 45 degrees", between, "0 | 90 | 45", 2 / math.sqrt(f_45 + g_45 + 2 * n_45),
         (2 * n_45 - f_45 - g_45) / (2 * (f_45 + g_45)))):
        for law, modulus in (("perfectly plastic", 0), ("isotropic hardening", 2000)):
            row = runner.tables("verification/uniaxial_stress.prm", f"Material/Law={law}", *hill(ratios, axes),
                                "Output/Probe points=middle: 0.5, 0.5, 0.5 | side: 1, 1, 1")
            stretched = row["history"][-1]["max_equivalent_plastic_strain"]
            axial = row["probes"][-1]["middle_stress_zz"]
            runner.compare(f"{name}, {law}, stress", axial, stress * (YIELD + modulus * stretched), 1e-9)
            across = [row["probes"][-1][f"side_displacement_{d}"] + NU * axial / E for d in "xy"]
            runner.compare("ratio of the strains across", across[0] / across[1], ratio, 1e-8)


def hill_plane_strain(runner):
    """Compression in plane strain with Hill's criterion: what the stress tends to (exact)."""
    ratios = (1.0, 0.9, 1.1, 0.8, 1.0, 1.0)
    f, g, h = coefficients(ratios)
    exponent = 8
    block = ("Dimension=2", "Boundary conditions/Roller=left, bottom", "Boundary conditions/Free=right",
             "Boundary conditions/Prescribed displacement=top: free; -0.1*t", "Loading/Number of steps=20")
    for name, entries, equivalent in (  # that of a unit stress, where nothing flows out of plane
        ("Hill", hill(ratios), math.sqrt(h + f * g / (f + g))),
        ("Hill, turned by 45 degrees", hill(ratios, "45"), math.sqrt(0.75) / ratios[3]),
        ("Hosford", ("Material/Yield criterion=Hosford", f"Material/Hosford exponent={exponent}"),
         (0.5 + 0.5**exponent) ** (1 / exponent))):
        step = runner.history("verification/uniaxial_stress.prm", *PERFECT, *entries, *block)[-1]
        runner.compare(f"{name}, stress", -step["top_y"], YIELD / equivalent, 1e-6)


def turned_axes(runner):
    """Axes of Hill's criterion that are turned with the load: the same forces, in the plane and in space."""
    ratios, swapped = (0.9, 1.1, 1.0, 0.95, 1.0, 1.0), (1.1, 0.9, 1.0, 0.95, 1.0, 1.0)
    contact = ("cylinder_2d.prm", *PERFECT, "Loading/Number of steps=3", "Refinement/Strategy=none",
               "Refinement/Number of cycles=1", "Nonlinear solver/Tolerance=1e-11")
    forces = [runner.history(*contact, *hill(r, axes))[-1]["force"] for r, axes in ((ratios, "90"), (swapped, "0"))]
    runner.compare("force of a cylinder", forces[0], forces[1], 1e-8)
    body = ("verification/uniaxial_stress.prm", "Boundary conditions/Roller=", "Boundary conditions/Fixed=bottom",
            "Boundary conditions/Free=left, right, front, back", "Loading/Number of steps=2")
    before, after = (
        runner.history(*body, f"Boundary conditions/Prescribed displacement=top: {shear}; 0",
                       *hill((0.9, 1.1, 1.0, 0.95, 1.1, 0.8), f"{angle} | 30 | 10"))[-1]
        for shear, angle in (("0.02*t; 0.005*t", 25), ("-0.005*t; 0.02*t", 115)))
    runner.compare("shear of a block, turned by 90 degrees", after["top_y"], before["top_x"], 1e-8)
    runner.compare("its other component", after["top_x"], -before["top_y"], 1e-8)


def turning_axes(runner):
    """Axes of Hill's criterion by expressions: layers with axes of their own; a ring with axes along and around it (exact collapse; revolution)."""
    layers = ("cylinder_2d.prm", *PERFECT, "Loading/Number of steps=3", "Refinement/Number of cycles=2",
              "Nonlinear solver/Tolerance=1e-11", "Geometry/Material id=if(y > -0.5, 0, 1)")
    ratios = (0.9, 1.1, 1.0, 0.95, 1.0, 1.0)
    one, two = hill(ratios, "y > -0.5 ? 90 : 0"), hill(ratios, "90, 0")
    forces = [runner.history(*layers, *criterion)[-1]["force"] for criterion in (one, two, hill(ratios, "90"))]
    runner.compare("force of a cylinder on two layers", forces[0], forces[1], 1e-10)
    runner.verify(f"the layer below counts: {forces[2]}", abs(forces[2] / forces[1] - 1) > 1e-4)

    a, b, pressure, yield_stress = 100.0, 200.0, 150.0, 240.0
    r, hoop, axial = 1.0, 1.3, 1.0
    case = "material/rolled_ring.prm"
    f, g, h = coefficients((r, hoop, axial))
    collapse = yield_stress * math.log(b / a) / math.sqrt(h + f * g / (f + g))
    runner.compare("pressure at the collapse of a ring", runner.history(case)[-1]["inner_x"] / a, collapse, 0.002)
    load = f"inner: {pressure}*t*x/sqrt(x^2+y^2); {pressure}*t*y/sqrt(x^2+y^2)"
    ring = (case, "Boundary conditions/Prescribed displacement=", f"Boundary conditions/Traction={load}",
            f"Output/Probe points=rim: {b}, 0")
    revolution = ("creep/thick_cylinder.prm", "Material/Law=perfectly plastic", f"Material/Yield stress={yield_stress}",
                  "Material/Young's modulus=210000", "Material/Rate law=none", "Loading/Final time=1",
                  "Loading/Number of steps=10", "Discretization/Polynomial degree=2",
                  "Discretization/Volumetric treatment=standard",
                  f"Boundary conditions/Traction=left: {pressure}*t; 0", f"Output/Probe points=rim: {b}, 5")
    widening, exact, elsewhere = (
        runner.tables(*body, *hill(of_body, axes))["probes"][-1]["rim_displacement_x"] for body, of_body, axes in (
            (ring, (r, hoop, axial, 1.0, 1.0, 1.0), "180/pi*atan(y/x)"),
            (revolution, (r, axial, hoop, 1.0, 1.0, 1.0), "0"),
            (ring, (r, hoop, axial, 1.0, 1.0, 1.0), "0")))
    runner.compare("a ring with axes along and around it widens", widening, exact, 1e-4)
    runner.verify(f"other than with axes of the body: {elsewhere}", abs(elsewhere / exact - 1) > 0.01)


def hosford_cylinder(runner):
    """A thick cylinder under pressure, plane strain: almost Tresca with a large exponent (exact)."""
    a, b, c, exponent = 100.0, 200.0, 150.0, 100
    pressure = YIELD / 2 * (1 - c**2 / b**2 + 2 * math.log(c / a))
    widening = (1 - NU**2) * YIELD * c**2 / (E * b)
    # In shear, where the difference is largest, the exponent leaves 2^(1/100) of it.
    step = runner.tables(
        "creep/thick_cylinder.prm", "Material/Law=perfectly plastic",
        f"Material/Yield stress={YIELD * 0.5**(1 / exponent)}", "Material/Rate law=none",
        f"Material/Young's modulus={E}", "Material/Yield criterion=Hosford",
        f"Material/Hosford exponent={exponent}", "Loading/Final time=1", "Loading/Number of steps=10",
        f"Boundary conditions/Traction=left: {pressure}*t; 0", "Output/Probe points=outer: 200, 5")["probes"][-1]
    runner.compare("outside moves by", step["outer_displacement_x"], widening, 0.005)


def criteria_and_von_mises(runner):
    """Hosford with the exponents 2 and 4, and Hill with ratios of 1: an indentation as with von Mises."""
    entries = ("Refinement/Elements over contact radius=4", "Loading/History=1: depth 0.002 | 2: force 0",
               "Loading/Number of steps=4", EULER, "Nonlinear solver/Tolerance=1e-11",
               "Linear solver/Type=direct")
    forces = [[step["force"] for step in runner.history("indentation/sphere_axisymmetric.prm", *entries, *criterion)]
              for criterion in ((), ("Material/Yield criterion=Hosford", "Material/Hosford exponent=2"),
                                ("Material/Yield criterion=Hosford", "Material/Hosford exponent=4"),
                                hill((1.0,) * 6, "30"))]
    for name, other in zip(("exponent 2", "exponent 4", "Hill"), forces[1:]):
        largest = max(abs(force - radial) for force, radial in zip(other, forces[0]))
        runner.compare(f"{name}, forces", largest / max(forces[0]), 0, 1e-8, absolute=True)


def hill_indentation(runner):
    """A sphere in space on a material of Hill's: the same force on 1 and 2 ranks, and with a direct solver."""
    case = ("indentation/sphere_3d.prm", "Loading/History=1: depth 0.005 | 2: force 0", "Loading/Number of steps=2",
            "Refinement/Elements over contact radius=2", "Geometry/Initial refinements=2", "Nonlinear solver/Tolerance=1e-11",
            *hill((1.0, 1.1, 0.9, 1.0, 0.9, 1.1)))
    forces = []
    for n, entries in ((1, ()), (2, ()), (1, ("Linear solver/Type=direct",))):
        with runner.on_ranks(n):
            forces.append([step["force"] for step in runner.history(*case, *entries)])
    for name, other in zip(("2 ranks", "direct solver"), forces[1:]):
        largest = max(abs(force - first) for force, first in zip(other, forces[0]))
        runner.compare(f"{name}, forces", largest / max(forces[0]), 0, 1e-8, absolute=True)
