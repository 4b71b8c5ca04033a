# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Verification: laws that depend on the rate of the flow; see verify."""

import math

from .runner import E, NU

YIELD = 400.0


def rates_uniaxial(runner):
    """A bar under uniaxial stress with each rate law: loading, then holding (quadrature)."""
    bar = ("Loading/Final time=2", "Geometry/Initial refinements=0",
           "Boundary conditions/Prescribed displacement=top: free; free; 0.01*min(1, t)")
    for name, (entries, rate) in LAWS.items():
        stresses = [[step["top_z"] for step in runner.history(
                        "verification/uniaxial_stress.prm", *bar, *entries, f"Loading/Number of steps={2 * n}")][n - 1::n]
                    for n in (100, 200, 400)]
        exact = integrate(rate)
        for time, coarse, middle, fine, reference in zip((1, 2), *stresses, exact):
            runner.compare(f"{name}, stress at t = {time}", without_step_error(coarse, middle, fine), reference, 1e-6)
        order = math.log2((stresses[0][1] - exact[1]) / (stresses[1][1] - exact[1]))
        runner.compare(f"{name}, order in time", order, 1, 0.05)


def rates_in_bodies(runner):
    """Norton's law with logarithmic strains, quadratic elements, in a sheet and in revolution: a bar in the same implicit steps."""
    entries, rate = LAWS["Norton"]
    n_steps = 20
    plane = ("Dimension=2", "Boundary conditions/Roller=left, bottom", "Boundary conditions/Free=right",
             "Boundary conditions/Prescribed displacement=top: free; 0.01*min(1, t)", "Output/Probe points=middle: 0.5, 0.5")
    space = ("Boundary conditions/Prescribed displacement=top: free; free; 0.01*min(1, t)",
             "Output/Probe points=middle: 0.5, 0.5, 0.5")
    for name, axis, measure, body in (
            ("logarithmic strain", "zz", math.log1p, (*space, "Strain=logarithmic")),
            ("quadratic elements", "zz", float, (*space, "Discretization/Polynomial degree=2")),
            ("sheet", "yy", float, (*plane, "Kinematics=plane stress")),
            ("revolution", "yy", float, (*plane, "Kinematics=axisymmetric"))):
        rows = runner.tables("verification/uniaxial_stress.prm", "Loading/Final time=2", "Geometry/Initial refinements=0", *body,
                             *entries, f"Loading/Number of steps={n_steps}")["probes"]
        strains = [measure(0.01 * min(1, row["time"])) for row in rows]
        for row, reference in zip(rows, implicit_steps(rate, strains, 2 / n_steps)):
            # with logarithmic strains, the law is one of the stress times the change of the volume
            volume = math.exp(sum(row[f"middle_strain_{i}"] for i in ("xx", "yy", "zz"))) if measure is math.log1p else 1
            runner.compare(f"{name}, stress at t = {row['time']:.1f}", volume * row[f"middle_stress_{axis}"], reference, 1e-9)


def implicit_steps(rate, strains, duration):
    """The stress of a bar without hardening at the ends of steps of backward Euler, by bisection."""
    stress = before = 0.0
    for strain in strains:
        trial = stress + E * (strain - before)
        lower, upper = 0.0, trial
        for _ in range(200):
            stress = 0.5 * (lower + upper)
            lower, upper = (stress, upper) if stress + E * duration * rate(stress, 0.0, 0.0) < trial else (lower, stress)
        before = strain
        yield stress


def creep_uniaxial(runner):
    """A bar creeps under a constant stress, which isotropic or kinematic hardening slows down (closed forms)."""
    stress, hardening, unit, reference_rate, end = 500.0, 20000.0, 200.0, 0.02, 2.0
    bar = ("verification/uniaxial_stress.prm", "Geometry/Initial refinements=0", f"Loading/Final time={end}",
           "Boundary conditions/Prescribed displacement=", f"Boundary conditions/Traction=top: 0; 0; {stress}")
    slowing = hardening * reference_rate / unit * end
    for law in ("isotropic", "kinematic"):
        for n in (1, 3):
            first = (stress - YIELD) / unit  # of the overstress ratio y, y' = -(hardening reference_rate / unit) y^n
            last = first * math.exp(-slowing) if n == 1 else (first**(1 - n) + (n - 1) * slowing) ** (1 / (1 - n))
            strains = [runner.history(*bar, f"Material/Law={law} hardening", f"Material/Yield stress={YIELD}",
                                      f"Material/{law.capitalize()} hardening modulus={hardening}", "Material/Rate law=Perzyna",
                                      f"Material/Rate exponent={n}", f"Material/Reference rate={reference_rate}",
                                      f"Material/Rate stress={unit}", f"Loading/Number of steps={steps}"
                                      )[-1]["max_equivalent_plastic_strain"] for steps in (100, 200, 400)]
            runner.compare(f"Perzyna, {law} hardening, n = {n}: plastic strain", without_step_error(*strains),
                           unit * (first - last) / hardening, 1e-6)
    steady = runner.history(*bar, *LAWS["Norton"][0], "Loading/Number of steps=4")[-1]["max_equivalent_plastic_strain"]
    runner.compare("Norton: plastic strain", steady, end * flow(stress, 0.0, 300.0, 0.005, 4), 1e-9)


