# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the program and compares what it computes; see the command verify."""

import contextlib
import os
import subprocess
import tempfile

from elasto_plastic_contact.fields import read_fields
from elasto_plastic_contact.program import MPI_ENVIRONMENT, command_line, find_program, ready_case
from elasto_plastic_contact.tables import read_tables

# The steel of most cases (MPa) and its modulus under a rigid indenter.
E, NU = 200000.0, 0.3
E_STAR = E / (1 - NU**2)
# The ways to integrate a load step; with two steps, fewer of them leave the same error.
TWO_STEPS, EULER = "Loading/Integration=BDF2", "Loading/Integration=backward Euler"


class Runner:
    """Runs the program and collects what is compared."""

    def __init__(self, program, ranks):
        """program: see find_program()."""
        self.program = find_program(program)
        self.ranks = ranks
        self.failed = False

    def start(self, command, output=os.devnull):
        """Runs a command of one or more ranks. Raises subprocess.CalledProcessError unless its exit status is 0."""
        with open(output, "wb") as file:
            subprocess.run(command, check=True, env=os.environ | MPI_ENVIRONMENT, stdout=file)

    @contextlib.contextmanager
    def on_ranks(self, ranks):
        """The runs meanwhile, on another number of ranks."""
        before, self.ranks = self.ranks, ranks
        try:
            yield
        finally:
            self.ranks = before

    @contextlib.contextmanager
    def in_environment(self, **variables):
        """The runs meanwhile, with variables of the environment."""
        before = {name: os.environ.get(name) for name in variables}
        os.environ.update(variables)
        try:
            yield
        finally:
            for name, value in before.items():
                if value is None:
                    del os.environ[name]
                else:
                    os.environ[name] = value

    def case(self, name):
        """The path of a ready case, or of a file that has been made: an absolute one. (Where tests run, there are other
        files with names of ready cases.)"""
        return name if os.path.isabs(name) else ready_case(name, self.program)

    def run(self, case, *entries):
        """Rows of statistics.csv, the last one extended by that of history.csv."""
        tables = self.tables(case, *entries)
        tables["statistics"][-1].update(tables["history"][-1])
        return tables["statistics"]

    def history(self, case, *entries):
        """Rows of history.csv, extended by those of reactions.csv."""
        tables = self.tables(case, *entries)
        return [{**step, **forces} for step, forces in zip(tables["history"], tables["reactions"])]

    def tables(self, case, *entries):
        """The rows of all tables, by their names."""
        with self.results(case, entries) as folder:
            return read_tables(folder)

    def tables_with_fields(self, case, kind, *entries):
        """The rows of all tables, and the fields of the kind 'solution', 'surface' or 'equilibrium'."""
        with self.results(case, (*entries, "Output/Fields=every cycle")) as folder:
            return read_tables(folder), list(read_fields(folder, kind))

    @contextlib.contextmanager
    def results(self, case, entries):
        """The folder with the results of a run, for as long as they are needed."""
        with tempfile.TemporaryDirectory() as folder:
            changes = {"Output/Fields": "never"} | dict(entry.split("=", 1) for entry in entries)
            command = command_line(self.program, self.case(case), changes, folder, "--overwrite", ranks=self.ranks)
            self.start(command)
            self.check_balances(read_tables(folder))
            yield folder

    def preview(self, case, *entries, directory="nowhere"):
        """What --validate says: the texts of its lines by their titles."""
        command = [self.program, self.case(case), "--validate", "--output-directory", directory]
        for entry in entries:
            command += ["--set", entry]
        with tempfile.NamedTemporaryFile("r", encoding="utf-8") as report:
            self.start(command, report.name)
            return {line[:16].strip(): line[16:].rstrip("\n") for line in report}

    def check_balances(self, tables):
        """What must hold after every nonlinear solve, if there have been any."""
        if "statistics" not in tables:
            return
        rows = tables["statistics"]
        # complementarity is relative to the force, of which nothing is left after unloading
        rounding = 1e-12 * max(abs(row["force"]) for row in rows)
        pressed = [row for row in rows if abs(row["force"]) > rounding]
        # forces that rounding leaves on free unknowns, where it is worth a warning
        unbalanced = max(row["residual"] for row in rows)
        # nodes that do not touch may be many, and ten thousand depths away
        for name, checked, factor in (("force_balance_error", rows, 10), ("complementarity_error", pressed, 3e4)):
            largest = max((row[name] for row in checked), default=0)
            self.compare(f"largest {name}", largest, 0, max(1e-8, factor * unbalanced), absolute=True)
        dissipation = [0] + [step["dissipation"] for step in tables["history"]]
        self.verify("dissipation never negative",
                    all(b >= a for a, b in zip(dissipation, dissipation[1:])))

    def compare(self, name, value, reference, allowed, absolute=False):
        """Reports a value whose relative (or absolute) deviation is limited."""
        deviation = value - reference if absolute else value / reference - 1
        self.verify(f"{name}: {value:.9g}, reference {reference:.9g}, "
                    f"deviation {deviation:.1e}, allowed {allowed:.1e}",
                    abs(deviation) <= allowed)

    def verify(self, text, holds):
        """Reports a property."""
        print(f"  {text}: {'ok' if holds else 'FAILED'}", flush=True)
        self.failed = self.failed or not holds
