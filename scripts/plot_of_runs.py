# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What scripts have in common that draw several runs in one picture."""

import argparse
import pathlib
import sys

from verification_runner import ROOT, Runner


def draw_runs(plot, description, default_output):
    """Calls plot(plt, [(directory, label), ...]), which returns a figure, and saves it."""
    parser = make_parser(description, default_output)
    parser.add_argument("runs", nargs="+", metavar="DIRECTORY[=LABEL]", help="output directory of a run")
    arguments = parser.parse_args()
    runs = []
    for run in arguments.runs:
        directory, _, label = run.partition("=")
        runs.append((directory, label or directory))
    try:
        save(lambda plt: plot(plt, runs), arguments.output, parser.prog)
    except FileNotFoundError as error:
        sys.exit(f"{parser.prog}: there is no {error.filename}; {pathlib.Path(error.filename).parent} should be "
                 "the output directory of a run of the right analysis.")


def draw_own_runs(plot, description, default_output):
    """Calls plot(plt, runner), which runs the program and returns a figure, and saves it."""
    parser = make_parser(description, default_output)
    parser.add_argument("--program", default=ROOT / "build/release/elasto_plastic_contact")
    arguments = parser.parse_args()
    save(lambda plt: plot(plt, Runner(arguments.program, 1)), arguments.output, parser.prog)


def make_parser(description, default_output):
    """Of the arguments, with --output."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--output", default=default_output, help=f"the picture (default: {default_output})")
    return parser


def save(plot, output, script):
    """Saves the figure that plot(plt) returns."""
    try:
        import matplotlib
        matplotlib.use("Agg")
        import matplotlib.pyplot as plt
    except ImportError as error:
        sys.exit(f"{script}: {error}. Install the Debian package python3-matplotlib.")
    plt.rcParams.update({"axes.grid": True, "grid.alpha": 0.3, "legend.frameon": False, "figure.dpi": 150})
    plot(plt).savefig(output, bbox_inches="tight")
    print(output)
