# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Verification of initial stresses; see verify."""

import math
import pathlib
import tempfile

from elasto_plastic_contact.program import command_line
from elasto_plastic_contact.tables import read_tables
from . import uniaxial
from .hertz import AXISYMMETRIC, largest, sphere_peak, stress_under_sphere
from .runner import E

BAR = "material/uniaxial_isotropic.prm"
SHEET = "material/plane_stress_tension.prm"
STRAIN = "0.02*if(t <= 1, t, if(t <= 2, 3 - 2*t, t - 3))"
N_STEPS = 60
REVOLUTION = ("Dimension=2", "Kinematics=axisymmetric", "Boundary conditions/Roller=left, bottom",
              "Boundary conditions/Free=right", f"Boundary conditions/Prescribed displacement=top: free; {STRAIN}")
LAWS = {
    "perfectly plastic": uniaxial.Law(E, 400),
    "Armstrong-Frederick": uniaxial.Law(E, 400, isotropic=1000, back=((30000, 150), (2000, 0))),
}

# A ring between smooth plates, free inside and outside unless a pressure acts: div sigma = 0 and sigma n = 0, with
# polynomials that linear elements integrate exactly.
RING = ("Dimension=2", "Kinematics=axisymmetric", "Geometry/Lower corner=1, 0", "Geometry/Upper corner=2, 1",
        "Geometry/Initial refinements=3", "Boundary conditions/Roller=bottom, top",
        "Boundary conditions/Prescribed displacement=", "Output/Probe points=rim: 2, 0.5 | inside: 1.3, 0.4")
FREE = "Boundary conditions/Free=left, right"
RING_STRESS = ("Initial stress/Stress xx=150*(x-1)*(2-x)", "Initial stress/Stress zz=150*(-3*x^2+6*x-2)",
               "Initial stress/Stress yy=100*(x-1.5)")


def initial_stress(runner):
    """Bars and rings that bear a stress from the beginning: rest, first yield, response, work, relaxation (exact)."""
    stretched_bars(runner)
    bars_at_finite_strain(runner)
    bodies_at_rest(runner)
    rings_under_pressure(runner)
    relaxing_bar(runner)


def strains():
    """Of a bar, at the ends of all steps."""
    return [0.02 * (t if t <= 1 else 3 - 2 * t if t <= 2 else t - 3)
            for t in (3 * (step + 1) / N_STEPS for step in range(N_STEPS))]


def stretched_bars(runner):
    """A bar under the stress S is one that has been stretched by S / E before, with all laws."""
    for name, law in LAWS.items():
        for stress in (150, -300):
            exact = [row[0] for row in uniaxial.steps(
                law, [stress / E] + [strain + stress / E for strain in strains()])][1:]
            for body, case, column, component, area, entries in (
                    ("bar", BAR, "top_z", "zz", 1, ()), ("sheet", SHEET, "top_y", "yy", 1, ()),
                    ("bar of revolution", BAR, "top_y", "yy", math.pi, REVOLUTION)):
                rows = runner.history(case, *entries, *law.entries(), f"Initial stress/Stress {component}={stress}")
                error = max(abs(row[column] / area - value) for row, value in zip(rows, exact))
                runner.compare(f"{body}, {name}, {stress} MPa: largest error of a stress", error / 400, 0, 1e-9,
                               absolute=True)


def bars_at_finite_strain(runner):
    """The stress that belongs to the logarithmic strain is that of a bar which has been stretched before."""
    law, stress = LAWS["Armstrong-Frederick"], -300
    exact = [row[0] for row in uniaxial.steps(
        law, [stress / E] + [math.log1p(strain) + stress / E for strain in strains()])][1:]
    for body, case, axis, entries in (("bar", BAR, "z", ("Output/Probe points=middle: 0.3, 0.4, 0.5",)),
                                      ("sheet", SHEET, "y", ("Output/Probe points=middle: 0.3, 0.4",))):
        rows = runner.tables(case, "Strain=logarithmic", *entries, *law.entries(),
                             f"Initial stress/Stress {axis * 2}={stress}")["probes"]
        # of the true stress, times the change of the volume
        stresses = [row[f"middle_stress_{axis * 2}"] * math.exp(sum(row[f"middle_strain_{i * 2}"] for i in "xyz"))
                    for row in rows]
        error = max(abs(value - reference) for value, reference in zip(stresses, exact))
        runner.compare(f"{body}, logarithmic strain: largest error of a stress", error / 400, 0, 1e-9, absolute=True)


