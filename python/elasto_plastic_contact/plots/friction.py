# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plot a contact with friction in the plane: at the steps of surface_profile.csv, the shear traction below
its limit, the friction coefficient times the pressure; and the horizontal over the vertical force through time.

    scripts/plot.py friction output/mindlin_cylinder --output friction.png
"""

import numpy

from .figures import add_units, make_parser, plt, save, units_of, with_unit
from ..results import Results


def draw_tractions(axes, rows, coefficient, colour):
    """Shear of one step, and what it may be."""
    touched = rows["contact_pressure"] > 0
    limit = coefficient * rows["contact_pressure"][touched]
    x = rows["x"][touched]
    axes.plot(x, limit, "--", color=colour, linewidth=0.8)
    axes.plot(x, -limit, "--", color=colour, linewidth=0.8)
    axes.plot(x, rows["contact_shear_x"][touched], color=colour, label=f"$t$ = {rows['time'][0]:g}")


def main(arguments):
    parser = make_parser(__doc__, "friction.png")
    add_units(parser)
    parser.add_argument("directory", metavar="DIRECTORY", help="output directory of a run in the plane")
    chosen = parser.parse_args(arguments)
    run = Results(chosen.directory)
    units = units_of(run, chosen)
    coefficient = float(run.parameters["Contact/Friction coefficient"])
    profile, history = run.table("surface_profile"), run.history

    figure, (tractions, forces) = plt.subplots(1, 2, figsize=(9., 3.8))
    steps = numpy.unique(profile["step"])
    for index, step in enumerate(steps):
        rows = profile[profile["step"] == step]
        draw_tractions(tractions, rows, coefficient, f"C{index}")
    tractions.set(xlabel=with_unit("$x$", units.length), ylabel=with_unit("shear traction", units.stress))
    tractions.legend()
    forces.plot(history["time"], history["tangential_force_x"] / history["force"], label="$Q/P$")
    for sign in (1, -1):
        forces.axhline(sign * coefficient, linestyle="--", color="grey", linewidth=0.8)
    forces.plot(history["time"], history["stick_area"] / history["contact_area"], label="part that sticks")
    forces.set(xlabel="time $t$")
    forces.legend(loc=(0.02, 0.1))
    save(figure, chosen.output)
