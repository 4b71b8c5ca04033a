# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Places for computed numbers in Markdown pages.

A table stands between two comments; its cells are computed, but for those of words and published values:

    <!-- table: NAME -->
    | unknowns | force |
    |---|---|
    | 2187 | 37.3058 |
    <!-- end of table -->

A number in the text has a comment behind it: 12.006<!-- NAME.KEY -->.
"""

import re

from elasto_plastic_contact.errors import UserError

TABLE = re.compile(r"<!-- table: (?P<name>\w+) -->\n(?P<text>.*?)(?=^[ ]*<!-- end of table -->$)",
                   re.DOTALL | re.MULTILINE)
NUMBER = re.compile(r"(?P<text>[^\s|(]+)(?P<mark><!-- (?P<name>\w+)\.(?P<key>\w+) -->)")
DIGITS = re.compile(r"[-+]?\d[\d,]*(?:\.(?P<decimals>\d+))?(?:e(?P<exponent>[-+]?\d+)\b)?")


def names(text):
    """Of the recipes that a page needs."""
    return {match["name"] for pattern in (TABLE, NUMBER) for match in pattern.finditer(text)}


def fill(text, contents):
    """The page with what has been computed, by the names of recipes; places of other recipes stay as they are."""
    def table(match):
        if match["name"] not in contents:
            return match[0]
        return match[0].removesuffix(match["text"]) + fill_table(match, contents[match["name"]].rows)

    def number(match):
        if match["name"] not in contents:
            return match[0]
        numbers = contents[match["name"]].numbers
        if match["key"] not in numbers:
            raise UserError(f"'{match['name']}' computes no '{match['key']}'; it has {', '.join(numbers) or 'none'}")
        filled = numbers[match["key"]] + match["mark"]
        if not NUMBER.fullmatch(filled):
            raise UserError(f"'{filled}' does not fit into a text: it has a blank, a bracket or a bar")
        return filled

    return NUMBER.sub(number, TABLE.sub(table, text))


def fill_table(match, rows):
    """The lines of a table: its head, and the rows; cells that are None stay as they are."""
    lines = match["text"].splitlines()
    head, body = lines[:2], [split(line) for line in lines[2:]]
    indentation = head[0][:len(head[0]) - len(head[0].lstrip())]
    filled = []
    for i, row in enumerate(rows):
        standing = body[i] if i < len(body) else []
        if len(standing) != len(row) and (standing or None in row):
            raise UserError(f"table '{match['name']}', row {i + 1}: {len(standing)} cells instead of {len(row)}")
        cells = [standing[j] if cell is None else cell for j, cell in enumerate(row)]
        filled.append(indentation + "|" + "".join(f" {cell} |" if cell else " |" for cell in cells))
    return "\n".join([*head, *filled]) + "\n"


def split(line):
    """The cells of a row."""
    return [cell.strip() for cell in line.strip().removeprefix("|").removesuffix("|").split("|")]


def differences(old, new):
    """Lines of a page that differ in words, or in a number by more than one unit of its last digit."""
    for number, (before, after) in enumerate(zip(old.splitlines(), new.splitlines()), 1):
        if DIGITS.sub("0", before) != DIGITS.sub("0", after) or any(
                distance(a, b) for a, b in zip(DIGITS.finditer(before), DIGITS.finditer(after))):
            yield number, before, after
    if len(old.splitlines()) != len(new.splitlines()):
        yield 0, f"{len(old.splitlines())} lines", f"{len(new.splitlines())} lines"


def distance(one, other):
    """Whether two numbers differ by more than one unit of the last digit of the rougher one."""
    return abs(value(one) - value(other)) > 1.01 * max(unit(one), unit(other))


def value(match):
    """Of a number in a text."""
    return float(match[0].replace(",", ""))


def unit(match):
    """That of the last digit."""
    return 10.0 ** (int(match["exponent"] or 0) - len(match["decimals"] or ""))
