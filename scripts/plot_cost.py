#!/usr/bin/python3
# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plot what the meshes of one or several runs have cost: wall time, Newton steps
and linear iterations in a Newton step (their mean), over the unknowns.

    scripts/plot_cost.py output/uniform="uniform" output/adaptive="adaptive" --output cost.png

Needs matplotlib (Debian package python3-matplotlib).
"""

import argparse
import csv
import sys


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("runs", nargs="+", metavar="DIRECTORY[=LABEL]", help="output directory of a run")
    parser.add_argument("--output", default="cost.png", help="the picture (default: cost.png)")
    return parser.parse_args()


def read_costs(directory):
    """Columns of statistics.csv by name, meshes without any Newton step left out."""
    with open(f"{directory}/statistics.csv", newline="") as file:
        rows = [row for row in csv.DictReader(file) if int(row["newton_iterations"]) > 0]
    columns = ("dofs", "wall_seconds", "newton_iterations", "linear_iterations")
    return {name: [float(row[name]) for row in rows] for name in columns}


def plot_costs(plt, runs):
    figure, (time, iterations) = plt.subplots(1, 2, figsize=(10., 4.))
    for run in runs:
        directory, _, label = run.partition("=")
        costs = read_costs(directory)
        line, = time.loglog(costs["dofs"], costs["wall_seconds"], "o-", label=label or directory)
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


def main():
    arguments = parse_arguments()
    try:
        import matplotlib
        matplotlib.use("Agg")
        import matplotlib.pyplot as plt
        plt.rcParams.update({"axes.grid": True, "grid.alpha": 0.3, "legend.frameon": False, "figure.dpi": 150})
        plot_costs(plt, arguments.runs).savefig(arguments.output, bbox_inches="tight")
    except ImportError as error:
        sys.exit(f"plot_cost.py: {error}: Debian package python3-matplotlib")
    except OSError as error:
        sys.exit(f"plot_cost.py: '{error.filename}': {error.strerror}")
    print(arguments.output)


if __name__ == "__main__":
    main()
