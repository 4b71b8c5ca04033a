# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The diagrams of plot.py: each function draws one of a run, or returns None if
the run has nothing to show there. Needs matplotlib and VTK's Python modules."""

import math
from dataclasses import dataclass

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402 (the choice of Agg comes first)
import numpy  # noqa: E402

import material_test  # noqa: E402

BLUE, RED = "#2b5c8a", "#b8303a"

plt.rcParams.update({"font.size": 11, "axes.grid": True, "grid.alpha": 0.3, "axes.spines.top": False,
                     "axes.spines.right": False, "legend.frameon": False, "figure.dpi": 150,
                     "savefig.bbox": "tight"})


@dataclass
class Hertz:
    """Contact radius (or half-width) and largest pressure of Hertz's contact
    with an elastic half-space (Johnson, Contact mechanics, 1985, section 4.2)."""
    radius: float
    pressure: float

    @staticmethod
    def under_sphere(force, radius, modulus):
        contact_radius = (3. * force * radius / (4. * modulus)) ** (1. / 3.)
        return Hertz(contact_radius, 1.5 * force / (math.pi * contact_radius ** 2))

    @staticmethod
    def under_cylinder(force, radius, modulus):
        half_width = math.sqrt(4. * force * radius / (math.pi * modulus))
        return Hertz(half_width, 2. * force / (math.pi * half_width))

    def profile(self, distance):
        return self.pressure * numpy.sqrt(numpy.clip(1. - (distance / self.radius) ** 2, 0., None))


def hertz_of_run(run, arguments):
    contrast = 1. - run.number("Material/Poisson's ratio") ** 2
    modulus = run.number("Material/Young's modulus") / contrast
    force = run.table("statistics.csv")["force"][-1] * n_parts(run, arguments)
    solutions = {"sphere": Hertz.under_sphere, "cylinder": Hertz.under_cylinder}
    return solutions[arguments.hertz](force, run.number("Indenter/Radius"), modulus)


def n_parts(run, arguments):
    """How many of the computed part make up the whole body."""
    if arguments.parts is not None:
        return arguments.parts
    return 1. / run.table("indentation.csv")["modelled_part"][0] if run.has("indentation.csv") else 1.


def new_diagram(xlabel, ylabel):
    figure, axes = plt.subplots(figsize=(6.4, 4.))
    axes.set(xlabel=xlabel, ylabel=ylabel)
    axes.locator_params(axis="x", nbins=6)
    return figure, axes


def distance_from_axis(points, centre):
    """Horizontal distance; with a sign where there is one horizontal direction
    only. The vertical axis is the last one, and flat data have z = 0."""
    if numpy.ptp(points[:, 2]) == 0. and numpy.ptp(points[:, 1]) < 1e-10 * numpy.ptp(points[:, 0]):
        return points[:, 0] - centre[0]
    return numpy.hypot(points[:, 0] - centre[0], points[:, 1] - centre[1])


def pressure(run, arguments):
    """The contact pressure over the distance from the indenter's axis."""
    if not run.has("surface.pvd"):
        return None
    points, values = run.surface(arguments.step)
    centre = ((arguments.centre or run.numbers("Indenter/Position")) + [0., 0.])[:2]
    distance = distance_from_axis(points, centre)
    reach = 1.6 * numpy.abs(distance[values > 0.]).max(initial=0.) or numpy.abs(distance).max()
    shown = numpy.abs(distance) <= reach

    figure, axes = new_diagram("distance from the indenter's axis", "contact pressure")
    axes.plot(distance[shown], values[shown], "o", markersize=3., markeredgewidth=0., color=BLUE, label="computed")
    if arguments.hertz:
        line = numpy.linspace(min(0., distance[shown].min()), reach, 500)
        axes.plot(line, hertz_of_run(run, arguments).profile(line), color=RED, label="Hertz, same force")
        axes.legend()
    axes.set_ylim(bottom=min(0., 1.05 * values.min()))
    return figure


def convergence(run, arguments):
    """Force over unknowns of the meshes of the last load step."""
    table = run.table("statistics.csv")
    last = table["step"] == table["step"][-1]
    if not has_indenter(run) or last.sum() < 2:
        return None
    figure, axes = new_diagram("number of unknowns", "force")
    axes.plot(table["dofs"][last], table["force"][last], "o-", color=BLUE)
    axes.ticklabel_format(axis="y", useOffset=False)
    axes.set_xscale("log")
    return figure


def has_indenter(run):
    return run.parameters.get("Indenter/Type") != "none"


def is_history(run):
    return len(run.table("history.csv")["step"]) > 1


def force_depth(run, arguments):
    """Force over depth, with the tangents of Oliver and Pharr at the unloadings."""
    if not has_indenter(run) or not is_history(run):
        return None
    table = run.table("history.csv")
    figure, axes = new_diagram("depth", "force")
    axes.plot(table["depth"], table["force"], "o-", markersize=3., color=BLUE, label="computed")
    if run.has("indentation.csv"):
        tests = run.table("indentation.csv")
        for row, (depth, force, slope) in enumerate(zip(tests["max_depth"], tests["max_force"], tests["stiffness"])):
            axes.plot([depth - force / slope, depth], [0., force], "--", color=RED,
                      label=None if row else "initial slope of the unloading")
        axes.legend()
    return figure


def contact_radius(run, arguments):
    """Radius of the circle with the area of the contact, over depth."""
    if run.is_plane or not has_indenter(run) or not is_history(run):
        return None
    table = run.table("history.csv")
    figure, axes = new_diagram("depth", "contact radius")
    axes.plot(table["depth"], numpy.sqrt(table["contact_area"] * n_parts(run, arguments) / math.pi), "o-",
              markersize=3., color=BLUE)
    return figure


def energies(run, arguments):
    """Where the work of indenter, supports and tractions goes, over time."""
    if not is_history(run):
        return None
    table = run.table("history.csv")
    figure, axes = new_diagram("time", "energy")
    axes.plot(table["time"], table["external_work"], color="black", label="work done on the body")
    axes.plot(table["time"], table["plastic_work"], "--", color="black", label="plastic work")
    parts = ["dissipation", "hardening_energy", "elastic_energy"]
    axes.stackplot(table["time"], [table[part] for part in parts], colors=[RED, "#d9a441", BLUE], alpha=0.6,
                   labels=["heat", "stored by hardening", "elastic energy"])
    axes.legend(loc="upper left", bbox_to_anchor=(1., 1.))
    return figure


def stress_strain(run, arguments):
    """Nominal stress over strain of a test without indenter."""
    curve = None if has_indenter(run) or not is_history(run) else material_test.stress_strain(run)
    if curve is None:
        return None
    figure, axes = new_diagram("nominal strain", "nominal stress")
    axes.plot(*curve, "o-", markersize=3., color=BLUE)
    return figure


def reactions(run, arguments):
    """The forces of all supports over time, of a test without indenter."""
    if has_indenter(run) or not is_history(run):
        return None
    table = run.table("reactions.csv")
    figure, axes = new_diagram("time", "force of the support on the body")
    for name in list(table)[2:]:
        axes.plot(table["time"], table[name], "o-", markersize=3., label=name)
    axes.legend()
    return figure


ALL = (pressure, convergence, force_depth, contact_radius, energies, stress_strain, reactions)