def without_step_error(coarse, middle, fine):
    """What steps of three sizes give, each half of that before, less the first two orders of their error."""
    return (8 * fine - 6 * middle + coarse) / 3


def flow(stress, resistance, unit, rate, exponent):
    """rate sign(stress) (<|stress| - resistance> / unit)^exponent"""
    return math.copysign(rate * (max(0.0, abs(stress) - resistance) / unit) ** exponent, stress)


# Entries, and the rates of plastic strain, hardening variable and back stress as functions of
# stress and these.
PERFECT = ("Material/Law=perfectly plastic", "Material/Yield stress=400")
LAWS = {
    "Perzyna": (
        (*PERFECT, "Material/Rate law=Perzyna", "Material/Rate exponent=3", "Material/Reference rate=0.02",
         "Material/Rate stress=200"),
        lambda stress, alpha, back: flow(stress, YIELD, 200.0, 0.02, 3)),
    "Perzyna, isotropic hardening": (
        ("Material/Law=isotropic hardening", "Material/Yield stress=400", "Material/Isotropic hardening modulus=20000",
         "Material/Rate law=Perzyna", "Material/Rate exponent=1", "Material/Reference rate=0.02",
         "Material/Rate stress=5000"),
        lambda stress, alpha, back: flow(stress, YIELD + 20000 * alpha, 5000.0, 0.02, 1)),
    "Perzyna, kinematic hardening": (
        ("Material/Law=kinematic hardening", "Material/Yield stress=400", "Material/Kinematic hardening modulus=20000",
         "Material/Rate law=Perzyna", "Material/Rate exponent=2", "Material/Reference rate=0.02",
         "Material/Rate stress=200"),
        lambda stress, alpha, back: flow(stress - 20000 * back, YIELD, 200.0, 0.02, 2)),
    "Norton": (
        ("Material/Law=linear elastic", "Material/Rate law=Norton", "Material/Rate exponent=4",
         "Material/Reference rate=0.005", "Material/Rate stress=300"),
        lambda stress, alpha, back: flow(stress, 0.0, 300.0, 0.005, 4)),
    "Cowper-Symonds": (
        (*PERFECT, "Material/Rate law=Cowper-Symonds", "Material/Rate exponent=2", "Material/Reference rate=0.1"),
        lambda stress, alpha, back: flow(stress, YIELD, YIELD, 0.1, 2)),
    "Duvaut-Lions": (
        (*PERFECT, "Material/Rate law=Duvaut-Lions", "Material/Relaxation time=0.3"),
        lambda stress, alpha, back: flow(stress, YIELD, 3 * E / (2 * (1 + NU)), 1 / 0.3, 1)),
}


def integrate(rate, n_steps=1000):
    """The stress at t = 1 and 2 by the classical Runge-Kutta method; the back stress is counted in plastic strain."""
    def derivative(strain_rate, state):
        stress, alpha, plastic = state
        flowing = rate(stress, alpha, plastic)
        return E * (strain_rate - flowing), abs(flowing), flowing

    state, h, result = (0.0, 0.0, 0.0), 1.0 / n_steps, []
    for strain_rate in (0.01, 0.0):
        for _ in range(n_steps):
            k1 = derivative(strain_rate, state)
            k2 = derivative(strain_rate, [x + 0.5 * h * k for x, k in zip(state, k1)])
            k3 = derivative(strain_rate, [x + 0.5 * h * k for x, k in zip(state, k2)])
            k4 = derivative(strain_rate, [x + h * k for x, k in zip(state, k3)])
            state = tuple(x + h / 6 * (a + 2 * b + 2 * c + d) for x, a, b, c, d in zip(state, k1, k2, k3, k4))
        result.append(state[0])
    return result


def creep_cylinder(runner):
    """A thick cylinder under pressure creeps (Norton): redistribution to the stationary stresses (closed form)."""
    a, b, pressure, reference_rate, unit = 100.0, 200.0, 50.0, 1e-4, 100.0
    for n, final_time in ((3, 2000), (5, 2000), (10, 20000)):
        steps = runner.tables("creep/thick_cylinder.prm", f"Material/Rate exponent={n}",
                              f"Loading/Final time={final_time}")["probes"]
        power = (b / a) ** (2 / n)
        for place, r in (("inner", 101.25), ("outer", 198.75)):  # centres of cells
            runner.compare(f"n = {n}, hoop stress in the {place} cell", steps[-1][f"{place}_stress_zz"],
                           pressure * ((2 / n - 1) * (b / r) ** (2 / n) + 1) / (power - 1), 0.005)
        equivalent = math.sqrt(3) / 2 * pressure * 2 / n * power / (power - 1)
        rate = math.sqrt(3) / 2 * reference_rate * (equivalent / unit) ** n
        widening = [step["left_displacement_x"] / a for step in steps]
        runner.compare(f"n = {n}, rate of the bore", (widening[-1] - widening[-2]) / (final_time / len(steps)), rate,
                       0.005)
        stresses = [step["inner_stress_zz"] for step in steps]
        runner.verify(f"n = {n}, the hoop stress along the bore only falls",
                      all(later <= earlier + 1e-6 * pressure for earlier, later in zip(stresses, stresses[1:])))


