# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The diagrams of a run: each function draws one into the axes. It raises NothingToShow, and draws
nothing, if the run has nothing to show there."""

import numpy
from matplotlib.ticker import LogLocator, NullFormatter, StrMethodFormatter

from . import material_test
from .figures import BLUE, RED
from .quantities import hertz_of_run, shown_entry
from ..errors import NothingToShow, UserError
from ..results import ORIGINS


def label(axes, x, y):
    axes.set(xlabel=x, ylabel=y)
    axes.locator_params(axis="x", nbins=6)


def beside(axes):
    """The legend, where no curve can be."""
    axes.legend(loc="upper left", bbox_to_anchor=(1., 1.))


def distance_from_axis(points, centre, dimension):
    """Horizontal distance; with a sign where there is one horizontal direction
    only."""
    if dimension == 2:
        return points[:, 0] - centre[0]
    return numpy.hypot(points[:, 0] - centre[0], points[:, 1] - centre[1])


def pressure(run, arguments, scales, axes):
    """The contact pressure over the distance from the indenter's axis."""
    expect(run.has("surface.pvd"), "it takes an indenter, and 'Output/Fields' other than 'never'")
    surface = run.fields("surface", shown_entry(run, arguments)[0])
    if "contact_pressure" not in surface:
        raise UserError(f"'{run.path('surface.pvd')}' leads to no field 'contact_pressure'")
    points, values = surface["points"], surface["contact_pressure"]
    centre = ((arguments.centre or run.numbers("Indenter/Position")) + [0., 0.])[:2]
    distance = distance_from_axis(points, centre, run.number("Dimension"))
    reach = 1.6 * numpy.abs(distance[values > 0.]).max(initial=0.) or numpy.abs(distance).max()
    shown = numpy.abs(distance) <= reach

    label(axes, scales.length.label("distance from the axis", "r" if distance.min() >= 0. else "x"),
          scales.stress.label("contact pressure", "p"))
    # (each cell has written its own points)
    dots = numpy.unique(numpy.column_stack([distance, values])[shown], axis=0)
    axes.plot(dots[:, 0] / scales.length.unit, dots[:, 1] / scales.stress.unit, "o", markersize=3.,
              markeredgewidth=0., color=BLUE, label="computed")
    if arguments.hertz:
        line = numpy.linspace(min(0., distance[shown].min()), reach, 500)
        axes.plot(line / scales.length.unit, hertz_of_run(run, arguments).profile(line) / scales.stress.unit,
                  color=RED, label="Hertz, same force")
        axes.legend()
    axes.set_ylim(bottom=min(0., 1.05 * values.min() / scales.stress.unit))


def convergence(run, _, scales, axes):
    """Force over unknowns of the meshes of the last load step."""
    expect_indenter(run)
    table = run.statistics
    last = table["step"] == table["step"][-1]
    expect(last.sum() > 1, "it takes several meshes in the last load step, as by 'Refinement/Number of cycles'")
    axes.set(xlabel="number of unknowns", ylabel=scales.force.label("force", "F"), xscale="log")
    axes.plot(table["dofs"][last], table["force"][last] / scales.force.unit, "o-", color=BLUE)


def expect(is_there, otherwise):
    if not is_there:
        raise NothingToShow(otherwise)


def has_indenter(run):
    return run.parameters.get("Indenter/Type") != "none"


def expect_indenter(run):
    expect(has_indenter(run), "it takes an indenter")


def expect_no_indenter(run):
    expect(not has_indenter(run), "it is for bodies without indenter")


def expect_history(run):
    expect(len(run.history) > 1, "it takes several load steps, as by 'Loading/Number of steps'")


def force_depth(run, _, scales, axes):
    """Force over depth, with the tangents of Oliver and Pharr at the unloadings."""
    expect_indenter(run)
    expect_history(run)
    table, depth_unit, force_unit = run.history, scales.length.unit, scales.force.unit
    label(axes, scales.length.label("depth", r"\delta"), scales.force.label("force", "F"))
    axes.plot(table["depth"] / depth_unit, table["force"] / force_unit, "o-", markersize=3., color=BLUE,
              label="computed")
    if run.has("indentation.csv"):
        tests = run.unloadings
        for row, (depth, force, slope) in enumerate(zip(tests["max_depth"], tests["max_force"], tests["stiffness"])):
            axes.plot(numpy.array([depth - force / slope, depth]) / depth_unit, [0., force / force_unit], "--",
                      color=RED, label=None if row else "initial slope of unloading")
        axes.legend()


