# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Verification of loading, unloading and reloading, and of contact itself; see verify."""

import math

from elasto_plastic_contact.fields import read_fields
from elasto_plastic_contact.tables import read_tables
from .runner import EULER

CYCLES = ("hardening_cycles/isotropic.prm", "Geometry/Local refinements=4")
LAWS = ("isotropic", "kinematic")


def law(name):
    """The entries for one of the two kinds of hardening, with the same modulus."""
    return (f"Material/Law={name} hardening", "Material/Isotropic hardening modulus=20000",
            "Material/Kinematic hardening modulus=20000")


def of_both_laws(runner, case, *entries):
    """Rows of history.csv with isotropic and with kinematic hardening."""
    return [runner.history(case, *entries, *law(name)) for name in LAWS]


def hencky_and_flow(runner):
    """One step and many, isotropic and kinematic hardening: when they agree and when not."""
    hencky = [steps[-1] for steps in of_both_laws(
        runner, *CYCLES, "Loading/History=1: force 20", "Loading/Number of steps=1")]
    for name in ("depth", "contact_area", "max_pressure", "elastic_energy", "plastic_work"):
        runner.compare(f"sphere in one step, {name}", hencky[1][name], hencky[0][name], 1e-12)
    flow = {n_steps: [steps[-1]["depth"] for steps in of_both_laws(
        runner, *CYCLES, "Contact/Edge=at nodes", "Loading/History=1: force 20", f"Loading/Number of steps={n_steps}")]
        for n_steps in (10, 20)}
    for name, coarse, fine in zip(("isotropic", "kinematic"), flow[10], flow[20]):
        runner.compare(f"sphere, {name}, depth in 10 and in 20 steps", coarse, fine, 0.015)
        runner.verify(f"sphere, {name}: one step is another problem ({hencky[0]['depth'] / fine:.4f})",
                      hencky[0]["depth"] / fine > 1.03)
    difference = flow[20][1] / flow[20][0]
    runner.verify(f"sphere in many steps: the laws differ a little (depth times {difference:.4f})",
                  1.005 < difference < 1.05)
    proportional_loading(runner)


def proportional_loading(runner):
    """Thick sphere: pressure 300, back, and suction 300. Each point is loaded in one direction."""
    pressure = "300*if(t <= 1, t, 2 - t)"
    traction = f"inner: {pressure}*x/sqrt(x^2 + y^2); {pressure}*y/sqrt(x^2 + y^2)"
    ends = [[at_time(steps, time) for time in (1, 3)] for n_steps in (1, 5)
            for steps in of_both_laws(
                runner, "verification/thick_sphere_axisymmetric.prm", "Geometry/Initial refinements=0",
                f"Boundary conditions/Traction={traction}", f"Loading/Number of steps={3 * n_steps}")]
    for (loaded, _), name in zip(ends[1:], ("kinematic, 1 step", "isotropic, 5 steps", "kinematic, 5 steps")):
        for quantity in ("elastic_energy", "hardening_energy"):
            runner.compare(f"thick sphere, {quantity}, {name} against isotropic, 1 step",
                           loaded[quantity], ends[0][0][quantity], 1e-6)
    ratio = ends[3][1]["plastic_work"] / ends[2][1]["plastic_work"]
    runner.verify(f"thick sphere, suction: kinematic hardening flows more (plastic work times {ratio:.3f})",
                  ratio > 1.1)


def at_time(steps, time):
    """The row of that time."""
    return next(step for step in steps if abs(step["time"] - time) < 1e-9)


