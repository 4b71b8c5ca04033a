# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Blocks of numbers in a text or on a sheet, with the headings and units above them."""

import bisect
import re
from dataclasses import dataclass, field
from itertools import zip_longest

from ..errors import UserError
from .formats import Reading, find_format
from .headings import rank
from .units import KINDS, is_unit, split_value

# The fewest rows of a curve.
FEWEST_ROWS = 5

# What begins as a number and goes on with nothing but digits and signs.
LIKE_A_NUMBER = re.compile(r"[-+]?[\d.,][\d.,'’ eE+-]*")

# Letters that stand in no number.
WORD = re.compile(r"[^\W\d_eEdD]")

# Dates and times of the day.
WHEN = re.compile(r"\b\d{1,4}([./-])\d{1,2}\1\d{1,4}\b|\b\d{1,2}:\d\d(:\d\d([.,]\d+)?)?\b")


@dataclass
class Block:
    """Rows of numbers. lines: their numbers in the text. reading: how their numbers are written. title: the text above
    its headings. clocks: the numbers of the columns that hold times of the day. unread: lines of numbers around it that
    are in no block."""
    lines: list
    rows: list
    reading: Reading
    headings: list = None
    heading_line: int = None
    units: list = None
    title: str = ""
    clocks: tuple = ()
    after_blank: bool = False
    unread: list = field(default_factory=list)

    @property
    def first_line(self):
        return self.lines[0]

    @property
    def width(self):
        return len(self.rows[0])


def text_blocks(lines, path, first_line=1):
    """The Blocks of a text, or of a part of one that begins in this line. Raises UserError: a line within the numbers
    that is none."""
    form = find_format(lines)
    if form is None:
        return []
    if sum(not line.strip() for line in lines) > len(lines) / 3:  # (as after a wrong conversion of ends of lines)
        lines = [line if line.strip() else None for line in lines]
    rows = [(number, form.cells(line), form.headings(line)) for number, line in enumerate(lines, first_line)
            if line is not None]
    return blocks(rows, form.reading, path)


def blocks(rows, reading, path):
    """rows: the number, the cells, and the cells as headings, of each line; reading: how numbers are written. Raises
    UserError."""
    found, current, above = [], None, []
    for number, cells, headings in rows:
        values = reading.row(cells)
        if values is None:
            above.append((number, cells, headings))
            continue
        if current is None or above or len(values) != current.width:
            check_numbers(above, len(values), reading, path)
            if current is not None:
                check_gap(above, current, (number, values), reading, path)
            current = Block([number], [values], reading, clocks=reading.clocks(cells))
            set_headings(current, above, found[-1] if found else None)
            units = reading.units(cells) or []
            if any(units):
                current.units = [unit or heading for unit, heading in
                                 zip_longest(units, current.units or [], fillvalue="")]
            found.append(current)
            above = []
        else:
            check_units(current, reading.units(cells), number, path)
            current.lines.append(number)
            current.rows.append(values)
    if current is not None:
        check_numbers(above, current.width, reading, path)
    found = [block for block in found if len(block.rows) >= FEWEST_ROWS]
    note_unread(found, rows)
    return found


def note_unread(found, rows):
    """Gives each block the lines of numbers that follow it and are in none, the first one also those above it."""
    taken = {number for block in found for number in block.lines}
    starts = [block.first_line for block in found]
    for number, cells, _ in rows if found else []:
        if number not in taken and is_line_of_numbers(cells):
            found[max(bisect.bisect(starts, number) - 1, 0)].unread.append(number)


def is_line_of_numbers(cells):
    """Whether it holds several numbers besides dates and times, whatever the signs between them, and no words."""
    text = WHEN.sub("", " ".join(split_value(cell)[0] for cell in cells))
    return len(re.findall(r"\d+(?:[.,]\d+)?", text)) > 1 and not WORD.search(text)


def check_numbers(above, width, reading, path):
    """Refuses lines of numbers that are written in another way than the rows beside them."""
    for number, cells, _ in above:
        texts = [split_value(cell)[0].strip() for cell in cells if cell.strip()]
        if len(cells) == width and len(texts) > 1 and all(LIKE_A_NUMBER.fullmatch(text) for text in texts):
            wrong = next((text for text in texts if not reading.is_number(text)), texts[0])
            raise UserError(f"'{path}' has a text in place of a number in line {number}: '{wrong}', where other lines "
                            f"have decimal {'commas' if reading.decimal_comma else 'points'}. Write all numbers alike "
                            "and without thousands separators, or remove that line")


def check_gap(above, current, following, reading, path):
    """Refuses a single line with a text between rows of as many numbers, and rows of more or fewer without a heading."""
    if len(current.rows) < FEWEST_ROWS:
        return
    next_line, width = following[0], len(following[1])
    if len(above) == 1 and width == current.width:
        number, cells, _ = above[0]
        wrong = [cell for cell in cells if not reading.is_number(cell)]
        if any(reading.is_number(cell) for cell in cells) and wrong and wrong[0].strip():
            raise UserError(f"'{path}' has a text in place of a number in line {number}: '{wrong[0].strip()}'. Mend or "
                            "remove that line")
    if not above and width != current.width:
        raise UserError(f"'{path}' has {width} values in line {next_line}, and {current.width} in the lines before. "
                        "Mend or remove that line")


def check_units(block, units, line, path):
    """Refuses units behind numbers that are not those of the first row."""
    for first, unit in zip(block.units or [], units or []):
        if unit != first:
            raise UserError(f"'{path}' has numbers in '{unit}' in line {line}, and in '{first}' in line "
                            f"{block.first_line}: write each column in one unit, behind all its numbers or in its heading")


def set_headings(block, above, previous):
    """From the lines above it; without any that names something, those of the block before."""
    lines = [line for line in above if any(cell.strip() for cell in line[1])]
    block.after_blank = bool(above) and not lines
    if lines:
        set_own_headings(block, lines)
    if block.headings is None and previous is not None and (not lines or block.width == previous.width):
        block.headings, block.heading_line, block.units = previous.headings, previous.heading_line, previous.units


def set_own_headings(block, lines):
    """From lines that are not empty."""
    rest = lines
    for i in range(len(lines) - 1, max(len(lines) - 5, -1), -1):
        number, cells, headings = lines[i]
        headings = between_commas(headings, block.width)
        if names_something(headings):
            block.headings, block.heading_line, rest = strip_tail(headings), number, lines[:i]
            if block.units is None and rest and is_unit_row(rest[-1][1]):
                block.units = rest[-1][1]
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


def between_commas(headings, width):
    """The names of so many columns, where commas are between them but not between the numbers, as in '# time (s), depth
    (nm)'."""
    parts = " ".join(headings).split(",")
    return parts if len(parts) == width != len(strip_tail(headings)) else headings


def is_unit_row(cells):
    texts = [cell for cell in cells if cell.strip()]
    return len(texts) > 1 and sum(is_unit(text) for text in texts) > len(texts) / 2


def strip_tail(cells):
    """Without the empty cells at the end."""
    cells = list(cells)
    while cells and not cells[-1].strip():
        cells.pop()
    return [cell.strip() for cell in cells]
