# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a table or number of the pages is computed by."""

import copy
import functools
import os
from dataclasses import dataclass, field
from typing import Callable

from ..verification.runner import Runner


@dataclass(frozen=True)
class Content:
    """Rows of cells for a table, where None is a cell that stands in the page; numbers for the text, by their keys."""
    rows: list = field(default_factory=list)
    numbers: dict = field(default_factory=dict)


@dataclass(frozen=True)
class Recipe:
    """compute(runs) returns the Content. seconds: what its runs take, about, on one processor.
    measured: whether it holds times or memory, which are those of the machine."""
    compute: Callable
    seconds: int
    measured: bool

    @property
    def title(self):
        """The first line of the function's documentation."""
        return self.compute.__doc__.splitlines()[0]


RECIPES = {}


def table(seconds):
    """Makes a function the recipe of the table of its name."""
    return functools.partial(add, seconds, False)


def measured_table(seconds):
    """The same for times and memory, which are only computed when asked for by name."""
    return functools.partial(add, seconds, True)


def add(seconds, measured, compute):
    """Into the list of all recipes."""
    RECIPES[compute.__name__] = Recipe(compute, seconds, measured)
    return compute


class Runs(Runner):
    """Runs of the program, each only once."""

    def __init__(self, program, ranks):
        super().__init__(program, ranks)
        self.finished = {}

    def tables(self, case, *entries):
        return self.once(super().tables, case, *entries)

    def tables_with_fields(self, case, kind, *entries):
        return self.once(super().tables_with_fields, case, kind, *entries)

    def once(self, run, *arguments):
        """What a run returns, a copy that the caller may change."""
        key = (run.__name__, *arguments)
        if key not in self.finished:
            self.finished[key] = run(*arguments)
        return copy.deepcopy(self.finished[key])

    def timed(self, case, *entries):
        """The rows of all tables of a run, which is made anew, and its processor time in seconds, that of all ranks."""
        before = os.times()
        tables = super().tables(case, *entries)
        after = os.times()
        return tables, after.children_user - before.children_user + after.children_system - before.children_system

    def limit_load(self, case, *entries):
        """The rows of limit_load.csv."""
        return self.tables(f"limit_load/{case}.prm", *entries)["limit_load"]


def count(number):
    """How many: 9226, 10,752."""
    return f"{number:,.0f}" if number >= 10000 else f"{number:.0f}"


def decimals(row, **digits):
    """Columns of a row, with so many decimals."""
    return [f"{row[name]:.{n}f}" for name, n in digits.items()]


def hundredths(ratio, n_decimals=1):
    """A ratio in per cent, without the sign."""
    return f"{100 * ratio:.{n_decimals}f}"


def percent(ratio, digits=2):
    """A part of a whole: 0.48 %, 11 %."""
    return f"{100 * ratio:#.{digits}g}".rstrip(".") + " %"


def signed_percent(ratio, decimals=1):
    """A deviation: +0.7 %."""
    return f"{100 * ratio:+.{decimals}f} %"


def power(number, digits=4):
    """A small number: 6.860e-3."""
    mantissa, exponent = f"{number:.{digits - 1}e}".split("e")
    return f"{mantissa}e{int(exponent)}"
