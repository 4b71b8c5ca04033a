#!/usr/bin/python3
# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plot how far the error bounds of one or several runs have come (Analysis = contact with
error bound): the bound over the unknowns, and force or depth of both methods.

    scripts/plot_bounds.py output/by_bound="by the bound" output/by_kelly="by Kelly" --output bounds.png

Needs matplotlib (Debian package python3-matplotlib).
"""

from plot_of_runs import draw_runs
from verification_runner import read_table


def plot_bounds(plt, runs):
    figure, (bound, answer) = plt.subplots(1, 2, figsize=(10., 4.))
    for directory, label in runs:
        rows = read_table(f"{directory}/error_bound.csv")
        columns = {name: [row[name] for row in rows] for name in rows[0]}
        line, = bound.loglog(columns["dofs"], columns["relative_bound"], "o-", label=label)
        # what has been prescribed is the same for both methods
        prescribed_depth = columns["depth"] == columns["equilibrium_depth"]
        quantity = "force" if prescribed_depth else "depth"
        style = {"color": line.get_color()}
        answer.semilogx(columns["dofs"], columns[quantity], "o-", **style)
        answer.semilogx(columns["dofs"], columns[f"equilibrium_{quantity}"], "s:", **style)
        answer.set(ylabel=quantity)
    bound.set(xlabel="unknowns of the displacement method", ylabel="bound, relative to the energy")
    bound.legend()
    answer.plot([], [], "ko-", label="displacement method")
    answer.plot([], [], "ks:", label="equilibrium method")
    answer.set(xlabel="unknowns of the displacement method")
    answer.legend()
    return figure


if __name__ == "__main__":
    draw_runs(plot_bounds, __doc__, "bounds.png")