def contact_radius(run, _, scales, axes):
    """Radius of the circle with the area of the contact, over depth."""
    expect_indenter(run)
    expect(not run.is_plane, "it takes an axisymmetric body, or one in space")
    expect_history(run)
    label(axes, scales.length.label("depth", r"\delta"), scales.length.label("contact radius", "a"))
    axes.plot(run.history["depth"] / scales.length.unit, run.history["contact_radius"] / scales.length.unit,
              "o-", markersize=3., color=BLUE)


def expect_rate_law(run):
    laws = run.parameters.get("Material/Rate law", "none").split(",")
    expect(any(law.strip() != "none" for law in laws), "it takes a material with a 'Rate law'")


def depth_time(run, _, scales, axes):
    """Depth over time, and the force beside it, of a material with a rate law."""
    expect_indenter(run)
    expect_rate_law(run)
    expect_history(run)
    table = run.history
    label(axes, "time", scales.length.label("depth", r"\delta"))
    time = numpy.append(0., table["time"])
    axes.plot(time, numpy.append(0., table["depth"]) / scales.length.unit, color=BLUE)
    axes.yaxis.label.set_color(BLUE)
    axes.set_ylim(bottom=min(0., table["depth"].min()))
    of_force = axes.twinx()
    of_force.plot(time, numpy.append(0., table["force"]) / scales.force.unit, "--", color=RED)
    of_force.set_ylim(bottom=0.)
    of_force.set_ylabel(scales.force.label("force", "F"), color=RED)
    of_force.spines["right"].set_visible(True)
    of_force.grid(False)


def hardness_rate(run, _, scales, axes):
    """Hardness over the rate of the depth over the depth, of the steps in which the depth grows, and the lines
    that holds and jumps give, whose slope is the rate sensitivity (doc/theory/rate_dependence.md)."""
    expect_indenter(run)
    expect_rate_law(run)
    expect(not run.is_plane, "it takes an axisymmetric body, or one in space")
    rates, hardness, of_step = hardness_at_rates(run.history)
    expect(len(rates) > 1, "it takes several load steps in which the depth grows")
    axes.set(xlabel="rate of the depth over the depth", ylabel=scales.stress.label("hardness", "H"), xscale="log", yscale="log")
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(LogLocator(subs=(1., 2., 5.)))
        axis.set_major_formatter(StrMethodFormatter("{x:g}"))
        axis.set_minor_formatter(NullFormatter())
    axes.plot(rates, hardness / scales.stress.unit, "o", markersize=3., color=BLUE, label="load steps")
    tests = run.indentation if run.has("indentation.csv") else []
    for column, name in (("jump_rate_sensitivity", "jump"), ("hold_rate_sensitivity", "hold")):
        for test in tests:
            m = test[column]
            if numpy.isfinite(m) and test["step"] in of_step:
                end = of_step[test["step"]]
                line = numpy.array([rates.min(), rates.max()])
                axes.plot(line, hardness[end] * (line / rates[end]) ** m / scales.stress.unit, "-" if name == "jump" else "--",
                          linewidth=0.8, color=RED, label=f"{name}, $m$ = {m:.3g}")
    beside(axes)


def hardness_at_rates(table):
    """(d depth / dt) / depth and force / contact area at the ends of the steps of history.csv in which the depth
    grows and there is a contact, and the indices of these by the numbers of the steps."""
    duration = numpy.diff(table["time"])
    before, after = table["depth"][:-1], table["depth"][1:]
    grows = numpy.flatnonzero((before > 0.) & (after > before) & (table["contact_area"][1:] > 0.))
    rates = numpy.log(after[grows] / before[grows]) / duration[grows]
    rows = table[1:][grows]
    return rates, rows["force"] / rows["contact_area"], {step: i for i, step in enumerate(rows["step"])}


