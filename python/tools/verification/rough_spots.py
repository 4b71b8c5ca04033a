# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Force and largest pressure of rough surfaces with few elements in a spot, for values of 'Contact/Edge'.

usage: scripts/command.py rough_spots [--edge VALUE ...] [--surfaces NAME,...] [--json FILE] [--program PROGRAM]

Surfaces: ready (rough_surface_3d.prm, one mesh) and spots (waves so short that there are more than 50 spots, on a
body that is an eighth as high as wide). Each is pressed in 12 steps on a mesh and on one that is twice as fine.

spots                connected nodes with pressure at the end
force, p             over those of 'at nodes' on the same mesh, minus 1 (per cent): at the end, and for p also the
                     largest of all steps
force, p (finer)     over those of 'at nodes' on the finer mesh, minus 1 (per cent), at the end
"""

import argparse
import pathlib
import tempfile

from elasto_plastic_contact.arguments import listed, one_of
from ..inputs.height_maps import rough_surface, write_pgm
from .edge_runs import EdgeRuns, Report, add_edges, chosen_edges

NODES = "at nodes"
CASE = "rough_surface_3d.prm"
COMMON = {"Refinement/Strategy": "none", "Refinement/Number of cycles": 1, "Loading/Number of steps": 12}
# Entries, and the initial refinements of the coarser mesh.
SURFACES = {
    "ready": ({}, 3),
    "spots": ({"Geometry/Lower corner": (0, 0, -0.125), "Geometry/Repetitions": (8, 8, 1), "Loading/Depth": 0.003,
               "Indenter/Height scale": 0.008}, 2),
}
# Of the second surface, for inputs.height_maps.rough_surface().
PIXELS, HURST, LONGEST, SHORTEST, SEED = 65, 0.8, 7, 12, 2024


def n_spots(fields):
    """How many parts the nodes with pressure form that faces connect."""
    parent = {point: point for point, pressure in zip(places(fields), fields["contact_pressure"]) if pressure > 0}

    def root(point):
        while parent[point] != point:
            parent[point] = parent[parent[point]]
            point = parent[point]
        return point
    points = places(fields)
    for cell in fields["cells"]:
        first, *others = [points[i] for i in cell if points[i] in parent] or [None]
        for other in others:
            parent[root(other)] = root(first)
    return sum(parent[point] == point for point in parent)


def places(fields):
    """Faces may have their own points at the same place."""
    return [tuple(round(x, 5) for x in point) for point in fields["points"]]


def excess(value, other):
    return 100 * (value / other - 1)


def largest_excess(steps, others):
    """Of the pressure, at the times at which the others have one."""
    pressures = {step["time"]: step["max_pressure"] for step in others if step["max_pressure"] > 0}
    return max(excess(step["max_pressure"], pressures[step["time"]]) for step in steps if step["time"] in pressures)


def main(arguments):
    """Prints a table."""
    parser = argparse.ArgumentParser(prog="rough_spots", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    add_edges(parser)
    parser.add_argument("--surfaces", type=listed(one_of(SURFACES)), default=",".join(SURFACES), help="(default: %(default)s)")
    chosen = parser.parse_args(arguments)
    runs, report = EdgeRuns(chosen.program), Report(chosen.json)
    report.begin("Rough surfaces", ["force", "largest p", "spots", "force (%)", "p (%)", "p, all steps (%)",
                                    "force, finer (%)", "p, finer (%)", "seconds"])
    edges = list(dict.fromkeys([NODES, *chosen_edges(chosen)]))
    with tempfile.TemporaryDirectory() as folder:
        heights = pathlib.Path(folder) / "spots.pgm"
        write_pgm(heights, rough_surface(PIXELS, HURST, LONGEST, SHORTEST, SEED))
        for name in chosen.surfaces:
            add_surface(runs, report, edges, name, {"Indenter/File": heights} if name == "spots" else {})
    return 0


def add_surface(runs, report, edges, name, file):
    """The rows of a surface, the finer mesh first."""
    entries, refinements = SURFACES[name]
    finest = None
    for n_refinements in (refinements + 1, refinements):
        nodal = None
        for edge in edges:
            run = runs.run(CASE, COMMON | entries | file | {"Geometry/Initial refinements": n_refinements}, edge,
                           fields="surface")
            steps = run["history"]
            nodal, finest = nodal or steps, finest or steps
            end, other, fine = steps[-1], nodal[-1], finest[-1]
            report.add(f"{name}, {n_refinements} refinements, {edge}", [
                end["force"], end["max_pressure"], str(n_spots(run["fields"])), excess(end["force"], other["force"]),
                excess(end["max_pressure"], other["max_pressure"]),
                largest_excess(steps, nodal),
                excess(end["force"], fine["force"]), excess(end["max_pressure"], fine["max_pressure"]), run["seconds"]])
