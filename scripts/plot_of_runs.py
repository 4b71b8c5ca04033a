# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What scripts have in common that compare the tables of several runs in one picture."""

import argparse
import csv
import pathlib
import sys


def read_rows(directory, table):
    """The rows of a table of a run, numbers by the names of their columns."""
    with open(f"{directory}/{table}.csv", newline="") as file:
        return [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]


def draw_runs(plot, description, default_output):
    """Calls plot(plt, [(directory, label), ...]), which returns a figure, and saves it."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("runs", nargs="+", metavar="DIRECTORY[=LABEL]", help="output directory of a run")
    parser.add_argument("--output", default=default_output, help=f"the picture (default: {default_output})")
    arguments = parser.parse_args()
    runs = []
    for run in arguments.runs:
        directory, _, label = run.partition("=")
        runs.append((directory, label or directory))
    try:
        import matplotlib
        matplotlib.use("Agg")
        import matplotlib.pyplot as plt
        plt.rcParams.update({"axes.grid": True, "grid.alpha": 0.3, "legend.frameon": False, "figure.dpi": 150})
        plot(plt, runs).savefig(arguments.output, bbox_inches="tight")
        print(arguments.output)
    except ImportError as error:
        sys.exit(f"{parser.prog}: {error}. Install the Debian package python3-matplotlib.")
    except FileNotFoundError as error:
        sys.exit(f"{parser.prog}: there is no {error.filename}; {pathlib.Path(error.filename).parent} should be "
                 "the output directory of a run of the right analysis.")
