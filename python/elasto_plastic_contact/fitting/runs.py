# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs of the program for a fit: in parallel, and each only once, also after the fit has been killed."""

import concurrent.futures
import json
import threading
from dataclasses import dataclass

from ..errors import UserError
from ..files import new_file
from ..program import RunError, processor_seconds
from ..results import Results
from ..study.execution import attempt, is_finished, values_in_words

# What a run of this kind has found out stays true: no convergence (3), no equilibrium (4).
LASTING = (3, 4)

# The program does not take the entries (2), as it may with some values of the parameters.
REFUSED = 2
FAILED = "failed.json"


@dataclass(frozen=True)
class Failure:
    """A run that has not come to its end. message: what the program says."""
    message: str


class Runs:
    """The runs below a folder. n_made: how many have been made in this process."""

    def __init__(self, folder, program, at_once):
        self.folder, self.program = folder, program
        self.pool = concurrent.futures.ThreadPoolExecutor(at_once)
        self.lock, self.futures = threading.Lock(), {}
        self.n_made, self.begin = 0, processor_seconds()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.pool.shutdown(cancel_futures=True)

    def results(self, tasks):
        """The Results, or a Failure, of each task, a Case with the entries of a run. Raises UserError if the program
        cannot write, or has been ended."""
        with self.lock:
            for case, entries in tasks:
                name = case.folder(entries)
                if name not in self.futures:
                    self.futures[name] = self.pool.submit(self.make, case, entries)
        return [self.futures[case.folder(entries)].result() for case, entries in tasks]

    def make(self, case, entries):
        folder = self.folder / case.folder(entries)
        if is_finished(folder):
            return Results(folder)
        if (folder / FAILED).is_file():
            return Failure(json.loads((folder / FAILED).read_text(encoding="utf-8"))["message"])
        process = attempt(case, self.folder, entries, self.program)
        with self.lock:
            self.n_made += 1
        if process.returncode == 0:
            return Results(folder)
        message = process.stderr.strip() or f"exit status {process.returncode}"
        if process.returncode == REFUSED:  # (which files beside the case may change)
            return Failure(message)
        if process.returncode not in LASTING:
            raise RunError(process.returncode, f"the run with {values_in_words(entries)} has ended: {message}")
        folder.mkdir(parents=True, exist_ok=True)
        with new_file(folder / FAILED) as file:
            file.write(json.dumps({"entries": entries, "message": message}, indent=1) + "\n")
        return Failure(message)

    @property
    def processor_seconds(self):
        """What they took."""
        return processor_seconds() - self.begin


def first_line(failure):
    return failure.message.splitlines()[0]


def expect(result, what):
    """The Results. Raises UserError if it is a Failure."""
    if isinstance(result, Failure):
        raise UserError(f"{what} has failed: {result.message}")
    return result
