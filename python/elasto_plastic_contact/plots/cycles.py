# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plot cycles of the force, of one or several runs: force over depth, and how far the indenter sinks
from cycle to cycle, at the largest force and at the smallest one.

    epc plot cycles output/isotropic="isotropic hardening" output/kinematic="kinematic" --output cycles.svg
"""

import numpy

from .figures import draw_runs, letter, plt, units_of, with_unit
from ..errors import UserError


def turning_points(force):
    """Rows of the history at which the force goes from rising to falling, and from falling to rising
    (or ends)."""
    rises = numpy.diff(force, prepend=0., append=-numpy.inf) > 0.
    peaks = numpy.flatnonzero(rises[:-1] & ~rises[1:])
    valleys = numpy.flatnonzero(~rises[:-1] & numpy.append(rises[1:-1], True))
    return peaks, valleys


def add_run(run, label, units, loops, drift, colour):
    history = run.history
    depth, force = history["depth"], history["force"] / run.modelled_part
    peaks, valleys = turning_points(force)
    if len(peaks) < 2:
        raise UserError(f"there are no cycles in '{label}': the force turns back less than twice; it "
                        "takes an indenter and a 'Loading/History' such as 1: force 9 | 2: force 1 | 3: force 9 | 4: force 1")
    loops.plot(depth, force, color=colour, linewidth=1.)
    loops.set(title=label, xlabel=with_unit(r"depth $\delta$", units.length),
              ylabel=with_unit("force $F$", units.force))
    loops.locator_params(axis="x", nbins=4)
    for rows, style in ((peaks, "o-"), (valleys, "s:")):
        drift.plot(numpy.arange(1, len(rows) + 1), depth[rows] - depth[rows[0]], style, markersize=4., color=colour)


def plot_cycles(runs, arguments):
    figure, panels = plt.subplots(1, len(runs) + 1, figsize=(4.2 * (len(runs) + 1), 3.8))
    drift = panels[-1]
    for i, (run, label) in enumerate(runs):
        units = units_of(run, arguments)
        add_run(run, label, units, panels[i], drift, f"C{i}")
        drift.plot([], [], color=f"C{i}", label=label)
    drift.plot([], [], "ko-", markersize=4., label="at the largest force")
    drift.plot([], [], "ks:", markersize=4., label="at the smallest force")
    drift.set(xlabel="cycle", ylabel=with_unit(r"$\delta$ beyond that of the first cycle", units.length))
    drift.ticklabel_format(axis="y", style="sci", scilimits=(0, 0))
    drift.xaxis.get_major_locator().set_params(integer=True)
    drift.legend(loc="upper left", bbox_to_anchor=(1., 1.))
    for i, axes in enumerate(panels):
        letter(axes, i)
    return figure


def main(arguments):
    draw_runs(plot_cycles, __doc__, "cycles.png", arguments)
