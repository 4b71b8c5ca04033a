# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Waves and errors of force, contact area, pressure and stiffness for values of 'Contact/Edge'.

usage: scripts/command.py contact_law [--edge VALUE ...] [--parts PART,...] [--shapes SHAPE,...] [--elements N,...]
                                      [--quick] [--reference FILE] [--json FILE] [--program PROGRAM]

Sphere and cone, small strains, perfectly plastic, E/sigma_0 = 500, on meshes that are uniform at the contact.
Parts: revolution (loading in 120 steps), stiffness (unloadings while the edge moves through one element), space
(loading of a quarter in 36 steps), ready (the loading of ready cases, with their meshes).

All numbers are in per cent, of the last two thirds of the steps.

wave of Q      largest deviation from a smooth curve, over the largest value
bias (E)       mean deviation of the force from the smooth curve through that of the finest mesh with the edge E; bias
               (mean): from the mean of all these curves; the finest mesh is in revolution, with the same steps
pressure, rms  deviation from the pressure of the finest mesh, 'at nodes', at nodes within 0.9 of its contact radius,
pressure, max  over the mean pressure: root of the mean square, and the largest
largest p      largest pressure over that of 'at nodes' on the same mesh, in the step where this is largest
S              initial slope of the unloading, of a parabola through its first 2.5 per cent; a: contact radius
"""

import argparse
import hashlib
import json
import pathlib

from .contact_edge import mean_forces
from .contact_law_bodies import N_STEPS, SHAPES, loading, ready_case, unloadings
from .edge_runs import EdgeRuns, Report, add_edges, chosen_edges
from .runner import E_STAR
from .smooth_curves import SmoothCurve, at_place, initial_slope, waves
from elasto_plastic_contact.arguments import listed, number, one_of

NODES = "at nodes"
REFERENCE_ELEMENTS = 80
# Case, shape, depth, steps of the loading, dimension.
READY = (("sphere_axisymmetric", "sphere", 0.002, 20), ("cone_axisymmetric", "cone", 0.02, 20),
         ("sphere_3d", "sphere", 0.01, 10))
SPACE_PARTS = 4
WAVES = ("wave of force", "wave of area", "wave of radius", "wave of mean force")


class References:
    """Runs that others are compared with; kept in a file if there is one: those of 'at nodes' for all programs."""

    def __init__(self, runs, file):
        self.runs, self.file = runs, file and pathlib.Path(file)
        self.digest = hashlib.sha256(pathlib.Path(runs.program).read_bytes()).hexdigest()[:12]
        self.known = json.loads(self.file.read_text(encoding="utf-8")) if file and self.file.exists() else {}

    def get(self, name, n_elements, edge, body="revolution", n_steps=None):
        """The loading."""
        program = "" if edge == NODES else f", {self.digest}"
        key = f"{name}, {body}, {n_elements} elements, {n_steps or 'all'} steps, {edge}{program}"
        if key not in self.known:
            self.known[key] = loading(self.runs, name, n_elements, edge, body, n_steps)
            if self.file:
                self.file.write_text(json.dumps(self.known), encoding="utf-8")
        return self.known[key]


def reference_edges(chosen):
    """Those of the finest mesh: the chosen ones, and 'at nodes' in any case."""
    return list(dict.fromkeys([*([] if chosen.quick else chosen_edges(chosen)), NODES]))


def titles_of_biases(edges):
    """Of what biases() returns."""
    return [*(f"bias ({edge})" for edge in edges), *(["bias (mean)"] if len(edges) > 1 else [])]


def loading_of(runs, references, name, n_elements, edge, body="revolution"):
    """A new run; of 'at nodes' that which others are compared with."""
    if edge == NODES:
        return references.get(name, n_elements, edge, body)
    return loading(runs, name, n_elements, edge, body)


def late(run):
    """The last two thirds of the steps."""
    steps = run["history"]
    return steps[len(steps) // 3:]


def column(steps, name):
    return [step[name] for step in steps]


def waves_of(shape, run):
    """Of force, contact area and contact radius, and of the force between entries of nodes."""
    steps = late(run)
    return [100 * waves(column(steps, "depth"), column(steps, name), powers) for name, powers in
            (("force", shape.force), ("contact_area", shape.area), ("contact_radius", shape.contact_radius))
            ] + [100 * waves(*mean_forces(steps), shape.force)]


def biases(shape, run, references, factor=1):
    """The mean deviations of the force from that of each reference, and from their mean if there are several."""
    steps = late(run)
    curves = [SmoothCurve(column(late(reference), "depth"), column(late(reference), "force"), shape.force)
              for reference in references]
    forces = [[curve(step["depth"]) for step in steps] for curve in curves]
    if len(curves) > 1:
        forces.append([sum(values) / len(values) for values in zip(*forces)])
    return [100 * sum(factor * step["force"] / force - 1 for step, force in zip(steps, values)) / len(steps)
            for values in forces]


def pressure_errors(run, reference):
    """Root of the mean square and largest deviation within 0.9 of the contact radius, over the mean pressure."""
    profiles = {round(step["depth"], 12): (step, reference["profiles"].get(str(i)))
                for i, step in enumerate(reference["history"], 1)}
    errors = []
    for i, step in list(enumerate(run["history"], 1))[len(run["history"]) // 3:]:
        fine, points = profiles.get(round(step["depth"], 12), (None, None))
        if points and str(i) in run["profiles"]:
            mean = fine["force"] / fine["contact_area"]
            places, values = zip(*points)
            errors += [p / mean - at_place(places, values, x) / mean for x, p in run["profiles"][str(i)]
                       if x < 0.9 * fine["contact_radius"]]
    if not errors:
        return [None, None]
    return [100 * (sum(e * e for e in errors) / len(errors)) ** 0.5, 100 * max(map(abs, errors))]


def largest_pressure(run, nodal):
    """Over that of the other run, the largest value of all steps."""
    others = {round(step["depth"], 12): step["max_pressure"] for step in late(nodal)}
    return 100 * max(step["max_pressure"] / others[round(step["depth"], 12)] for step in late(run)
                     if round(step["depth"], 12) in others)


def revolution(runs, references, report, chosen):
    """The loading in revolution."""
    edges = reference_edges(chosen)
    report.begin("Revolution, uniform mesh (per cent)",
                 [*WAVES, *titles_of_biases(edges), "pressure, rms", "pressure, max", "largest p", "seconds"])
    for name in chosen.shapes:
        fine = {edge: references.get(name, chosen.reference_elements, edge) for edge in edges}

        def add(n_elements, edge, run):
            report.add(f"{name}, {n_elements} elements, {edge}", [
                *waves_of(SHAPES[name], run), *biases(SHAPES[name], run, fine.values()),
                *pressure_errors(run, fine[NODES]), largest_pressure(run, references.get(name, n_elements, NODES)),
                run["seconds"]])
        for n_elements in chosen.elements:
            for edge in chosen_edges(chosen):
                add(n_elements, edge, loading_of(runs, references, name, n_elements, edge))
        for edge, run in fine.items():
            add(chosen.reference_elements, edge, run)


def stiffness(runs, _, report, chosen):
    """S/(2 E*), a length, at eight depths in one passage of the edge through an element."""
    report.begin(f"Stiffness of the unloading, {chosen.stiffness_elements} elements (per cent)",
                 ["wave of S", "mean S/(2 E* a) - 1", "smallest", "largest"])
    for name in chosen.shapes:
        for edge in chosen_edges(chosen):
            parts = unloadings(runs, name, chosen.stiffness_elements, edge)
            slopes = [initial_slope(column(part, "depth"), column(part, "force")) / (2 * E_STAR) for part in parts]
            ratios = [100 * (slope / part[0]["contact_radius"] - 1) for slope, part in zip(slopes, parts)]
            report.add(f"{name}, {edge}", [100 * waves([part[0]["depth"] for part in parts], slopes, (0, 1)),
                                           sum(ratios) / len(ratios), min(ratios), max(ratios)])


def space(runs, references, report, chosen):
    """The loading in space, against revolution with the same steps."""
    edges = reference_edges(chosen)
    report.begin("Sphere in space, uniform mesh (per cent)",
                 [*WAVES, *titles_of_biases(edges), "largest p", "seconds"])
    fine = [references.get("sphere", chosen.reference_elements, edge, n_steps=N_STEPS["space"]) for edge in edges]
    for n_elements in chosen.space_elements:
        for edge in chosen_edges(chosen):
            run = loading_of(runs, references, "sphere", n_elements, edge, "space")
            report.add(f"{n_elements} elements, {edge}", [
                *waves_of(SHAPES["sphere"], run), *biases(SHAPES["sphere"], run, fine, SPACE_PARTS),
                largest_pressure(run, references.get("sphere", n_elements, NODES, "space")), run["seconds"]])


def ready(runs, _, report, chosen):
    """The loading of ready cases."""
    report.begin("Ready cases, loading (per cent)",
                 [*WAVES, "largest p", "seconds"])
    for case, name, depth, n_steps in READY:
        for edge in chosen_edges(chosen):
            run, nodal = (ready_case(runs, f"indentation/{case}.prm", depth, n_steps, other) for other in (edge, NODES))
            report.add(f"{case}, {edge}", [*waves_of(SHAPES[name], run), largest_pressure(run, nodal), run["seconds"]])


PARTS = {part.__name__: part for part in (revolution, stiffness, ready, space)}


def main(arguments):
    """Prints the tables that are chosen."""
    parser = argparse.ArgumentParser(prog="contact_law", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    add_edges(parser)
    parser.add_argument("--parts", type=listed(one_of(PARTS)), default=",".join(PARTS), help="(default: %(default)s)")
    parser.add_argument("--shapes", type=listed(one_of(SHAPES)), default="sphere,cone", help="(default: %(default)s)")
    parser.add_argument("--elements", type=listed(number(int, least=1)), default="5,10,20,40",
                        metavar="N,...", help="over the final contact radius, in revolution (default: %(default)s)")
    parser.add_argument("--space-elements", type=listed(number(int, least=1)), default="4,6,10", metavar="N,...",
                        help="in space (default: %(default)s)")
    parser.add_argument("--stiffness-elements", type=number(int, least=1), default=20, metavar="N",
                        help="(default: %(default)s)")
    parser.add_argument("--reference-elements", type=number(int, least=1), default=REFERENCE_ELEMENTS, metavar="N",
                        help="of the finest mesh (default: %(default)s)")
    parser.add_argument("--quick", action="store_true", help="compare with 'at nodes' on the finest mesh only")
    parser.add_argument("--reference", metavar="FILE", help="keep what the finest mesh and 'at nodes' give there, and "
                        "use what is there")
    chosen = parser.parse_args(arguments)
    runs, report = EdgeRuns(chosen.program), Report(chosen.json)
    references = References(runs, chosen.reference)
    for part in chosen.parts:
        PARTS[part](runs, references, report, chosen)
    return 0
