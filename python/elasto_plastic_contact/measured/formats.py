# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a text separates its columns and writes its numbers, found from what makes most of its lines rows of numbers."""

import csv
import math
import re
from collections import Counter
from dataclasses import dataclass, replace

from .texts import seconds_of_clock, to_number
from .units import split_value

# What may separate columns, what is preferred first; about how many lines are looked at to find the separator.
SEPARATORS = ("\t", ";", ",", " ")
SAMPLE = 2000

# The fewest lines by which a format is known.
FEWEST_LINES = 5

# What a word in a column of words begins with.
WORD = re.compile(r"[^\W\d_]")

# A number whose thousands are separated, by each mark.
THOUSANDS = {",": re.compile(r"[-+]?[1-9]\d{0,2}(,\d{3})+(\.\d*)?"),
             ".": re.compile(r"[-+]?[1-9]\d{0,2}(\.\d{3})+(,\d*)?")}

# A reading is not looked for any further once it takes in that share of the lines.
MOST_LINES = 0.9


@dataclass(frozen=True)
class Reading:
    """How numbers are written. separates_thousands: with points if decimals have commas, and the other way round;
    words: the numbers of the columns that hold words, such as the names of segments; has_units: behind the numbers."""
    decimal_comma: bool = False
    separates_thousands: bool = False
    words: frozenset = frozenset()
    has_units: bool = False

    def number(self, cell):
        """NaN of what stands for no number. Raises ValueError."""
        if self.has_units:
            cell = split_value(cell)[0]
        if self.separates_thousands:
            mark = "." if self.decimal_comma else ","
            if THOUSANDS[mark].fullmatch(cell.strip().strip('"').strip()):
                cell = cell.replace(mark, "")
        return to_number(cell, self.decimal_comma)

    def is_number(self, cell):
        """Whether it is one, not what stands for none."""
        try:
            return not math.isnan(self.number(cell))
        except ValueError:
            return False

    def row(self, cells):
        """Its numbers, seconds of times of the day, and NaN of words; None if it is no row: two numbers at least, and
        no other text but in the first cell, where instruments mark their segments, and in columns of words."""
        values, n_numbers = [], 0
        for column, cell in enumerate(cells):
            try:
                values.append(self.number(cell))
                n_numbers += not math.isnan(values[-1])
            except ValueError:
                seconds = seconds_of_clock(cell)
                if seconds is None and column > 0 and column not in self.words:
                    return None
                values.append(math.nan if seconds is None else seconds)
        return values if n_numbers >= 2 else None

    def units(self, cells):
        """Those behind the numbers; None if numbers stand alone."""
        return [split_value(cell)[1] for cell in cells] if self.has_units else None

    def clocks(self, cells):
        """The numbers of the columns with times of the day."""
        return tuple(column for column, cell in enumerate(cells) if seconds_of_clock(cell) is not None)

    def with_words(self, rows):
        """Also reads rows with columns that hold words, and never a number."""
        rows = [cells for cells in rows if sum(map(self.is_number, cells)) >= 2]
        width, _ = Counter(map(len, rows)).most_common(1)[0] if rows else (0, 0)
        columns = zip(*(cells for cells in rows if len(cells) == width))
        return replace(self, words=frozenset(number for number, cells in enumerate(columns)
                                             if any(WORD.match(cell.strip(' "')) for cell in cells)
                                             and not any(map(self.is_number, cells))))


POINT, COMMA = Reading(), Reading(decimal_comma=True)
POINT_WITH_THOUSANDS, COMMA_WITH_THOUSANDS = (replace(reading, separates_thousands=True) for reading in (POINT, COMMA))


@dataclass(frozen=True)
class Format:
    separator: str
    reading: Reading = Reading()

    def cells(self, line):
        if self.separator == " ":
            return line.split()
        if '"' in line and len(line) < csv.field_size_limit():
            return next(csv.reader([line], delimiter=self.separator), [])
        return line.split(self.separator)

    def headings(self, line):
        """Headings may hold blanks between blanks, as in 'Depth (nm)  Load (mN)', and begin with the sign of a
        comment."""
        if self.separator != " ":
            return self.cells(line)
        line = line.strip().lstrip("#% ")
        parts = re.split(r"\s{2,}|\t", line)
        return parts if len(parts) > 1 else re.findall(r"[^\s(\[]+(?:\s*[(\[][^)\]]*[)\]])?", line)