def johnson_conditions(runner):
    """Johnson's conditions (1.4) to (1.8) at a given force, in the plane and in space."""
    for case, force, reach in (("johnson/isotropic.prm", 2, 0.3), ("johnson/isotropic_3d.prm", 0.5, 0.5)):
        entries = (f"Indenter/Reach={reach}", "Refinement/Number of cycles=2", "Output/Fields=last cycle")
        with runner.results(case, entries) as folder:
            row = read_tables(folder)["statistics"][-1]
            surface = next(read_fields(folder, "surface"))
        runner.compare(f"{case}, (1.4), forces on free nodes", row["residual"], 0, 1e-10, absolute=True)
        runner.compare("(1.4), contact against supports", row["force_balance_error"], 0, 1e-10, absolute=True)
        runner.compare("(1.5), force", row["force"], force, 1e-10)
        runner.verify(f"(1.6), smallest pressure {row['min_pressure']:.3g}", row["min_pressure"] > 0)
        runner.compare("(1.8), force times distance", row["complementarity_error"], 0, 1e-10, absolute=True)
        runner.compare("no penetration", row["max_penetration"], 0, 1e-12 * row["depth"], absolute=True)
        johnson_conditions_in_fields(runner, surface, force, reach)


def johnson_conditions_in_fields(runner, surface, force, reach):
    """The same from what is drawn, which has six digits."""
    pressure = surface["contact_pressure"]
    largest = max(pressure)
    runner.compare("(1.5), integral of the pressure", integral(surface, pressure), force, 1e-5)
    runner.verify("(1.6), pressure nowhere negative", min(pressure) >= 0)
    runner.verify("(1.7), no pressure out of reach",
                  all(p == 0 for p, (x, y, _) in zip(pressure, surface["points"])
                      if math.hypot(x, y) > reach * (1 + 1e-6)))


def johnson_limit(runner):
    """Johnson's mu to 0: hardening tends to perfect plasticity, with an error of order mu."""
    meshes = "Refinement/Number of cycles=3"
    limit = runner.run("johnson/perfect.prm", meshes)[-1]["depth"]
    depths = [runner.run(f"johnson/{name}.prm", meshes)[-1]["depth"] for name in LAWS]
    runner.compare("depth at mu = 0.1, kinematic and isotropic", *reversed(depths), 1e-12)
    missing = []
    for mu in (1, 0.01, 0.001, 0.0001):
        depth = runner.run("johnson/isotropic.prm", meshes,
                           f"Material/Isotropic hardening modulus={1.5 * mu}")[-1]["depth"]
        missing.append(1 - depth / limit)
    runner.verify("the depth grows as mu falls", all(a > b > 0 for a, b in zip(missing, missing[1:])))
    runner.compare("depth missing at mu = 0.001 over that at 0.0001", missing[-2] / missing[-1], 10, 0.2)
    runner.compare("depth at mu = 0.0001, of that at 0", missing[-1], 0, 2e-3, absolute=True)


def integral(surface, values):
    """Of linear functions over the level faces of a surface at height 0: means times areas."""
    total = 0.0
    for cell in surface["cells"]:
        extents = [max(c) - min(c) for c in zip(*(surface["points"][point] for point in cell))]
        area = math.prod(extent for extent in extents if extent > 0)
        total += area * sum(values[point] for point in cell) / len(cell)
    return total


def load_cycles(runner):
    """Ten force cycles: isotropic hardening shakes down, kinematic does not."""
    isotropic, kinematic = of_both_laws(runner, *CYCLES, "Loading/Number of steps=40")
    for steps in (isotropic, kinematic):
        work = [step["plastic_work"] for step in steps]
        runner.verify("plastic work never decreases",
                      all(b >= a * (1 - 1e-12) for a, b in zip(work, work[1:])))
    for quantity, name, times in (("depth", "top", (19, 9)), ("depth", "bottom", (20, 10)),
                                  ("contact_area", "top", (19, 9)), ("plastic_work", "bottom", (20, 10))):
        last, middle = (at_time(isotropic, time)[quantity] for time in times)
        runner.compare(f"isotropic, {quantity} at the {name}, cycle 10 and 5", last, middle, 1e-6)
    cycles = [at_time(kinematic, time)["plastic_work"] - at_time(kinematic, time - 2)["plastic_work"]
              for time in range(4, 21, 2)]
    runner.compare("kinematic, plastic work of cycle 10 and 9", cycles[-1], cycles[-2], 0.01)
    share = cycles[-1] / at_time(kinematic, 1)["plastic_work"]
    runner.verify(f"kinematic, share of the first loading in each further cycle: {share:.4f}", share > 0.03)


