# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run one case with all combinations of some values, or with those of a list, several runs at
a time, and collect numbers from their tables: study.csv and study.png. Each run has a folder
of its own. A study that has been interrupted goes on where it was: what is finished is not
run again. doc/recipes/studies.md describes the file.

    epc study study.json --output-directory output/study
"""

import csv
import fcntl
import functools
import pathlib
import sys

from .execution import collect, curves_of_runs, execute, missing
from .plan import read_study
from ..arguments import CommandParser
from ..errors import FileError, UserError
from ..files import new_file
from ..program import add_program, as_text, find_program

def open_folder(directory, kind):
    """Makes the folder of a study or of another kind of command, and locks it until the end of the process."""
    lock = directory / f"{kind}.lock"
    if directory.is_dir() and any(directory.iterdir()) and not lock.exists():
        raise UserError(f"'{directory}' holds other things than a {kind}: choose another --output-directory")
    try:
        directory.mkdir(parents=True, exist_ok=True)
        lock = lock.open("a")
    except OSError as error:
        raise FileError(directory, error) from None
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        raise UserError(f"another {kind} is running in '{directory}'") from None
    return lock


def write_table(rows, path):
    with new_file(path) as file:
        writer = csv.writer(file)
        writer.writerow(rows[0])
        for row in rows:
            writer.writerow("" if value is None else as_text(value) for value in row.values())
    print(path)


def main(arguments):
    parser = CommandParser("study", __doc__)
    parser.add_argument("study", type=pathlib.Path, help="the file (JSON)")
    parser.add_argument("--output-directory", type=pathlib.Path,
                        help="where the results go (default: output/ and the name of the file)")
    parser.add_argument("--no-plot", action="store_true", help="write the table only")
    add_program(parser)
    chosen = parser.parse_args(arguments)
    program = find_program(chosen.program)
    study = read_study(chosen.study, program)
    directory = chosen.output_directory or pathlib.Path("output") / chosen.study.stem
    with open_folder(directory, "study"):
        failures = execute(study, directory, program, functools.partial(print, flush=True))
        rows = collect(study, directory)
        for remark in missing(study, directory, rows):
            print(remark, file=sys.stderr)
        write_table(rows, directory / "study.csv")
        if not chosen.no_plot:
            from ..plots.study import draw, draw_curves  # (which need matplotlib)
            draw(study, rows, directory / "study.png")
            if study.curves:
                draw_curves(study, curves_of_runs(study, directory), directory / "curves.png")
    return 1 if failures else 0
