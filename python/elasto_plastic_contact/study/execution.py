# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs what has not been run yet, and looks up the numbers."""

import concurrent.futures
import contextlib
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import time

from .plan import RUN
from ..errors import UserError
from ..files import new_file
from ..program import MPI_ENVIRONMENT, command_line, has_checkpoint
from ..tables import read_table

# Written into the folder of a run when the program has ended well.
FINISHED = "finished.json"


def is_finished(folder):
    return (folder / FINISHED).is_file()


def values_in_words(run):
    return ", ".join(f"{path} = {json.dumps(value)}" for path, value in run.items())


def start(study, folder, run, program, *options):
    """The program on one run of a Case, until its end; it does not outlive the study, however that ends. (Open MPI's
    files lie in a folder of its own: in a common one, a process that ends removes what another one has just made.)"""
    guard = ["setpriv", "--pdeathsig", "KILL"] if shutil.which("setpriv") else []
    command = command_line(program, study.case, study.common | run, folder, *options, ranks=study.ranks, guard=guard)
    with tempfile.TemporaryDirectory(prefix="epc") as own:
        return subprocess.run(command, env=os.environ | MPI_ENVIRONMENT | {"TMPDIR": own}, stdin=subprocess.DEVNULL,
                              stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, check=False)


def validate(study, directory, run, program):
    """What the program has to say against a run; empty if nothing."""
    process = start(study, directory / study.folder(run), run, program, "--validate")
    return process.stderr.strip() if process.returncode else ""


def compute(study, directory, run, program):
    """Runs, or goes on with, one run. Returns the program's message if it fails, else nothing."""
    process = attempt(study, directory, run, program)
    return (process.stderr.strip() or f"exit status {process.returncode}") if process.returncode else ""


def attempt(study, directory, run, program):
    """Runs, or goes on with, one run of a Case, and notes that it is finished if it has ended well. Returns the process."""
    folder = directory / study.folder(run)
    begin = time.monotonic()
    process = start(study, folder, run, program, "--resume" if has_checkpoint(folder) else "--overwrite")
    if process.returncode != 0:
        return process
    record = {"entries": study.common | run, "seconds": round(time.monotonic() - begin, 1), "warnings": process.stderr}
    with new_file(folder / FINISHED) as file:
        file.write(json.dumps(record, indent=1) + "\n")
    return process


@contextlib.contextmanager
def pool_of(at_once):
    """Threads that begin nothing more after an error or Ctrl-C."""
    pool = concurrent.futures.ThreadPoolExecutor(at_once)
    try:
        yield pool
    finally:
        pool.shutdown(cancel_futures=True)


def execute(study, directory, program, report):
    """Runs all that are not finished, some at a time; report(text) is told of each.
    Returns the messages of those that have failed, by their folders.

    Raises UserError if the program refuses one of them, before any run begins, and if a run has been
    completed without a column that the study looks up."""
    pending = [run for run in study.runs if not is_finished(directory / study.folder(run))]
    report(f"{len(study.runs)} runs, {len(study.runs) - len(pending)} of them finished already")
    failures = {}
    with pool_of(study.at_once) as pool:
        for run, message in zip(pending, pool.map(lambda run: validate(study, directory, run, program), pending)):
            if message:
                raise UserError(f"the run with {values_in_words(run)} is refused: {message}")
        futures = {pool.submit(compute, study, directory, run, program): run for run in pending}
        for done, future in enumerate(concurrent.futures.as_completed(futures), 1):
            run = futures[future]
            folder = directory / study.folder(run)
            if future.result():
                failures[folder.name] = future.result()
            else:
                numbers_of(study, folder)
                if study.curves:
                    curve_of(study.curves, folder)
            report(f"{done} of {len(pending)}: {folder.name}, {values_in_words(run)}"
                   + (f": FAILED: {future.result()}" if future.result() else ""))
    return failures


def look_up(number, folder, place):
    """The number in the tables of a run; None if the program had nothing to write there."""
    values = column_of(number.table, number.column, folder, f"{place}/column")
    if isinstance(number.take, int):
        return values[number.take - 1] if number.take <= len(values) else None
    if not values:
        return None
    return {"last": values[-1], "first": values[0], "maximum": max(values), "minimum": min(values)}[number.take]


def column_of(table, column, folder, place):
    """A column of a table of a run, empty if the program had nothing to write there."""
    path = pathlib.Path(folder) / f"{table}.csv"
    rows = read_table(path) if path.is_file() else []
    if rows and column not in rows[0]:
        raise UserError(f"'{place}': the table '{table}' has no column '{column}'; it has {', '.join(rows[0])}")
    return [row[column] for row in rows]


def numbers_of(study, folder):
    """The numbers of a finished run, None where there is none."""
    return {name: look_up(number, folder, f"numbers/{name}") for name, number in study.numbers.items()}


def curve_of(curves, folder):
    """The curve of a finished run, two columns."""
    return [column_of(curves.table, getattr(curves, axis), folder, f"plot/curves/{axis}") for axis in "xy"]


def curves_of_runs(study, directory):
    """The values and the curve of each finished run."""
    return [(run, curve_of(study.curves, folder))
            for run, folder in ((run, directory / study.folder(run)) for run in study.runs) if is_finished(folder)]


def collect(study, directory):
    """One row for each run: its folder, its values, its numbers (None where there is none)."""
    rows = []
    for run in study.runs:
        folder = directory / study.folder(run)
        numbers = numbers_of(study, folder) if is_finished(folder) else dict.fromkeys(study.numbers)
        rows.append({RUN: folder.name, **run, **numbers})
    return rows


def missing(study, directory, rows):
    """A remark for each number that not all finished runs have."""
    for name, number in study.numbers.items():
        without = [row[RUN] for row in rows if row[name] is None and is_finished(directory / row[RUN])]
        if without:
            tables = sorted(file.stem for file in (directory / without[0]).glob("*.csv"))
            yield (f"'numbers/{name}': {len(without)} of the finished runs have no such row of '{number.table}'; "
                   f"{without[0]} has written the tables {', '.join(tables)}")