def steps_of_imprint(run, table):
    """Of the steps in surface_profile.csv the one with the largest depth and, unless the force goes on to grow,
    the later one with the smallest force, with their names."""
    written = run.history[numpy.isin(run.history["step"], table["step"])]
    deepest = int(written["depth"].argmax())
    later = written[deepest:]
    lowest = int(later["force"].argmin())
    steps = {"at the largest depth": written["step"][deepest]}
    if lowest > 0:
        steps[name_of_later(later[lowest], later[0])] = later["step"][lowest]
    return steps


def name_of_later(row, deepest):
    """What to call a row of history.csv that follows the deepest one, with a smaller force."""
    if row["force"] < 0.01 * deepest["force"]:
        return "after unloading"
    return "unloaded in part" if row["depth"] < (1. - 1e-9) * deepest["depth"] else "after relaxation"


def imprint(run, arguments, scales, axes):
    """The deformed contact surface, in three dimensions along the first line, under load and after it."""
    expect(has_indenter(run) and run.has("surface_profile.csv"), ORIGINS["surface_profile.csv"])
    table = run.table("surface_profile")
    if "line" in table.dtype.names:
        table = table[table["line"] == 1.]
    axes_of_plane = [name for name in "xy" if name in table.dtype.names]
    centre = ((arguments.centre or run.numbers("Indenter/Position")) + [0., 0.])[:2]
    direction = numpy.array([table[name][-1] - table[name][0] for name in axes_of_plane])
    direction /= numpy.linalg.norm(direction)
    reach = 3. * run.history["contact_radius"].max() or numpy.inf
    surface, unit = table["height"].max(), scales.length.unit

    label(axes, scales.length.label("distance from the axis", "r" if run.is_axisymmetric else "x"),
          scales.length.label("height of the surface", "z"))
    axes.axhline(0., color="gray", linewidth=0.8)
    for (name, step), style in zip(steps_of_imprint(run, table).items(), ({"color": RED}, {"color": BLUE})):
        rows = table[table["step"] == step]
        place = sum((rows[axis] - c + rows[f"displacement_{axis}"]) * d
                    for axis, c, d in zip(axes_of_plane, centre, direction))
        vertical = "xyz"[len(axes_of_plane)]
        height = rows["height"] + rows[f"displacement_{vertical}"] - surface
        shown = numpy.abs(place) <= reach
        axes.plot(place[shown] / unit, height[shown] / unit, "o-", markersize=2., label=name, **style)
    axes.legend()


def energies(run, _, scales, axes):
    """Where the work of indenter, supports and tractions goes, over time."""
    expect_history(run)
    table, unit = run.history, scales.energy.unit
    label(axes, "time", scales.energy.label("energy", "W"))
    axes.plot(table["time"], table["external_work"] / unit, color="black", label="work done on the body")
    axes.plot(table["time"], table["plastic_work"] / unit, "--", color="black", label="plastic work")
    parts = ["dissipation", "hardening_energy", "elastic_energy"]
    axes.stackplot(table["time"], [table[part] / unit for part in parts], colors=[RED, "#d9a441", BLUE], alpha=0.6,
                   labels=["heat", "stored by hardening", "elastic energy"])
    beside(axes)


def stress_strain(run, _, scales, axes):
    """Nominal stress over strain of a test without indenter."""
    expect_no_indenter(run)
    expect_history(run)
    curve = material_test.stress_strain(run)
    expect(curve is not None, "it takes a box that is loaded along an axis, with a support at one of both ends")
    label(axes, "nominal strain", scales.stress.label("nominal stress", r"\sigma"))
    axes.plot(curve[0], curve[1] / scales.stress.unit, "o-", markersize=3., color=BLUE)


def reactions(run, _, scales, axes):
    """The forces of all supports over time, of a test without indenter."""
    expect_no_indenter(run)
    expect_history(run)
    table = run.reactions
    label(axes, "time", scales.force.label("force of the support on the body", "F"))
    for name in table.dtype.names[2:]:
        axes.plot(table["time"], table[name] / scales.force.unit, "o-", markersize=3., label=name)
    beside(axes)


ALL = (pressure, convergence, force_depth, depth_time, hardness_rate, contact_radius, imprint, energies, stress_strain,
       reactions)
