# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads the tables (CSV) that the program writes, and those of spreadsheets."""

import csv
import io
import pathlib
import re

from .errors import UserError
from .files import read_text

# What separates columns, and what makes the numbers between them Python's: with ';', they have a decimal comma.
TRANSLATIONS = {",": {}, ";": str.maketrans(",.", ".,")}
FORMATS = ("The first line names the columns, the others hold numbers: remove what stands above or between. Either ',' "
           "separates columns and '.' is the decimal point, or ';' separates columns and ',' is the decimal comma")


def read_table(path):
    """The rows of a table, dictionaries of numbers by column; none if only its header is there.
    If there is a ';' in the header, it separates the rows, too, and numbers have a decimal comma."""
    text = read_text(path)
    header, _, body = text.partition("\n")
    separator = ";" if ";" in header else max(",", "\t", key=header.count)
    if separator not in TRANSLATIONS:
        raise UserError(f"'{path}' separates columns by tabs. {FORMATS}")
    if separator == "," and has_decimal_commas(header, body):
        raise UserError(f"'{path}' seems to have decimal commas, and they would separate columns. {FORMATS}. (Of integers, "
                        "leave out zeros before them, and blanks after the commas of the first line)")
    reader = csv.reader(io.StringIO(text, newline=""), delimiter=separator)
    try:
        columns = [column.strip() for column in next(reader, [])]
        check_columns(columns, TRANSLATIONS[separator])
        return [read_row(row, columns, TRANSLATIONS[separator]) for row in reader if row]
    except (ValueError, csv.Error) as error:
        raise UserError(f"'{path}' is damaged in line {reader.line_num}: {error}. {FORMATS}") from None


def has_decimal_commas(header, body):
    """Whether commas between integers look like those of numbers: there are zeros after them, as in 1,05, or
    the blank after each comma of the header, as in 'depth, mm', is missing here."""
    if "," not in body or re.search(r"[^-+\d\s,]", body):
        return False
    return re.search(r",0\d", body) is not None or (", " in header and ", " not in body)


def check_columns(columns, translation):
    """Raises ValueError if they are no names, or not different ones."""
    if columns and all(is_number(column, translation) for column in columns):
        raise ValueError("there are numbers in place of the names of the columns")
    for column in columns:
        if columns.count(column) > 1:
            raise ValueError(f"two columns are called '{column}'")


def is_number(text, translation):
    try:
        read_number(text, "", translation)
    except ValueError:
        return False
    return True


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