def axisymmetric_against_space(runner):
    """The same sphere as an axisymmetric body and in space, cells of the same size."""
    body = ("Loading/History=", "Loading/Depth=0.01", "Loading/Number of steps=3", EULER,
            "Geometry/Initial refinements=3", "Geometry/Local refinements=4", "Geometry/Local radius=1",
            "Refinement/Elements over contact radius=0")
    quarter = runner.history("indentation/sphere_3d.prm", *body)[-1]
    whole = runner.history("indentation/sphere_axisymmetric.prm", *body, "Geometry/Lower corner=0, -2",
                           "Geometry/Upper corner=2, 0", "Material/Law=isotropic hardening",
                           "Material/Isotropic hardening modulus=2000")[-1]
    # the edge of the contact is known to a cell, a tenth of its radius
    for name, allowed in (("force", 0.02), ("contact_area", 0.1), ("plastic_volume", 0.1),
                          ("elastic_energy", 0.02), ("plastic_work", 0.03)):
        runner.compare(name, 4 * quarter[name], whole[name], allowed)


def sectors(runner):
    """A sphere and a cone on sectors of a round block: the same for two angles each, and as an axisymmetric body."""
    loading = ("Loading/History=", "Loading/Depth=0.01", "Loading/Number of steps=1",
               "Refinement/Elements over contact radius=0")
    body = ("Geometry/Type=sector", "Geometry/Radius=2", "Geometry/Height=2", "Geometry/Core radius=0.03125",
            "Geometry/Initial refinements=3", "Boundary conditions/Free=side")
    for name, angles, shape in (("sphere", (60, 90), ()),
                                ("cone", (45, 90), ("Indenter/Type=cone", "Indenter/Semi-apex angle=85"))):
        whole = runner.history("indentation/sphere_axisymmetric.prm", *loading, *shape, "Geometry/Lower corner=0, -2",
                               "Geometry/Upper corner=2, 0", "Geometry/Initial refinements=4",
                               "Geometry/Local refinements=5", "Geometry/Local radius=1",
                               "Material/Law=isotropic hardening", "Material/Isotropic hardening modulus=2000")[-1]
        forces = []
        for angle in angles:
            part = runner.history("indentation/sphere_3d.prm", *loading, *body, *shape,
                                  f"Geometry/Sector angle={angle}", "Boundary conditions/Roller=front, back")[-1]
            forces.append(360 / angle * part["force"])
            runner.compare(f"{name}, {angle} degrees: force against the axisymmetric body", forces[-1],
                           whole["force"], 0.01)
        runner.compare(f"{name}: largest force of all angles", max(forces), min(forces), 0.006)


def pyramid_sectors(runner):
    """Vickers' and Berkovich's pyramids, finite strains: a sector, and twice of it."""
    loading = ("Geometry/Initial refinements=1", "Loading/History=1: depth 0.002", "Loading/Number of steps=2")
    for name, case, angle, planes in (("Vickers", "indentation/vickers_sector.prm", 90, "front"),
                                      ("Berkovich", "indentation/berkovich_sector.prm", 60, "front, back")):
        part = runner.history(case, *loading, f"Geometry/Sector angle={angle}")[-1]
        twice = runner.history(case, *loading, f"Geometry/Sector angle={2 * angle}",
                               f"Boundary conditions/Roller={planes}")[-1]
        for quantity in ("force", "contact_area", "external_work"):
            runner.compare(f"{name}: {quantity} of a sector of {angle} degrees against twice of it",
                           2 * part[quantity], twice[quantity], 1e-8)
