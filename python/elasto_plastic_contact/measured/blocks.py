# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Blocks of numbers in a text or on a sheet, with the headings and units above them."""

import csv
import math
import re
from dataclasses import dataclass, field

from ..errors import UserError
from .headings import rank
from .texts import is_number, to_number
from .units import KINDS, is_unit

# What may separate columns, what is preferred first; the fewest rows of a curve; about how many lines are looked at to find
# the separator.
SEPARATORS = ("\t", ";", ",", " ")
FEWEST_ROWS = 5
SAMPLE = 2000


@dataclass
class Block:
    """Rows of numbers. first_line: the line of the first of them. title: the text above its headings."""
    first_line: int
    rows: list = field(default_factory=list)
    headings: list = None
    heading_line: int = None
    units: list = None
    title: str = ""
    after_blank: bool = False

    @property
    def width(self):
        return len(self.rows[0])


@dataclass(frozen=True)
class Format:
    separator: str
    decimal_comma: bool

    def cells(self, line):
        if self.separator == " ":
            return line.split()
        if '"' in line:
            return next(csv.reader([line], delimiter=self.separator), [])
        return line.split(self.separator)

    def headings(self, line):
        """Headings may hold blanks between blanks, as in 'Depth (nm)  Load (mN)'."""
        if self.separator != " ":
            return self.cells(line)
        parts = re.split(r"\s{2,}|\t", line.strip())
        return parts if len(parts) > 1 else re.findall(r"[^\s(\[]+(?:\s*[(\[][^)\]]*[)\]])?", line)


def numbers(cells, decimal_comma):
    """The numbers of a row; None if it is none: two numbers at least, and no other text but in the first cell, where
    instruments mark their segments."""
    values, n_numbers = [], 0
    for column, cell in enumerate(cells):
        try:
            values.append(to_number(cell, decimal_comma))
            n_numbers += not math.isnan(values[-1])
        except ValueError:
            if column > 0:
                return None
            values.append(math.nan)
    return values if n_numbers >= 2 else None


def find_format(lines):
    """That by which most lines are rows of numbers; None if there are too few."""
    lines = lines[::max(len(lines) // SAMPLE, 1)]
    best, most = None, FEWEST_ROWS - 1
    for separator in SEPARATORS:
        for decimal_comma in (False, True):
            if separator == "," and decimal_comma:
                continue
            form = Format(separator, decimal_comma)
            n_rows = sum(numbers(form.cells(line), decimal_comma) is not None for line in lines)
            if n_rows > most:
                best, most = form, n_rows
    return best


def text_blocks(lines, path):
    """The Blocks of a text. Raises UserError: a line within the numbers that is none."""
    form = find_format(lines)
    if form is None:
        return []
    if sum(not line.strip() for line in lines) > len(lines) / 3:  # (as after a wrong conversion of ends of lines)
        lines = [line if line.strip() else None for line in lines]
    rows = ((number, form.cells(line), form.headings(line)) for number, line in enumerate(lines, 1) if line is not None)
    return blocks(rows, form.decimal_comma, path)


def blocks(rows, decimal_comma, path):
    """rows: the number, the cells, and the cells as headings, of each line."""
    found, current, above = [], None, []
    for number, cells, headings in rows:
        values = numbers(cells, decimal_comma)
        if values is None:
            above.append((number, cells, headings))
            continue
        if current is None or above or len(values) != current.width:
            if current is not None:
                check_gap(above, current, (number, values), decimal_comma, path)
            current = Block(number)
            set_headings(current, above, found[-1] if found else None)
            found.append(current)
            above = []
        current.rows.append(values)
    return [block for block in found if len(block.rows) >= FEWEST_ROWS]


def check_gap(above, current, following, decimal_comma, path):
    """Refuses a single line with a text between rows of as many numbers, and rows of more or fewer without a heading."""
    if len(current.rows) < FEWEST_ROWS:
        return
    next_line, width = following[0], len(following[1])
    if len(above) == 1 and width == current.width:
        number, cells, _ = above[0]
        wrong = [cell for cell in cells if not is_number(cell, decimal_comma)]
        if any(is_number(cell, decimal_comma) for cell in cells) and wrong and wrong[0].strip():
            raise UserError(f"'{path}' has a text in place of a number in line {number}: '{wrong[0].strip()}'. Mend or "
                            "remove that line")
    if not above and width != current.width:
        raise UserError(f"'{path}' has {width} values in line {next_line}, and {current.width} in the lines before. "
                        "Mend or remove that line")


def set_headings(block, above, previous):
    """From the lines above it; without any, those of the block before."""
    lines = [line for line in above if any(cell.strip() for cell in line[1])]
    block.after_blank = bool(above) and not lines
    if not lines:
        if previous is not None:
            block.headings, block.heading_line, block.units = previous.headings, previous.heading_line, previous.units
        return
    rest = lines
    for i in range(len(lines) - 1, max(len(lines) - 5, -1), -1):
        number, cells, headings = lines[i]
        if names_something(headings):
            block.headings, block.heading_line, rest = strip_tail(headings), number, lines[:i]
            break
        if block.units is None and is_unit_row(cells):
            block.units, rest = cells, lines[:i]
    else:
        number, cells, headings = lines[-1] if block.units is None or len(lines) == 1 else lines[-2]
        if len(strip_tail(headings)) > 1 and block.units is not headings and not is_unit_row(cells):
            block.headings, block.heading_line, rest = strip_tail(headings), number, []
    texts = [" ".join(cell.strip() for cell in cells if cell.strip()) for _, cells, _ in rest]
    block.title = texts[-1] if texts else ""


def names_something(headings):
    return sum(any(rank(heading, quantity) is not None for quantity in KINDS) for heading in headings) >= 2


def is_unit_row(cells):
    texts = [cell for cell in cells if cell.strip()]
    return len(texts) > 1 and sum(is_unit(text) for text in texts) > len(texts) / 2


def strip_tail(cells):
    """Without the empty cells at the end."""
    cells = list(cells)
    while cells and not cells[-1].strip():
        cells.pop()
    return [cell.strip() for cell in cells]
