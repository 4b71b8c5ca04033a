# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plot what the meshes of one or several runs have cost: wall time, Newton steps
and linear iterations in a Newton step (their mean), over the unknowns.

    scripts/plot.py cost output/uniform="uniform" output/adaptive="adaptive" --output cost.png
"""

from .figures import draw_runs, plt
from ..tables import read_table


def read_costs(directory):
    """Columns of statistics.csv by name, meshes without any Newton step left out."""
    rows = [row for row in read_table(f"{directory}/statistics.csv") if row["newton_iterations"] > 0]
    columns = ("dofs", "wall_seconds", "newton_iterations", "linear_iterations")
    return {name: [row[name] for row in rows] for name in columns}


def plot_costs(runs, _):
    figure, (time, iterations) = plt.subplots(1, 2, figsize=(10., 4.))
    for directory, label in runs:
        costs = read_costs(directory)
        line, = time.loglog(costs["dofs"], costs["wall_seconds"], "o-", label=label)
        style = {"color": line.get_color()}
        iterations.semilogx(costs["dofs"], costs["newton_iterations"], "s:", **style)
        per_step = [linear / newton for linear, newton in zip(costs["linear_iterations"], costs["newton_iterations"])]
        iterations.semilogx(costs["dofs"], per_step, "o-", **style)
    time.set(xlabel="unknowns", ylabel="wall time for the mesh in s")
    time.legend()
    iterations.plot([], [], "ks:", label="Newton steps")
    iterations.plot([], [], "ko-", label="linear iterations in a Newton step")
    iterations.set(xlabel="unknowns")
    iterations.set_ylim(bottom=0.)
    iterations.legend()
    return figure


def main(arguments):
    draw_runs(plot_costs, __doc__, "cost.png", arguments)