def find_reading(rows):
    """The Reading by which most rows of cells are rows of numbers, and their number. Of some that are alike, the one that
    reads most numbers (in a first cell, '0,5' may be a word), and then the first one."""
    plain = POINT, COMMA, POINT_WITH_THOUSANDS, COMMA_WITH_THOUSANDS
    best, most = POINT, (0, 0)
    for candidates in (plain[:2], plain[2:], (reading.with_words(rows) for reading in plain),
                       (replace(reading, has_units=True) for reading in plain if may_have_units(rows))):
        for reading in candidates:
            found = [values for cells in rows if (values := reading.row(cells)) is not None]
            n_found = len(found), sum(not math.isnan(value) for values in found for value in values)
            if n_found > most:
                best, most = reading, n_found
        if most[0] >= MOST_LINES * len(rows):
            break
    numbers = [[split_value(cell)[0] for cell in cells] for cells in rows] if best.has_units else rows
    decimals, thousands = (COMMA, POINT_WITH_THOUSANDS) if best.decimal_comma else (POINT, COMMA_WITH_THOUSANDS)
    if not best.separates_thousands and without_decimals(numbers, decimals, thousands):
        best = replace(best, decimal_comma=thousands.decimal_comma, separates_thousands=True)
    return best, most[0]


def reading_of_marks(texts, decimal_comma):
    """The Reading of most of these numbers, which stand in no table. Where 1,234 may be two numbers, decimal_comma
    chooses; 1.234 alone has decimals."""
    chosen = decimal_comma and any("," in text for text in texts)
    readings = sorted((POINT_WITH_THOUSANDS, COMMA_WITH_THOUSANDS), key=lambda reading: reading.decimal_comma != chosen)
    return max(readings, key=lambda reading: sum(map(reading.is_number, texts)))


def may_have_units(rows):
    """Whether one stands behind the second number of some row."""
    return any(split_value(cells[1])[1] for cells in rows if len(cells) > 1)


def without_decimals(rows, decimals, thousands):
    """Whether numbers without decimals are meant, as in the column 998, 999, 1,000: all marks may separate thousands,
    numbers have none up to three digits, and columns of both vary less then (with decimals, this one falls from 999 to
    1). decimals, thousands: the Readings by which a mark is one or the other."""
    mark = "," if decimals.decimal_comma else "."
    numbers = [[cell.strip(' "') for cell in cells] for cells in rows if decimals.row(cells) is not None]
    columns = [[cell for cell in column if decimals.is_number(cell)] for column in zip(*numbers)]
    if not all(THOUSANDS[mark].fullmatch(cell) for column in columns for cell in column if mark in cell):
        return False
    mixed = [column for column in columns if len({mark in cell for cell in column}) > 1]
    largest = max((abs(decimals.number(cell)) for column in mixed for cell in column if mark not in cell), default=0)
    ways = [[variation([reading.number(cell) for cell in column]) for reading in (decimals, thousands)] for column in mixed]
    return (100 <= largest < 1000 and all(after <= 1.01 * before for before, after in ways)
            and any(after < 0.9 * before for before, after in ways))


def variation(values):
    """The length of the way from value to value over the distance between the smallest and the largest one, 1 if they
    only grow; 0 if they are all the same."""
    span = max(values, default=0) - min(values, default=0)
    return sum(abs(b - a) for a, b in zip(values, values[1:])) / span if span > 0 else 0


def find_format(lines):
    """That by which most lines are rows of numbers, without columns of words if two are alike; None if there are too
    few."""
    lines = [line for line in lines if line.strip()]
    step = max(len(lines) // SAMPLE, 1)
    return format_of_most(lines[::step]) or (format_of_most(lines) if step > 1 else None)


def format_of_most(lines):
    """What find_format() returns, of these lines."""
    best, best_rank = None, (FEWEST_LINES - 1, True)
    for separator in SEPARATORS:
        form = Format(separator)
        reading, n_rows = find_reading([form.cells(line) for line in lines])
        found = n_rows, not reading.words
        if found > best_rank:
            best, best_rank = Format(separator, reading), found
    return best