def bodies_at_rest(runner):
    """What is in equilibrium does not move: a bar that tractions pull, a block between walls and a ring with their own
    stresses."""
    pulled = ("Boundary conditions/Prescribed displacement=", "Boundary conditions/Traction=top: 0; 0; 150",
              "Initial stress/Stress zz=150", "Output/Probe points=end: 0.3, 0.3, 1")
    # (A stress that is zero in the middle of the only cell, and still the only load.)
    bent = ("Geometry/Initial refinements=0", "Boundary conditions/Prescribed displacement=",
            "Boundary conditions/Roller=left, right, front, back, bottom", "Boundary conditions/Free=top",
            "Initial stress/Stress xx=100*(z-0.5)", "Output/Probe points=end: 0.3, 0.3, 1")
    for name, probe, axis, entries in (("bar", "end", "z", pulled), ("block between walls", "end", "z", bent),
                                       ("ring", "rim", "x", (*RING, FREE, *RING_STRESS)),
                                       ("ring with quadratic elements", "rim", "x",
                                        (*RING, FREE, *RING_STRESS, "Discretization/Polynomial degree=2"))):
        for strain in ("small", "logarithmic"):
            rows = runner.tables(BAR, *entries, f"Strain={strain}", "Loading/Number of steps=3")
            runner.compare(f"{name}, {strain} strain: displacement over 150 MPa / E",
                           max(abs(row[f"{probe}_displacement_{axis}"]) for row in rows["probes"]) * E / 150, 0, 1e-12,
                           absolute=True)
            runner.verify(f"{name}: nothing yields", rows["history"][-1]["plastic_volume"] == 0)


def rings_under_pressure(runner):
    """A ring with its own stress, complete or completed by the program, has the elastic response of one without."""
    inside = ("Boundary conditions/Free=right", "Boundary conditions/Traction=left: 50*t; 0")
    incomplete = (*RING_STRESS[1:], RING_STRESS[0] + "+2*x")
    for treatment in ("standard", "B-bar"):
        elastic = (*RING, *inside, "Material/Law=linear elastic", "Loading/Number of steps=3",
                   f"Discretization/Volumetric treatment={treatment}")
        free = runner.tables(BAR, *elastic)
        for name, entries in (("in equilibrium", RING_STRESS), ("completed", incomplete)):
            tables = runner.tables(BAR, *elastic, *entries)
            for probe in ("rim", "inside"):
                column = f"{probe}_displacement_x"
                runner.compare(f"{treatment}, {name}: {column}", tables["probes"][-1][column],
                               free["probes"][-1][column], 1e-9)
            change = [tables["reactions"][i]["top_y"] - free["reactions"][i]["top_y"] for i in (0, -1)]
            runner.compare(f"{treatment}, {name}: change of the reaction", change[1], change[0], 1e-9)
            end = tables["history"][-1]
            runner.compare(f"{treatment}, {name}: work becomes elastic energy", end["elastic_energy"],
                           end["external_work"], 1e-9)
        rows = runner.tables(BAR, *elastic, *RING_STRESS, "Material/Law=combined hardening",
                             "Loading/Number of steps=120", "Loading/Final time=1",
                             "Boundary conditions/Traction=left: 280*t; 0")["history"]
        runner.verify(f"{treatment}: the ring yields", rows[-1]["plastic_volume"] > 0)
        runner.compare(f"{treatment}: energy balance", sum(rows[-1][name] for name in (
            "elastic_energy", "hardening_energy", "dissipation")), rows[-1]["external_work"], 2e-3)


def relaxing_bar(runner):
    """The stress of a creeping bar between fixed ends (Norton, n = 3), by the same implicit steps; no other load."""
    stress, exponent, rate, n_steps = 200.0, 3, 1e-6, 30
    rows = runner.history(BAR, "Material/Law=linear elastic", "Material/Rate law=Norton",
                          f"Material/Rate exponent={exponent}", f"Material/Reference rate={rate}",
                          "Material/Rate stress=100", f"Initial stress/Stress zz={stress}", "Loading/Final time=300",
                          f"Loading/Number of steps={n_steps}",
                          "Boundary conditions/Prescribed displacement=top: free; free; 0")
    error = 0
    for row in rows:
        lower, upper = 0.0, stress
        for _ in range(200):
            middle = 0.5 * (lower + upper)
            flow = E * rate * (300 / n_steps) * (middle / 100) ** exponent
            lower, upper = (middle, upper) if middle + flow < stress else (lower, middle)
        stress = upper
        error = max(error, abs(row["top_z"] / stress - 1))
    runner.verify(f"the stress relaxes from 200 to {stress:.4g} MPa", stress < 100)
    runner.compare("relaxing bar: largest error of a stress", error, 0, 1e-8, absolute=True)


