#!/usr/bin/python3
# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plot how far the error bounds of one or several runs have come (Analysis = contact with
error bound): the bound over the unknowns, and force or depth of both methods.

    scripts/plot_bounds.py output/by_bound="by the bound" output/by_kelly="by Kelly" --output bounds.png

Needs matplotlib (Debian package python3-matplotlib).
"""

import argparse
import csv
import sys


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("runs", nargs="+", metavar="DIRECTORY[=LABEL]", help="output directory of a run")
    parser.add_argument("--output", default="bounds.png", help="the picture (default: bounds.png)")
    return parser.parse_args()


def read_columns(directory):
    """Columns of error_bound.csv by name."""
    with open(f"{directory}/error_bound.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    return {name: [float(row[name]) for row in rows] for name in rows[0]}


def plot_bounds(plt, runs):
    figure, (bound, answer) = plt.subplots(1, 2, figsize=(10., 4.))
    for run in runs:
        directory, _, label = run.partition("=")
        columns = read_columns(directory)
        line, = bound.loglog(columns["dofs"], columns["relative_bound"], "o-", label=label or directory)
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


def main():
    arguments = parse_arguments()
    try:
        import matplotlib
        matplotlib.use("Agg")
        import matplotlib.pyplot as plt
        plt.rcParams.update({"axes.grid": True, "grid.alpha": 0.3, "legend.frameon": False, "figure.dpi": 150})
        plot_bounds(plt, arguments.runs).savefig(arguments.output, bbox_inches="tight")
        print(arguments.output)
    except ImportError as error:
        sys.exit(f"plot_bounds.py: {error}. Install the Debian package python3-matplotlib.")
    except FileNotFoundError as error:
        sys.exit(f"plot_bounds.py: there is no {error.filename}. Run a case with "
                 "'Analysis = contact with error bound' first.")


if __name__ == "__main__":
    main()
