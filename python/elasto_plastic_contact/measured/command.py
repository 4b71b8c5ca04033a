# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command evaluate for the files of instruments: prints, writes JSON, draws."""

from ..errors import UserError
from .columns import given_columns
from .evaluate_files import evaluate_files
from .evaluate_results import evaluate_results
from .report import as_json, print_evaluation, print_means, print_results, results_as_json, write_json
from .results import ResultsTable
from .units import given_units


def evaluate_and_show(arguments):
    """Returns the exit status."""
    for kind in ("length", "force"):
        if getattr(arguments, f"{kind}_unit"):
            raise UserError(f"--{kind}-unit is that of a run, and there is none: give it by --run, or the unit of the "
                            "file by --unit")
    chosen = given_columns(arguments.columns[0]) if arguments.columns else {}
    found = evaluate_files(arguments, chosen, given_units(arguments.unit))
    if isinstance(found, ResultsTable):
        return show_results(found, arguments)
    print_evaluation(found)
    if arguments.json:
        write_json(as_json(found), arguments.json)
        print(arguments.json)
    if arguments.output:
        from ..plots.measured import draw  # (which needs matplotlib)
        draw(found, arguments.output)
    return 0


def show_results(results, arguments):
    """Of a table of results: means, and, with a tip, what follows of slope, largest depth and force."""
    path, = arguments.curve
    if arguments.output:
        raise UserError(f"'{path}' holds results, one row an indent, and no curve to draw: leave out --output")
    print_results(results, path)
    evaluated = evaluate_results(results, arguments, path)
    if evaluated:
        rows, sentences = evaluated
        print("", *sentences, sep="\n")
        print_means(rows)
    if arguments.json:
        write_json(results_as_json(results, evaluated[0] if evaluated else []), arguments.json)
        print(arguments.json)
    return 0
