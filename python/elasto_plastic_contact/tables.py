# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads the tables (CSV) that the program writes, and those of spreadsheets."""

import csv
import itertools
import pathlib

from .errors import UserError

# Makes numbers with a decimal comma such with a point; those with a point become invalid.
DECIMAL_COMMA = str.maketrans(",.", ".,")


def read_table(path):
    """The rows of a table, dictionaries of numbers by column; none if only its header is there.
    If the header is separated by ';' only, so are the rows, and numbers have a decimal comma."""
    try:
        with open(path, newline="", encoding="utf-8-sig", errors="replace") as file:
            header = file.readline()
            delimiter, decimals = (";", DECIMAL_COMMA) if ";" in header and "," not in header else (",", {})
            reader = csv.DictReader(itertools.chain([header], file), restkey="", delimiter=delimiter)
            return [{column.strip(): float(value.translate(decimals)) for column, value in row.items()}
                    for row in reader]
    except OSError as error:
        raise UserError(f"'{path}' cannot be read: {error.strerror}") from None
    except (AttributeError, TypeError, ValueError, csv.Error):
        raise UserError(f"'{path}' is damaged in line {reader.line_num}: a value is missing, is not a number, or has "
                        "no column. Either ',' separates columns and '.' is the decimal point, or ';' separates columns "
                        "and ',' is the decimal comma") from None


def read_tables(folder):
    """The rows of all tables of a run, by their names without '.csv'."""
    return {file.stem: read_table(file) for file in pathlib.Path(folder).glob("*.csv")}
