# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads the tables (CSV) that the program writes, and those of spreadsheets."""

import csv
import io
import pathlib

from .errors import UserError
from .files import read_text

# What separates columns, and what makes the numbers between them Python's: with ';', they have a decimal comma.
TRANSLATIONS = {",": {}, ";": str.maketrans(",.", ".,")}
FORMATS = ("The first line names the columns, the others hold numbers: remove what stands above or between. Either ',' "
           "separates columns and '.' is the decimal point, or ';' separates columns and ',' is the decimal comma")


def read_table(path):
    """The rows of a table, dictionaries of numbers by column; none if only its header is there.
    If the header is separated by ';', so are the rows, and numbers have a decimal comma."""
    text = read_text(path)
    separator = max(*TRANSLATIONS, "\t", key=text.partition("\n")[0].count)
    if separator not in TRANSLATIONS:
        raise UserError(f"'{path}' separates columns by tabs. {FORMATS}")
    reader = csv.reader(io.StringIO(text, newline=""), delimiter=separator)
    try:
        columns = [column.strip() for column in next(reader, [])]
        return [read_row(row, columns, TRANSLATIONS[separator]) for row in reader if row]
    except (ValueError, csv.Error) as error:
        raise UserError(f"'{path}' is damaged in line {reader.line_num}: {error}. {FORMATS}") from None


def read_row(row, columns, translation):
    """Raises ValueError: what is wrong with it."""
    if len(row) != len(columns):
        raise ValueError(f"columns: {len(columns)}, values: {len(row)}")
    return {column: read_number(value, column, translation) for column, value in zip(columns, row)}


def read_number(text, column, translation):
    try:
        return float(text.translate(translation))
    except ValueError:
        raise ValueError(f"the value of '{column}' is '{text}'") from None


def read_tables(folder):
    """The rows of all tables of a run, by their names without '.csv'."""
    return {file.stem: read_table(file) for file in pathlib.Path(folder).glob("*.csv")}