CONE = "indentation/residual_stress.prm"


def residual_stress(stress):
    """The entries of an equibiaxial stress, in equilibrium with the traction on the side."""
    return {"Initial stress/Stress xx": f"{stress}", "Initial stress/Stress zz": f"{stress}",
            "Boundary conditions/Traction": f"right: {stress}; 0"}


def tables_of(runner, changes, directory, *options, case=CONE, ranks=1):
    """Of a run. (What the forces on the sides, thousands of times that of the indenter, leave on nodes far from
    it is too much for complementarity, which is relative to its force and their gap.)"""
    runner.start(command_line(runner.program, runner.case(case), {"Output/Fields": "never"} | changes, directory,
                              *options, ranks=ranks))
    return read_tables(directory)


def first_yield_under_stress(runner):
    """A sphere on a body under a biaxial stress: tension lets it yield sooner, compression later (exact)."""
    case, *body = AXISYMMETRIC
    peak = sphere_peak(runner.run(case, *body, "Material/Law=linear elastic")[-1]["force"], 1)
    for part in (-0.2, 0.2):  # of the peak: the body yields on the axis first, where the stress adds to the horizontal one
        for load, yields in ((0.97, False), (1.03, True)):
            entries = dict(entry.split("=", 1) for entry in body) | residual_stress(part * peak) | {
                "Boundary conditions/Free": "", "Material/Law": "perfectly plastic",
                "Material/Yield stress": f"{peak * (largest(stress_under_sphere) + part) / load}"}
            with tempfile.TemporaryDirectory() as folder:
                volume = tables_of(runner, entries, folder, "--overwrite", case=case)["history"][-1]["plastic_volume"]
            runner.verify(f"a stress of {part} of the peak, plastic volume at {load} of the load of first yield: {volume:.2e}",
                          (volume > 0) == yields)


def initial_stress_cone(runner):
    """A cone on a body under biaxial stress: compression raises force and pile-up, not the hardness (published)."""
    loads, piles, hardness = {}, {}, {}
    for stress in (-150, 0, 150):
        with tempfile.TemporaryDirectory() as folder:
            tables = tables_of(runner, residual_stress(stress) | {"Loading/History": "1: depth 0.02",
                                                                  "Loading/Number of steps": "30"},
                               folder, "--overwrite")
        runner.compare(f"{stress} MPa: largest force_balance_error",
                       max(row["force_balance_error"] for row in tables["statistics"]), 0, 1e-8, absolute=True)
        rows = [row for row in tables["history"] if row["time"] > 0.7]
        loads[stress] = sum(row["force"] for row in rows)
        piles[stress] = sum(row["pile_up"] / row["depth"] for row in rows) / len(rows)
        hardness[stress] = loads[stress] / sum(row["contact_area"] for row in rows)
    runner.verify(f"compression raises the force {loads}", loads[-150] > 1.01 * loads[0] > 1.02 * loads[150])
    runner.verify(f"and the pile-up {piles}", piles[-150] > piles[0] > piles[150])
    for stress in (-150, 150):
        runner.compare(f"{stress} MPa: hardness with the true area", hardness[stress], hardness[0], 0.02)


ONE_MESH = ("Refinement/Number of cycles=1", "Loading/Control=force", "Nonlinear solver/Tolerance=1e-12")
BLOCK = ("error_bound/parabola.prm", *ONE_MESH, "Geometry/Lower corner=0, -1", "Geometry/Repetitions=4, 4",
         "Boundary conditions/Fixed=", "Boundary conditions/Roller=left, bottom", "Boundary conditions/Free=",
         "Indenter/Radius=0.3", "Loading/Force=1")
CYLINDER = ("error_bound/residual_stress.prm", *ONE_MESH, "Geometry/Initial refinements=2")
CUBE = ("error_bound/paraboloid_3d.prm", *ONE_MESH, "Boundary conditions/Fixed=",
        "Boundary conditions/Roller=left, front, bottom", "Boundary conditions/Free=back", "Loading/Force=300")

