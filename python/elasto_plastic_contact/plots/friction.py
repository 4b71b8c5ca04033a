# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plot a contact with friction in the plane: at the steps of surface_profile.csv, the shear traction below
its limit, the friction coefficient times the pressure; and the horizontal over the vertical force through time,
with the part of the contact that sticks. A body that sticks everywhere (Friction coefficient = stick) has no limit.

    epc plot friction output/mindlin_cylinder --output friction.svg
"""

import numpy

from .figures import add_units, make_parser_of_one_run, plt, save, units_of, with_unit
from ..errors import NothingToShow
from ..results import Results


def limit_of(run):
    """The friction coefficient; None if the body sticks to the indenter without a limit."""
    entry = "Contact/Friction coefficient"
    if run.parameters.get("Dimension") == "3":
        raise NothingToShow(f"the run in '{run.directory}' is of a body in space, this diagram of one in the plane: ParaView "
                            "shows 'contact_shear', in surface.pvd")
    if run.parameters.get(entry) != "stick" and run.number(entry) == 0.:
        raise NothingToShow(f"the run in '{run.directory}' is without friction: it takes a '{entry}' above 0, or stick")
    return None if run.parameters.get(entry) == "stick" else run.number(entry)


def ratio(part, whole):
    """Not a number, which is a gap in a curve, where there is no contact."""
    return numpy.divide(part, whole, out=numpy.full_like(whole, numpy.nan), where=whole > 0)


def name_curves(axes):
    """Above the axes: there is hardly a place inside where no curve is."""
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.), ncols=4)


def draw_tractions(axes, profile, limit):
    """Shear in the contact at each step that has one, and what it may be."""
    touched = profile[profile["contact_pressure"] > 0]
    for index, step in enumerate(numpy.unique(touched["step"])):
        rows = touched[touched["step"] == step]
        line, = axes.plot(rows["x"], rows["contact_shear_x"], color=f"C{index}", label=f"$t$ = {rows['time'][0]:g}")
        for sign in () if limit is None else (1, -1):
            axes.plot(rows["x"], sign * limit * rows["contact_pressure"], "--", color=line.get_color(), linewidth=0.8)
    if len(touched):
        name_curves(axes)


def draw_forces(axes, history, limit):
    axes.plot(history["time"], ratio(history["tangential_force_x"], history["force"]), label="$Q/P$")
    if limit is not None:
        axes.plot(history["time"], ratio(history["stick_area"], history["contact_area"]), label="part that sticks")
        for sign in (1, -1):
            axes.axhline(sign * limit, linestyle="--", color="grey", linewidth=0.8)
    name_curves(axes)


def main(arguments):
    parser = make_parser_of_one_run(__doc__, "friction")
    add_units(parser)
    chosen = parser.parse_args(arguments)
    run = Results(chosen.directory)
    run.expect("history.csv")
    units, limit = units_of(run, chosen), limit_of(run)

    figure, (tractions, forces) = plt.subplots(1, 2, figsize=(9., 3.8))
    draw_tractions(tractions, run.table("surface_profile"), limit)
    tractions.set(xlabel=with_unit("$x$", units.length), ylabel=with_unit("shear traction", units.stress))
    draw_forces(forces, run.history, limit)
    forces.set(xlabel="time $t$")
    save(figure, chosen.output or run.path("friction.png"))
