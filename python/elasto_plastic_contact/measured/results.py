# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of results, one row an indent: loading curvature, unloading slope, share of plastic work and the like."""

from dataclasses import dataclass

import numpy

from ..errors import UserError
from .blocks import FEWEST_ROWS, blocks
from .formats import find_format
from .headings import columns_of, result_columns
from .units import factor, split_name

FORMAT = "results, one row an indent"

# What the known columns are measured in; None of numbers without a unit.
KINDS = {"loading_curvature": "stress", "stiffness": "stiffness", "plastic_share": None, "max_depth": "length",
         "max_force": "force", "hardness": "stress", "modulus": "stress"}


@dataclass(frozen=True)
class ResultsTable:
    """headings: of all columns; values: a row for each indent."""
    headings: tuple
    values: numpy.ndarray

    def known(self):
        """The columns that are known, by the names of evaluation.QUANTITIES, in the units of units.py; those without a
        unit of their kind are left out."""
        found = {}
        for name, column in result_columns(self.headings).items():
            scale = 1. if KINDS[name] is None else factor(KINDS[name], split_name(self.headings[column])[1])
            if scale is not None:
                found[name] = scale * self.values[:, column]
        return found

    def depth_unit(self):
        """That of the largest depth, µm if there is none."""
        column = result_columns(self.headings).get("max_depth")
        return "µm" if column is None else split_name(self.headings[column])[1] or "µm"


def knows(lines):
    """A heading that names three results or more, and no time and force of a curve."""
    lines = [line for line in lines if line.strip()]
    form = find_format(lines)
    headings = [form.headings(line) for line in lines[:5]] if form else []
    return any(len(result_columns(names)) >= 3 and not (columns_of(names, "time") and columns_of(names, "force"))
               for names in headings)


def read(path, lines, _):
    form = find_format([line for line in lines if line.strip()])
    rows = [(number, form.cells(line), form.headings(line)) for number, line in enumerate(lines, 1) if line.strip()]
    found = blocks(rows, form.reading, path)
    if not found:
        raise UserError(f"'{path}' names results of indents, and has less than {FEWEST_ROWS} rows of numbers below")
    block = max(found, key=lambda block: len(block.rows))
    if block.headings is None or len(block.headings) != block.width:
        raise UserError(f"'{path}' has {block.width} values in line {block.first_line}, and "
                        f"{len(block.headings or [])} names of columns above them")
    return ResultsTable(tuple(block.headings), numpy.array(block.rows))
