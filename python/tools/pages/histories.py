# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of load histories with small strains; see command."""

import math

from ..verification.indentation import CYCLES, at_time, of_both_laws
from ..verification.runner import E_STAR, EULER, TWO_STEPS
from .recipe import Content, count, decimals, hundredths, percent, power, signed_percent, table

SPHERE = "indentation/sphere_axisymmetric.prm"
CONE = "indentation/cone_axisymmetric.prm"
STEEL = "indentation/hardened_steel.prm"
STEPS = "Loading/Number of steps={}"
ELEMENTS = "Refinement/Elements over contact radius={}"
YIELD_STRESS = 400
DIAMETER = 2.5  # of the ball for the steel, in mm


def slope_over_exact(steps):
    """Of the unloading, its first step, over 2 E* a."""
    top = next(i for i, step in enumerate(steps) if step["time"] == 1)
    deepest, after = steps[top:top + 2]
    slope = (deepest["force"] - after["force"]) / (deepest["depth"] - after["depth"])
    return slope / (2 * E_STAR * math.sqrt(deepest["contact_area"] / math.pi))


def energy_share(steps):
    """Stored energy and dissipation over the work of the indenter."""
    last = steps[-1]
    return last["external_work"] / sum(last[name] for name in ("elastic_energy", "hardening_energy", "dissipation"))


@table(35)
def sphere_fits(runs):
    """A sphere: force, residual depth, slope and work against published fits."""
    steps, finer = runs.history(SPHERE), runs.history(SPHERE, ELEMENTS.format(32))
    first_depth = 6.417988 * YIELD_STRESS**2 / E_STAR**2  # of yield, Johnson 1985, radius 1
    first_force = 21.678895 * YIELD_STRESS**3 / E_STAR**2
    ratios = [(step["depth"] / first_depth, step["force"] / first_force) for step in steps if step["time"] <= 1]
    deviation = max(abs(force / (1.40 * w**1.263) - 1) for w, force in ratios if w >= 6)
    w = ratios[-1][0]
    residual, fine_residual = (at_time(rows, 2)["depth"] / at_time(rows, 1)["depth"] for rows in (steps, finer))
    more_steps = runs.history(SPHERE, STEPS.format(120))
    numbers = {
        "unknowns": count(max(step["dofs"] for step in steps)), "deviation": hundredths(deviation),
        "fine_unknowns": count(max(step["dofs"] for step in finer)),
        "force": f"{at_time(steps, 1)['force']:.3f}", "fine_force": f"{at_time(finer, 1)['force']:.3f}",
        "fine_slope": f"{slope_over_exact(finer):.3f}", "fine_residual": f"{fine_residual:.3f}",
        "work_of_more_steps": f"{energy_share(more_steps):.3f}",
    }
    return Content([[None, "", None], [None, f"{residual:.3f}", f"{(1 - w**-0.28) * (1 - w**-0.69):.3f}"],
                    [None, f"{slope_over_exact(steps):.3f}", None],
                    [None, f"{energy_share(steps):.3f}", None]], numbers)


@table(30)
def sphere_steps(runs):
    """Force and dissipation of the loading by the number of load steps, with both ways to integrate them."""
    numbers = (1, 2, 5, 10, 20, 40, 80)
    ends = {way: {n: runs.history(SPHERE, way, "Loading/History=1: depth 0.002", STEPS.format(n))[-1] for n in numbers}
            for way in (EULER, TWO_STEPS)}
    best = ends[TWO_STEPS][80]["force"]
    missing = {name: percent(1 - ends[way][n]["force"] / best).removesuffix(" %") for name, way, n in
               (("missing_1", EULER, 1), ("euler_20", EULER, 20), ("euler_80", EULER, 80), ("two_steps_20", TWO_STEPS, 20))}
    return Content([row for by_number in ends.values() for row in
                    ([None, *(f"{end['force']:.3f}" for end in by_number.values())],
                     [None, *(f"{1e3 * end['dissipation']:.3f}" for end in by_number.values())])], missing)


@table(30)
def cone_similarity(runs):
    """Force over depth squared of a cone."""
    steps = runs.history(CONE)
    quotients = [step["force"] / step["depth"] ** 2 for step in steps]
    finer = [runs.history(CONE, "Loading/History=1: depth 0.02", STEPS.format(n))[-1] for n in (30, 40)]
    return Content([[None, *(f"{quotients[n - 1]:.0f}" for n in (10, 15, 20)),
                     *(f"{step['force'] / step['depth'] ** 2:.0f}" for step in finer)]])


