# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sphere and cone on meshes that are uniform where the contact is; see contact_law."""

from dataclasses import dataclass

from elasto_plastic_contact.program import as_text

# Sides of the box, and how far the smallest cells reach, over the final contact radius.
SIDE, UNIFORM = 64, 1.5
N_LOCAL = 6
N_STEPS = {"revolution": 120, "space": 36}
# What is kept of a run for comparisons.
COLUMNS = ("depth", "force", "contact_area", "contact_radius", "max_pressure", "mean_depth", "mean_force")


@dataclass(frozen=True)
class Shape:
    """An indenter: its case in revolution, depth and contact radius at the end of the loading, the powers of the
    depth that force, contact area and contact radius are made of, and the power of the radius."""
    case: str
    depth: float
    radius: float
    force: tuple
    area: tuple
    contact_radius: tuple
    exponent: float


SHAPES = {
    "sphere": Shape("indentation/sphere_axisymmetric.prm", 0.002, 0.0591, (0.5, 1, 1.5), (0.5, 1, 1.5), (0, 0.5, 1), 0.5),
    "cone": Shape("indentation/cone_axisymmetric.prm", 0.02, 0.0655, (1, 2), (1, 2), (0, 1), 1),
}


def mesh(radius, n_elements, dim, side=SIDE, n_local=N_LOCAL):
    """A box, its sides a multiple of the contact radius, whose smallest cells, n_elements over this radius, lie around
    the contact."""
    halvings, coarse = 0, side * n_elements
    while coarse % 2 == 0:
        halvings, coarse = halvings + 1, coarse // 2
    return {"Geometry/Lower corner": (*((0,) * (dim - 1)), -side * radius),
            "Geometry/Upper corner": (*((side * radius,) * (dim - 1)), 0),
            "Geometry/Repetitions": (coarse,) * dim, "Geometry/Initial refinements": halvings - n_local,
            "Geometry/Local refinements": n_local, "Geometry/Local radius": UNIFORM * radius * 2 ** (n_local - 1),
            "Refinement/Elements over contact radius": 0}


def uniform_mesh(name, n_elements):
    """The mesh for the sphere or the cone in revolution, as the command line takes it."""
    return [f"{path}={as_text(value)}" for path, value in mesh(SHAPES[name].radius, n_elements, 2).items()]


def plastic_body(shape, n_elements, dim):
    """The mesh with a material without hardening, for steps of one kind, whatever the case has."""
    return mesh(shape.radius, n_elements, dim) | {"Material/Law": "perfectly plastic", "Loading/Integration": "backward Euler"}


def loading(runs, name, n_elements, edge, body="revolution", n_steps=None):
    """The tables of the loading of a sphere or cone, perfectly plastic: 'history', and 'profiles' by the step: places
    and pressures of the nodes."""
    shape, dim = SHAPES[name], 3 if body == "space" else 2
    entries = plastic_body(shape, n_elements, dim)
    entries |= {"Loading/History": f"1: depth {shape.depth}", "Loading/Number of steps": n_steps or N_STEPS[body]}
    if dim == 2:
        entries["Output/Surface profile"] = "every step"
    return curves(runs.tables("indentation/sphere_3d.prm" if dim == 3 else shape.case, entries, edge))


def ready_case(runs, case, depth, n_steps, edge):
    """The loading of a case as it is."""
    return curves(runs.tables(case, {"Loading/History": f"1: depth {depth}", "Loading/Number of steps": n_steps}, edge))


def curves(tables):
    """What comparisons need, in a form that JSON keeps."""
    rows = [{column: step[column] for column in COLUMNS} for step in tables["history"]]
    profiles = {}
    for row in tables.get("surface_profile", ()):
        if row["contact_pressure"] > 0:
            profiles.setdefault(str(int(row["step"])), []).append((row["x"], row["contact_pressure"]))
    return {"history": rows, "profiles": {step: sorted(points) for step, points in profiles.items()},
            "seconds": tables["seconds"]}


def unloadings(runs, name, n_elements, edge, n_depths=8, part=0.025, n_back=4):
    """The rows of several unloadings, the one on which each begins first, while the edge moves through one element.

    Between them, the indenter is pressed to where it has been, and on to the next depth."""
    shape = SHAPES[name]
    period = 1 / n_elements / shape.exponent
    depths = [shape.depth * (1 - period * (1 - i / n_depths)) for i in range(n_depths)]
    n_first = round(N_STEPS["revolution"] * (1 - period))
    history, time, tops = [(n_first, depths[0])], n_first, []
    for i, depth in enumerate(depths):
        tops.append(time)
        last = i == n_depths - 1
        for n_steps, target in ((n_back, depth * (1 - part)), *(() if last else ((2, depth), (2, depths[i + 1])))):
            time += n_steps
            history.append((time, target))
    table = " | ".join(f"{at}: depth {target:.15g}" for at, target in history)
    steps = runs.tables(shape.case, plastic_body(shape, n_elements, 2) | {
        "Loading/History": table, "Loading/Number of steps": time}, edge)["history"]
    by_time = {round(step["time"], 6): step for step in steps}
    return [[by_time[round(float(top + i), 6)] for i in range(n_back + 1)] for top in tops]