# Bodies on a smooth base: a case, Young's modulus, a stress s on the right side, the components that it makes there with
# no strain across the section, and by how much the top sinks then.
NU = 0.3
STRESSED = {
    "plane strain": (BLOCK, 0.2, {"xx": 1, "zz": NU}, NU * (1 + NU) / 1.3),
    "sheet": ((*BLOCK, "Kinematics=plane stress"), 0.2, {"xx": 1}, NU / 1.3),
    "revolution": (CYLINDER, 500, {"xx": 1, "zz": 1}, 2 * NU * 12.8 / 200000),
    "space": (CUBE, 800, {"xx": 1}, NU / 200000)}


def initial_stress_error_bound(runner):
    """Error bounds of bodies under an initial stress: those of the body that is pulled, or that of a free elastic one (exact)."""
    for name, (body, size, components, sinking) in STRESSED.items():
        normal = "; 0" if name != "space" else "; 0; 0"
        pulled = f"Boundary conditions/Traction=right: {size}{normal}"
        stressed = [f"Initial stress/Stress {component}={size * part}" for component, part in components.items()]
        stretched = [f"Initial stress/Stress {component}=" for component in components]
        others = {"plane strain": ("isotropic hardening",), "revolution": ("linear elastic",)}
        for law in ("perfectly plastic", *others.get(name, ())):
            entries = (*body, f"Material/Law={law}", pulled)
            with_both, one = (runner.tables(*entries, *more)["error_bound"][-1] for more in (stressed, stretched))
            compare_bounds(runner, f"{name}, {law}", with_both, one, sinking * size)
        if name == "revolution":  # where stresses that bend are no linear ones when multiplied by r
            continue
        height = "y" if name != "space" else "z"
        bending = [f"Initial stress/Stress {component}={size * part}*({height}+0.3)" for component, part in components.items()]
        elastic = (*body, "Material/Law=linear elastic")
        bent, free = (runner.tables(*elastic, *more)["error_bound"][-1] for more in (
            (*bending, f"Boundary conditions/Traction=right: {size}*({height}+0.3){normal}"), (
                f"Boundary conditions/Traction=right: 0{normal}",)))
        compare_bounds(runner, f"{name}, a stress that bends", bent, free, 0)
        for column in ("energy", "complementary_energy"):
            runner.compare(f"{name}, a stress that bends: {column}", bent[column], free[column], 1e-6)


def compare_bounds(runner, title, row, other, sinking):
    """Of a body whose top has sunk before the other's."""
    for column in ("bound", "bound_of_body", "equilibrium_max_pressure"):
        runner.compare(f"{title}: {column}", row[column], other[column], 1e-5)
    for column in ("depth", "equilibrium_depth"):
        runner.compare(f"{title}: {column}", row[column], other[column] - sinking, 1e-6)
    runner.verify(f"{title}: depth {row['depth']} between {row['depth_lower_bound']} and {row['depth_upper_bound']}",
                  row["depth_lower_bound"] < row["depth"] < row["depth_upper_bound"])
    runner.compare(f"{title}: stress_error", row["stress_error"], 0, 1e-9, absolute=True)


def initial_stress_runs(runner):
    """A cone on a body under a stress that the program completes, on meshes that follow: 1 and 2 ranks, resumed."""
    entries = {"Strain": "small", "Geometry/Local refinements": "4", "Geometry/Local radius": "1",
               "Initial stress/Stress xx": "-100*exp(y/4)", "Initial stress/Stress zz": "-100*exp(y/4)",
               "Boundary conditions/Traction": "right: -100*exp(y/4)+0.5*(y+8); 0",
               "Refinement/Elements over contact radius": "4", "Loading/History": "1: depth 0.1 | 1.2: force 0",
               "Loading/Number of steps": "12"}
    with tempfile.TemporaryDirectory() as folder:
        def run(changes, name, *options, ranks=runner.ranks):
            return tables_of(runner, entries | changes, pathlib.Path(folder) / name, *options, ranks=ranks)["history"]

        whole = run({}, "whole")
        run({"Loading/History": "1: depth 0.1", "Loading/Number of steps": "10"}, "stopped")
        for name, other in (("2 ranks", run({}, "ranks", ranks=2)), ("resumed", run({}, "stopped", "--resume"))):
            for column in ("depth", "force", "contact_area", "plastic_work", "elastic_energy", "external_work"):
                largest = max(abs(row[column]) for row in whole)
                difference = max(abs(a[column] - b[column]) for a, b in zip(whole, other)) / largest
                runner.compare(f"{name}: {column}", difference, 0, 1e-8, absolute=True)
