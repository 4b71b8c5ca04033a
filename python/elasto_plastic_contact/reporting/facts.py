# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a report asks a run for: its kind, its entries, its units, what has computed it."""

import functools
import math
import pathlib
import re

from ..errors import UserError
from ..files import read_text
from ..plots.figures import Units
from ..results import Results, last_of_largest
from ..schema import entries

# The lines with which parameters.prm begins.
PROGRAM = re.compile(r"^# ElastoPlasticContact (?P<version>\S+) \((?P<revision>.*?)\), (?P<build>\S+) build\n"
                     r"# deal\.II (?P<deal_ii>\S+), (?P<lanes>\d+) number\(s\) per SIMD batch, (?P<ranks>\d+) MPI rank")

# Kinds of runs, and what they are called.
CONTACT, BOUNDED, TEST, LIMIT = "contact", "contact with error bound", "body without indenter", "limit load"


def is_same(value, default):
    """Whether a text of a parameter file is a value of the schema."""
    if isinstance(default, bool):
        return value == ("true" if default else "false")
    if isinstance(default, (int, float)):
        try:
            return float(value) == default
        except ValueError:
            return False
    return value == default


class Facts:
    """Of the run in a folder. Raises UserError if there is none, or if it has not come to its end."""

    def __init__(self, directory):
        directory = pathlib.Path(directory)
        if not directory.is_dir():
            raise UserError(f"there is no folder '{directory}': give the output directory of a run")
        if not (directory / "parameters.prm").is_file():
            others = [name for name in ("fit.json", "study.csv") if (directory / name).is_file()]
            what = f" ('{others[0]}' is of another command; each of its runs has a folder of its own)" if others else ""
            raise UserError(f"'{directory}' is no output directory of a run: it has no parameters.prm{what}")
        self.run = Results(directory)
        self.check_end()

    @functools.cached_property
    def kind(self):
        if self.text("Analysis") == "limit load":
            return LIMIT
        if self.text("Analysis") == "contact with error bound":
            return BOUNDED
        return TEST if self.text("Indenter/Type") == "none" else CONTACT

    def check_end(self):
        table = "limit_load" if self.kind == LIMIT else "history"
        if not self.run.has(f"{table}.csv"):
            raise UserError(f"the run in '{self.run.directory}' has not finished: it has no {table}.csv yet. Let it "
                            "end, or start it again")
        rows = self.run.table(table)
        if self.kind != LIMIT and rows["time"][-1] < (1. - 1e-9) * self.final_time:
            raise UserError(f"the run in '{self.run.directory}' has not finished: it has come to the time "
                            f"{rows['time'][-1]:g} of {self.final_time:g}. Let it end, or let it go on with --resume")

    @property
    def name(self):
        return pathlib.Path(self.run.directory).resolve().name

    @property
    def dimension(self):
        return int(self.run.number("Dimension"))

    @property
    def has_contact(self):
        return self.kind in (CONTACT, BOUNDED)

    def text(self, path):
        """The value of an entry; empty for those that this run's version does not have."""
        return self.run.parameters.get(path, "")

    def number(self, path):
        return self.run.number(path)

    @functools.cached_property
    def changed(self):
        """Entries that are not at their defaults: path to value. (Folder and screen are none of the problem.)"""
        known, ignored = entries(), ("Output/Directory", "Output/Screen")
        return {path: value for path, value in self.run.parameters.items()
                if path in known and path not in ignored and not is_same(value, known[path]["default"])}

    @functools.cached_property
    def history_rows(self):
        """Of 'Loading/History': pairs of a time and what is reached then, or happens until then; empty without it."""
        rows = [row.partition(":") for row in self.text("Loading/History").split("|") if row.strip()]
        return [(float(time), " ".join(target.split())) for time, _, target in rows]

    @property
    def final_time(self):
        return self.history_rows[-1][0] if self.history_rows else self.number("Loading/Final time")

    @functools.cached_property
    def units(self):
        return Units(self.text("Output/Length unit"), self.text("Output/Force unit"), self.run.is_plane)

    def quantity(self, value, kind, digits=5):
        """A number with its unit. kind: length, force, stress, energy, area, number, share."""
        if not math.isfinite(value):
            return "-"
        if kind == "share":
            return f"{100. * value:.{digits}g} %"
        units = {"length": self.units.length, "force": self.units.force, "stress": self.units.stress,
                 "energy": self.units.energy, "area": self.area_unit, "number": ""}
        return f"{value:.{digits}g} {units[kind].replace('$^2$', '²')}".strip()

    @property
    def area_unit(self):
        """Of the contact; in the plane it is a length."""
        if not self.units.length:
            return ""
        return self.units.length if self.run.is_plane else f"{self.units.length}²"

    @functools.cached_property
    def program(self):
        """Version, revision, build, deal.II's version, lanes and ranks, as the run has recorded them; None if not."""
        found = PROGRAM.match(read_text(self.run.path("parameters.prm")))
        return found.groupdict() if found else None

    @property
    def step_of_largest_force(self):
        """The row of history.csv; of several equal forces, as of a hold, the last one."""
        return last_of_largest(self.run.history["force"])

    @property
    def is_single_step(self):
        """Johnson's stationary problem."""
        return not self.history_rows and not self.text("Loading/Path") and self.number("Loading/Number of steps") == 1.