def creep_sphere(runner):
    """A thick sphere under pressure creeps (Norton): the stationary stresses, and the rate of its bore (closed form)."""
    a, b, pressure, reference_rate, unit = 100.0, 200.0, 200.0, 1e-4, 200.0
    first, last = cell_of_sphere(a, 1), cell_of_sphere(b, -1)
    for n, final_time in ((3, 2000), (5, 2000), (10, 20000)):
        steps = runner.tables(
            "verification/thick_sphere_axisymmetric.prm", "Material/Law=linear elastic", "Material/Rate law=Norton",
            f"Material/Rate exponent={n}", f"Material/Reference rate={reference_rate}", f"Material/Rate stress={unit}",
            "Boundary conditions/Traction=inner: 200*x/sqrt(x^2 + y^2); 200*y/sqrt(x^2 + y^2)",
            "Geometry/Initial refinements=2", "Discretization/Polynomial degree=1",
            "Discretization/Volumetric treatment=B-bar", f"Loading/Final time={final_time}", "Loading/Number of steps=12",
            f"Output/Probe points=bore: {a}, 0 | first: {first[0]}, {first[1]} | last: {last[0]}, {last[1]}")["probes"]
        power = (b / a) ** (3 / n)
        for place, point in (("first", first), ("last", last)):
            # (with n = 3, the stress along the bore is almost zero)
            runner.compare(f"n = {n}, hoop stress in the {place} cell over the pressure",
                           steps[-1][f"{place}_stress_zz"] / pressure,
                           ((1.5 / n - 1) * (b / math.hypot(*point)) ** (3 / n) + 1) / (power - 1), 0.001, absolute=True)
        equivalent = pressure * 3 / (2 * n) * power / (power - 1)
        widening = [step["bore_displacement_x"] / a for step in steps]
        runner.compare(f"n = {n}, rate of the bore", (widening[-1] - widening[-2]) / (final_time / len(steps)),
                       0.5 * reference_rate * (equivalent / unit) ** n, 0.002)


def cell_of_sphere(radius, inward):
    """The centre of the cell at the equator and at this radius of thick_sphere_2d.msh, refined twice: cells of the file are
    3.75 degrees wide, and their radii grow by the twelfth root of 2."""
    other, angle = radius * 2 ** (inward / 12), math.radians(3.75)
    corners = [(r * math.cos(turn), r * math.sin(turn)) for r in (radius, other) for turn in (0, angle)]
    return [sum(weight * corner[d] for weight, corner in zip((49 / 64, 7 / 64, 7 / 64, 1 / 64), corners)) for d in range(2)]


def creep_contact(runner):
    """A sphere on a viscous half-space under a constant force: the radius of the contact (Lee and Radok)."""
    force, shear_modulus, viscosity, radius = 0.02, 100.0, 1.0, 1.0
    for step in runner.history("creep/sphere_hold.prm"):
        if step["time"] < 0.2:
            continue
        impulse = force * (step["time"] - 0.005)
        exact = (3 * radius / 16 * (force / shear_modulus + impulse / viscosity)) ** (1 / 3)
        runner.compare(f"t = {step['time']:.3f}, contact radius", step["contact_radius"], exact, 0.02)


def creep_accurate_steps(runner):
    """The same with steps by their error: more for a smaller one, to the same depth; none too long meets the body."""
    def steps(tolerance, *entries):
        history = runner.history("creep/sphere_hold.prm", "Refinement/Elements over contact radius=5",
                                 "Loading/Step control=accurate", f"Loading/Step tolerance={tolerance}", *entries)
        return history, [after["time"] - before["time"] for before, after in zip(history, history[1:])]

    coarse, fine = steps(0.008)[0], steps(0.0005)[0]
    # Errors go with the square of a step: four times as many in the limit, fewer as the first ones are given.
    runner.verify(f"{len(coarse)} and {len(fine)} steps", 2 * len(coarse) <= len(fine) <= 4 * len(coarse))
    runner.compare("depth at the end", coarse[-1]["depth"], fine[-1]["depth"], 0.001)

    gap, nominal = 0.06, 1 / 40
    history, lengths = steps(0.002, f"Indenter/Initial gap={gap}", "Loading/History=1: depth 0.08",
                             f"Loading/Number of steps={1 / nominal:.0f}")
    in_air = [length for step, length in zip(history[1:], lengths) if step["depth"] < gap]
    touching = [length for step, length in zip(history[1:], lengths) if step["depth"] >= gap]
    runner.verify(f"longest step in the air {max(in_air):.3g}", max(in_air) > 4 * nominal)
    runner.verify(f"step that meets the body {touching[0]:.3g}", touching[0] <= 1.001 * nominal)