@table(45)
def oliver_pharr(runs):
    """The evaluation of both unloadings."""
    rows, numbers = [[None] for _ in range(5)], {}
    for name, case in (("sphere", SPHERE), ("cone", CONE)):
        row, = runs.tables(case)["indentation"]
        more, = runs.tables(case, STEPS.format(120))["indentation"]
        for cells, cell in zip(rows, (f"{row['exponent']:.3f}", f"{row['reduced_modulus'] / E_STAR:.3f}",
                                      f"{row['tip_reduced_modulus'] / E_STAR:.3f}", f"{row['hardness']:.1f}",
                                      f"{row['tip_hardness']:.1f}")):
            cells.append(cell)
        numbers |= {f"{name}_more_steps": hundredths(more["reduced_modulus"] / E_STAR - 1),
                    f"{name}_area": hundredths(1 - row["tip_area"] / row["contact_area"], 0),
                    f"{name}_pile_up": hundredths(abs(row["pile_up"]) / row["max_depth"], 0)}
    larger, = runs.tables(SPHERE, "Geometry/Lower corner=0, -32", "Geometry/Upper corner=32, 0")["indentation"]
    numbers["sphere_larger_body"] = hundredths(larger["reduced_modulus"] / E_STAR - 1)
    return Content(rows, numbers)


@table(60)
def sphere_quarter(runs):
    """The test of the sphere in space."""
    numbers = {}
    for name, entries in (("", ()), ("fine_", (ELEMENTS.format(10),))):
        steps = runs.history("indentation/sphere_3d.prm", *entries)
        top, bottom, again = (at_time(steps, time) for time in (1, 2, 3))
        numbers |= {f"{name}unknowns": count(max(step["dofs"] for step in steps)),
                    f"{name}force": f"{top['force']:.3f}", f"{name}residual": f"{bottom['depth']:.5f}",
                    f"{name}again": f"{again['force']:.3f}",
                    f"{name}less": hundredths(1 - again["force"] / top["force"])}
    return Content(numbers=numbers)


@table(10)
def hardening_cycles(runs):
    """Ten cycles of the force with isotropic and with kinematic hardening."""
    rows, numbers = [[None] for _ in range(5)], {}
    for law in ("isotropic", "kinematic"):
        steps = runs.history(f"hardening_cycles/{law}.prm")
        works = [0, *(at_time(steps, 2 * cycle)["plastic_work"] for cycle in range(1, 11))]
        for cells, cycle in zip(rows, (1, 2, 3, 5, 10)):
            work = works[cycle] - works[cycle - 1]
            cells += [f"{at_time(steps, 2 * cycle - 1)['depth']:.8f}", f"{at_time(steps, 2 * cycle)['depth']:.8f}",
                      power(work, 4 if work > 1e-4 else 2) if work > 1e-8 else "less than 1e-8"]
        numbers[f"{law}_share"] = hundredths((works[10] - works[9]) / at_time(steps, 1)["plastic_work"])
    return Content(rows, numbers)


@table(20)
def cycles_on_moving_mesh(runs):
    """The same on a mesh that follows the contact."""
    mesh = ("Refinement/Strategy=Kelly", "Refinement/Steps between adaptations=20",
            "Refinement/Refinement fraction=0.15", "Refinement/Coarsening fraction=0.2",
            "Refinement/Maximum number of unknowns=4000")
    numbers = {}
    for law in ("isotropic", "kinematic"):
        tables = runs.tables(f"hardening_cycles/{law}.prm", *mesh)
        second, tenth = (at_time(tables["history"], time)["depth"] for time in (3, 19))
        numbers |= {law: power(abs(tenth / second - 1), 2), f"{law}_changes": count(
            sum(3 < change["time"] < 19 for change in tables["mesh_changes"]))}
    return Content(numbers=numbers)


@table(40)
def rate_jump(runs):
    """A cone at strain rates that jump, and a hold of the force: hardness and rate sensitivities."""
    *jumps, hold = runs.tables("creep/rate_jump.prm")["indentation"]
    rows = [[None, f"{row['hardness']:.0f} MPa", None, f"{row['jump_rate_sensitivity']:.3f}"] for row in jumps]
    return Content([*rows, [None, f"{hold['hardness']:.0f} MPa", f"{hold['creep_depth']:.3f} mm",
                            f"{hold['hold_rate_sensitivity']:.3f}"]])


@table(2)
def hencky(runs):
    """A force in one step and in twenty, with isotropic and with kinematic hardening."""
    force = "Loading/History=1: force 20"
    one, many = ([steps[-1]["depth"] for steps in of_both_laws(runs, *CYCLES, force, STEPS.format(n))] for n in (1, 20))
    return Content(numbers={"isotropic": hundredths(1 - many[0] / one[0], 0),
                            "kinematic": hundredths(1 - many[1] / one[1], 0), "laws": hundredths(many[1] / many[0] - 1)})


