# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads the tables (CSV) that the program writes."""

import csv
import pathlib

from .errors import UserError


def read_table(path):
    """The rows of a table, dictionaries of numbers by column; none if only its header is there."""
    try:
        with open(path, newline="", encoding="utf-8-sig") as file:
            return [{column.strip(): float(value) for column, value in row.items()}
                    for row in csv.DictReader(file, restkey="")]
    except OSError as error:
        raise UserError(f"'{path}' cannot be read: {error.strerror}") from None
    except (AttributeError, TypeError, ValueError):
        raise UserError(f"'{path}' is damaged: a value is missing, is not a number, or has no column") from None


def read_tables(folder):
    """The rows of all tables of a run, by their names without '.csv'."""
    return {file.stem: read_table(file) for file in pathlib.Path(folder).glob("*.csv")}
