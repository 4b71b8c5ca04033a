# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plot how far the error bounds of one or several runs have come (Analysis = contact with
error bound): the bound over the unknowns, and force or depth of both methods.

    epc plot bounds output/by_bound="by the bound" output/by_kelly="by Kelly" --output bounds.png
"""

from .figures import draw_runs, letter, plt, units_of, with_unit


def plot_bounds(runs, arguments):
    figure, (bound, answer) = plt.subplots(1, 2, figsize=(12., 4.))
    for run, label in runs:
        columns = run.table("error_bound")
        line, = bound.loglog(columns["dofs"], columns["relative_bound"], "o-", label=label)
        # what has been prescribed is the same for both methods
        prescribed_depth = (columns["depth"] == columns["equilibrium_depth"]).all()
        quantity = "force" if prescribed_depth else "depth"
        style = {"color": line.get_color()}
        answer.semilogx(columns["dofs"], columns[quantity], "o-", **style)
        answer.semilogx(columns["dofs"], columns[f"equilibrium_{quantity}"], "s:", **style)
        units = units_of(run, arguments)
        answer.set(ylabel=with_unit(quantity, units.force if prescribed_depth else units.length))
    bound.set(xlabel="unknowns of the displacement method", ylabel="bound, relative to the energy")
    answer.plot([], [], "ko-", label="displacement method")
    answer.plot([], [], "ks:", label="equilibrium method")
    answer.set(xlabel="unknowns of the displacement method")
    handles = [axes.get_legend_handles_labels() for axes in (bound, answer)]
    answer.legend(*(first + second for first, second in zip(*handles)), loc="upper left", bbox_to_anchor=(1., 1.))
    for i, axes in enumerate((bound, answer)):
        letter(axes, i)
    return figure


def main(arguments):
    draw_runs(plot_bounds, __doc__, "bounds.png", arguments)
