# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs with several values of 'Contact/Edge', without a word, each only once; tables of what they give."""

import json
import os
import pathlib
import subprocess
import tempfile
import time

from elasto_plastic_contact.fields import read_fields
from elasto_plastic_contact.program import MPI_ENVIRONMENT, add_program, command_line, find_program, ready_case
from elasto_plastic_contact.tables import read_tables

# What 'Contact/Edge' is without the entry.
DEFAULT = "default"
# One core may have to do for several ranks.
SHARED_CORE = {"OMPI_MCA_mpi_yield_when_idle": "1", "OMPI_MCA_hwloc_base_binding_policy": "none"}


class EdgeRuns:
    """Runs of one program."""

    def __init__(self, program):
        self.program = find_program(program)
        self.finished = {}

    def tables(self, case, entries, edge=DEFAULT, ranks=1, environment=()):
        """The rows of all tables of a run, by their names; under 'seconds' how long it took.

        entries: 'Section/Entry' to value; environment: pairs of a variable and its value."""
        key = (str(case), tuple(entries.items()), edge, ranks, environment)
        if key not in self.finished:
            self.finished[key] = self.run(case, entries, edge, ranks, environment)
        return self.finished[key]

    def run(self, case, entries, edge, ranks=1, environment=(), fields=None):
        """The same anew; under 'fields' those of this kind at the end, such as 'surface'.
        Raises subprocess.CalledProcessError with the program's own message in 'stderr'."""
        changes = {"Output/Fields": "last cycle" if fields else "never"} | entries
        if edge != DEFAULT:
            changes["Contact/Edge"] = edge
        with tempfile.TemporaryDirectory() as folder:
            command = command_line(self.program, ready_case(case, self.program), changes, folder, "--overwrite", ranks=ranks)
            begin = time.monotonic()
            subprocess.run(command, check=True, env=os.environ | MPI_ENVIRONMENT | SHARED_CORE | dict(environment),
                           stderr=subprocess.PIPE, text=True)
            results = read_tables(folder) | {"seconds": time.monotonic() - begin}
            if fields:
                *_, results["fields"] = read_fields(folder, fields)
            return results


class Report:
    """Tables on the screen as they grow, and all of them in a file."""

    def __init__(self, file):
        self.file = pathlib.Path(file) if file else None
        if file:
            self.file.touch()
        self.tables = {}

    def begin(self, title, columns):
        """A table with a column of names and some of numbers."""
        self.title, self.columns = title, columns
        self.tables[title] = {}
        print(f"\n### {title}\n\n| | {' | '.join(columns)} |\n|{'---|' * (1 + len(columns))}", flush=True)

    def add(self, name, values):
        """A row; None is a number that there is not."""
        self.tables[self.title][name] = dict(zip(self.columns, values))
        print(f"| {name} | {' | '.join(as_cell(value) for value in values)} |", flush=True)
        if self.file:
            self.file.write_text(json.dumps(self.tables, indent=1), encoding="utf-8")


def as_cell(value):
    """Three digits of a number; words as they are."""
    if value is None:
        return ""
    return value if isinstance(value, str) else f"{value:.3g}"


def add_edges(parser):
    """The arguments of the commands that compare values of 'Contact/Edge'."""
    add_program(parser)
    parser.add_argument("--edge", action="append", metavar="VALUE", dest="edges",
                        help=f"of 'Contact/Edge', may be repeated; '{DEFAULT}' for what the program does without the "
                        f"entry (default: '{DEFAULT}' and 'at nodes')")
    parser.add_argument("--json", metavar="FILE", help="write all numbers there, too")


def chosen_edges(chosen):
    """What --edge says."""
    return chosen.edges or [DEFAULT, "at nodes"]


def last_message(error):
    """The last line that a program has left that has failed."""
    return f"exit status {error.returncode}: {' '.join(error.stderr.split())[-200:]}"
