# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Spreadsheets: .xls and .xlsx, such as NanoSuite's exports, in which each test has a sheet."""

import io

from ..errors import UserError
from .blocks import blocks
from .columns import curves_of_blocks
from .east_asian import with_usual_signs
from .formats import find_reading
from .headings import best_rank

FORMAT = ".xls and .xlsx"

OLD, NEW = b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", b"PK\x03\x04"


def knows(data):
    return data.startswith(OLD) or (data.startswith(NEW) and b"xl/" in data)


def old_sheets(data):
    import xlrd  # (of these files only)

    book = xlrd.open_workbook(file_contents=data, on_demand=True, logfile=io.StringIO())
    return [(sheet.name, [sheet.row_values(i) for i in range(sheet.nrows)]) for sheet in book.sheets()]


def new_sheets(data):
    import openpyxl  # (of these files only)

    book = openpyxl.load_workbook(io.BytesIO(data), read_only=True, data_only=True)
    return [(sheet.title, [list(row) for row in sheet.iter_rows(values_only=True)]) for sheet in book.worksheets]


def sheets(path, data):
    """Names of sheets, and their rows of cells."""
    is_old = data.startswith(OLD)
    try:
        return old_sheets(data) if is_old else new_sheets(data)
    except ImportError:
        raise
    except Exception as error:  # pylint: disable=broad-except (of damaged files, the libraries raise anything)
        what = str(error) or type(error).__name__
        raise UserError(f"'{path}' is damaged, or no {'.xls' if is_old else '.xlsx'}: {what}") from None


def text_of(cell):
    """A cell as it would stand in a table with decimal points."""
    if isinstance(cell, float):
        return repr(cell)
    return "" if cell is None else with_usual_signs(str(cell))


def naming(blocks):
    """How well the best headings on a sheet name depth and force, two ranks; None if none name both."""
    ranks = [[best_rank(block.headings or [], quantity) for quantity in ("depth", "force")] for block in blocks]
    return min((pair for pair in ranks if None not in pair), default=None)


def raw_channels(on_sheets):
    """The sheets that name both depth and force less well than another one: other channels of the same indents."""
    known = {name: ranks for name, found in on_sheets.items() if (ranks := naming(found))}
    return [name for name, ranks in known.items()
            if any(depth < ranks[0] and force < ranks[1] for depth, force in known.values())]


def read(path, data, chosen):
    """The curves of all sheets that have depth and force, without raw channels. Raises UserError."""
    on_sheets = {}
    for name, rows in sheets(path, data):
        if "Tagged" in name:  # (NanoSuite repeats some rows of a test there)
            continue
        texts = [[text_of(cell) for cell in row] for row in rows]
        on_sheets[name] = blocks([(number, cells, cells) for number, cells in enumerate(texts, 1)], find_reading(texts)[0],
                                 f"{path}, sheet {name}")
    tried = [block for found in on_sheets.values() for block in found]
    if not tried:
        raise UserError(f"'{path}' has no rows of numbers on any sheet")
    left_out = [] if chosen else raw_channels(on_sheets)
    read_ones = {name: found for name, found in on_sheets.items() if chosen or naming(found) and name not in left_out}
    for name, found in read_ones.items():
        for block in found:
            block.title = name
    curves = curves_of_blocks([block for found in read_ones.values() for block in found] or tried, path, chosen)
    for name in left_out:
        curves = [curve.with_remark(f"the sheet '{name}' is left out: others name depth and force better") for curve in curves]
    return curves
