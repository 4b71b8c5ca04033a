# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plot indentation tests: force of the whole indenter over depth and, of each run in space with fields,
the deformed surface from above: height over the largest depth, zero in white, the edge of the contact
in red. Parts of a body are completed by reflection at x = 0 and y = 0.

    epc plot imprints output/vickers_finite_strain=Vickers output/berkovich_finite_strain=Berkovich \\
        --step 0 --output imprints.png
"""

import numpy
from matplotlib.tri import Triangulation

from .figures import add_runs, add_units, labelled, letter, make_parser, plt, save, units_of, with_unit
from ..arguments import number
from ..errors import NothingToShow, UserError


def completed(values, mirrored):
    """Rows (x, y, ...) and their reflections at the axes that are mirrored."""
    for axis in mirrored:
        reflected = values.copy()
        reflected[:, axis] *= -1
        values = numpy.vstack([values, reflected])
    return values


def planes_of_symmetry(run):
    """The axes at right angles to those vertical sides through the tip on which the body slides."""
    rollers = run.parameters["Boundary conditions/Roller"]
    return [axis for axis, side in enumerate(("left", "front")) if side in rollers]


def surface_from_above(run, step):
    """Present places x, y, heights and pressures, over the largest depth."""
    fields = run.fields("surface", step)
    places = fields["points"] + fields["displacement"]
    values = numpy.column_stack([places[:, :2], places[:, 2] - fields["points"][:, 2].max(),
                                 fields["contact_pressure"]])
    _, first = numpy.unique(fields["points"].round(12), axis=0, return_index=True)
    depth = run.history["depth"].max()
    values = completed(values[first], planes_of_symmetry(run))
    values[:, :3] /= depth
    near = (numpy.abs(values[:, :2]) < 8.).all(axis=1)
    return values[near]


def draw_surface(axes, run, step, name, extent):
    x, y, height, pressure = surface_from_above(run, step).T
    mesh = Triangulation(x, y)
    levels = numpy.arange(-1., 0.16, 0.05)
    colours = axes.tricontourf(mesh, height, levels=levels, cmap="viridis", extend="both")
    if height.min() < 0. < height.max():
        axes.tricontour(mesh, height, levels=[0.], colors="white", linewidths=0.8)
    if pressure.max() > 0.:
        axes.tricontour(mesh, pressure, levels=[0.5 * numpy.median(pressure[pressure > 0.])], colors="red",
                        linewidths=1.)
    axes.set(xlim=(-extent, extent), ylim=(-extent, extent), aspect="equal", xlabel=r"$x/\delta$",
             ylabel=r"$y/\delta$", title=name)
    axes.grid(False)
    return colours


def expect_test(run):
    if run.parameters.get("Indenter/Type") == "none" or len(run.history) < 2:
        raise NothingToShow(f"the run in '{run.directory}' has nothing to show for imprints: it takes an indenter and several "
                            "load steps, as by 'Loading/History'")


def main(arguments):
    parser = make_parser(__doc__, "imprints.png")
    add_units(parser)
    parser.add_argument("--step", type=int,
                        help="entry of surface.pvd, counted from 0 (default: the last)")
    parser.add_argument("--extent", type=number(above=0), help="half the side of the window over the largest depth (default: 6)")
    add_runs(parser)
    chosen = parser.parse_args(arguments)
    runs = labelled(chosen.runs)
    in_space = [(run, name) for run, name in runs
                if run.parameters["Dimension"] == "3" and run.has("surface.pvd")]
    for option, value in (("--step", chosen.step), ("--extent", chosen.extent)):
        if value is not None and not in_space:
            raise UserError(f"{option} is of surfaces from above, and none of the runs is one in space with surface.pvd")
    figure, panels = plt.subplots(1, 1 + len(in_space), figsize=(4.4 * (1 + len(in_space)), 3.8))
    panels = numpy.atleast_1d(panels)
    for run, name in runs:
        expect_test(run)
        panels[0].plot(run.history["depth"], run.history["force"] / run.modelled_part, label=name)
    units = units_of(runs[0][0], chosen)
    panels[0].set(xlabel=with_unit(r"depth $\delta$", units.length), ylabel=with_unit("force $F$", units.force))
    panels[0].legend()
    for axes, (run, name) in zip(panels[1:], in_space):
        colours = draw_surface(axes, run, -1 if chosen.step is None else chosen.step, name, chosen.extent or 6.)
    if in_space:
        figure.colorbar(colours, ax=list(panels[1:]), label=r"height over $\delta$")
    for i, axes in enumerate(panels):
        letter(axes, i)
    save(figure, chosen.output)