@table(7)
def tutorial_history(runs):
    """The tutorial's sphere after loading, unloading and reloading."""
    steps = runs.history(SPHERE)
    ends = [at_time(steps, time) for time in (1, 2, 3)]
    rows = [[None, *decimals(end, depth=6, force=3, contact_radius=5, max_pressure=1, plastic_volume=6),
             power(end["elastic_energy"]), power(end["dissipation"])] for end in ends]
    top, bottom, again = ends
    hardness = runs.tables(SPHERE)["indentation"][0]["hardness"]
    changes = sum(change["time"] < 1 for change in runs.tables(SPHERE)["mesh_changes"])
    return Content(rows, {
        "hardness": f"{hardness:.0f}", "hardness_over_yield": f"{hardness / YIELD_STRESS:.2f}",
        "residual": hundredths(bottom["depth"] / top["depth"], 0),
        "locked_in": hundredths(bottom["elastic_energy"] / top["elastic_energy"], 0),
        "dissipation": hundredths(bottom["dissipation"] / top["dissipation"] - 1),
        "smaller": hundredths(1 - again["force"] / top["force"]), "changes": count(changes)})


@table(25)
def tutorial_elements(runs):
    """The tutorial's sphere with few and many elements over the contact radius."""
    rows = []
    for n in (8, 16, 32):
        steps = runs.history(SPHERE, ELEMENTS.format(n))
        top, bottom = at_time(steps, 1), at_time(steps, 2)
        until = [step["newton_iterations"] for step in steps if step["time"] <= 2]
        rows.append([None, count(top["dofs"]), count(top["active_nodes"]), *decimals(top, force=3),
                     *decimals(bottom, depth=6), *decimals(top, contact_area=5), f"{sum(until) / len(until):.1f}"])
    return Content(rows)


@table(330)
def hardened_steel(runs):
    """A Brinell test of case-hardened steel on several meshes."""
    rows, cases = [], ((ELEMENTS.format(10),), (), (ELEMENTS.format(40),),
                       ("Discretization/Polynomial degree=2", "Discretization/Volumetric treatment=standard"),
                       (STEPS.format(120),))
    for entries in cases:
        steps = runs.history(STEEL, *entries)
        top = at_time(steps, 1)
        rows.append([None, count(top["dofs"]), *decimals(top, depth=5), *decimals(at_time(steps, 2), depth=5),
                     *decimals(top, contact_area=4, contact_radius=3), f"{brinell(top):.0f}",
                     *decimals(top, max_equivalent_plastic_strain=3)])
    numbers = {}
    for name, stress in (("core", 450), ("layer", 900)):
        steps = runs.history(STEEL, "Geometry/Material id=0", f"Material/Yield stress={stress}")
        numbers[name] = f"{brinell(at_time(steps, 1)):.0f}"
    return Content(rows, numbers)


@table(40)
def validity(runs):
    """Contact radius over that of the ball, and the largest plastic strain, at the largest load."""
    sphere, cone, steel = (at_time(runs.history(case), 1) for case in (SPHERE, CONE, STEEL))
    return Content(numbers={"sphere_radius": f"{sphere['contact_radius']:.2f}",
                            "steel_radius": f"{steel['contact_radius'] / (DIAMETER / 2):.2f}",
                            **{name: f"{step['max_equivalent_plastic_strain']:.2g}" for name, step in
                               (("sphere", sphere), ("cone", cone), ("steel", steel))}})


def brinell(step):
    """HBW of the ball."""
    height = DIAMETER - math.sqrt(DIAMETER**2 - 4 * step["contact_radius"] ** 2)
    return 0.102 * 2 * step["force"] / (math.pi * DIAMETER * height)


@table(2)
def sphere_in_space(runs):
    """A sphere on a quarter in space against an axisymmetric body."""
    body = ("Loading/History=", "Loading/Depth=0.01", "Loading/Number of steps=3", EULER, "Geometry/Initial refinements=3",
            "Geometry/Local refinements=4", "Geometry/Local radius=1", ELEMENTS.format(0))
    quarter = runs.history("indentation/sphere_3d.prm", *body)[-1]
    whole = runs.history(SPHERE, *body, "Geometry/Lower corner=0, -2", "Geometry/Upper corner=2, 0",
                         "Material/Law=isotropic hardening", "Material/Isotropic hardening modulus=2000")[-1]
    return Content(numbers={name: signed_percent(4 * quarter[name] / whole[name] - 1).removesuffix(" %") for name in
                            ("force", "contact_area", "elastic_energy", "plastic_work", "plastic_volume")})
