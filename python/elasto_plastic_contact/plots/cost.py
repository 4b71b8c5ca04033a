# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plot what the meshes of one or several runs have cost: wall time, Newton steps
and linear iterations in a Newton step (their mean), over the unknowns.

    epc plot cost output/uniform="uniform" output/adaptive="adaptive" --output cost.png
"""

from .figures import add_runs, labelled, make_parser, plt, save
from ..errors import NothingToShow


def costs_of(run):
    """The rows of statistics.csv, meshes without any Newton step left out."""
    costs = run.statistics[run.statistics["newton_iterations"] > 0]
    if not len(costs):
        raise NothingToShow(f"the run in '{run.directory}' has nothing to show for cost: no mesh has needed a Newton step")
    return costs


def plot_costs(runs):
    figure, (time, iterations) = plt.subplots(1, 2, figsize=(10., 4.))
    for run, label in runs:
        costs = costs_of(run)
        line, = time.loglog(costs["dofs"], costs["wall_seconds"], "o-", label=label)
        style = {"color": line.get_color()}
        iterations.semilogx(costs["dofs"], costs["newton_iterations"], "s:", **style)
        iterations.semilogx(costs["dofs"], costs["linear_iterations"] / costs["newton_iterations"], "o-", **style)
    time.set(xlabel="unknowns", ylabel="wall time for the mesh in s")
    time.legend()
    iterations.plot([], [], "ks:", label="Newton steps")
    iterations.plot([], [], "ko-", label="linear iterations in a Newton step")
    iterations.set(xlabel="unknowns")
    iterations.set_ylim(bottom=0.)
    iterations.legend()
    return figure


def main(arguments):
    parser = make_parser(__doc__, "cost.png")
    add_runs(parser)
    chosen = parser.parse_args(arguments)
    save(plot_costs(labelled(chosen.runs)), chosen.output)
