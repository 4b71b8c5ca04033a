# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finds the reader of a file by what stands in it."""

import io
import os
import pathlib
import zipfile
from collections import Counter
from dataclasses import replace

from ..errors import UserError
from . import delimited, fischerscope, hdf5, hysitron, nanosuite, results, spreadsheet
from .columns import checked_columns
from .curve import in_own_units
from .east_asian import with_usual_signs
from .texts import decode, lines_of, read_bytes
from .units import given_units

# Of files that are no texts, and of texts, the first that knows it reads it: knows(data) or knows(lines), and
# read(path, data or lines, chosen columns), which gives MeasuredCurves or a ResultsTable.
BINARY_READERS = (spreadsheet, hdf5)
TEXT_READERS = (hysitron, fischerscope, nanosuite, results, delimited)

ARCHIVE = b"PK\x03\x04"


def read_raw(path, columns=None):
    """The name of the format, and the curves in the units of the file, or a ResultsTable."""
    return read_data(path, read_bytes(path), columns or {})


def read_data(path, data, chosen):
    """What read_raw() returns, of the bytes of a file. Raises UserError."""
    if not data.strip():
        raise UserError(f"'{path}' is empty")
    for reader in BINARY_READERS:
        if reader.knows(data):
            return reader.FORMAT, reader.read(path, data, chosen)
    if data.startswith(ARCHIVE):
        return "a zip archive", read_archive(path, data, chosen)
    text = decode(data)
    if text is None:
        raise UserError(f"'{path}' is in no format that is known: "
                        f"{', '.join(reader.FORMAT for reader in BINARY_READERS)}, or texts "
                        f"({', '.join(reader.FORMAT for reader in TEXT_READERS)}). Export it as a text")
    if not text.strip():
        raise UserError(f"'{path}' is empty")
    lines = lines_of(with_usual_signs(text))
    reader = next(reader for reader in TEXT_READERS if reader.knows(lines))
    return reader.FORMAT, reader.read(path, lines, chosen)


def read_archive(path, data, chosen):
    """The curves of all files of an archive, such as those of Micro Materials. Raises UserError."""
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            members = {name: archive.read(name) for name in archive.namelist() if not name.endswith("/")}
    except Exception as error:  # pylint: disable=broad-except (of damaged files, the library raises anything)
        raise UserError(f"'{path}' is damaged, or no .zip: {error}") from None
    stems = Counter(pathlib.PurePath(name).stem for name in members)
    curves = []
    for name, member in members.items():
        found = read_data(f"{path}/{name}", member, chosen)[1]
        if isinstance(found, results.ResultsTable):
            raise UserError(f"'{path}/{name}' holds results, one row an indent: take it out of the archive")
        stem = pathlib.PurePath(name).stem
        own = stem if stems[stem] == 1 else name  # (with its folder where others have the same)
        curves += [replace(curve, name=own if len(found) == 1 else f"{own} {curve.name}") for curve in found]
    if not curves:
        raise UserError(f"'{path}' is an archive without files")
    return curves


def read_curve(path, columns=None, units=None):
    """The MeasuredCurves of a file of an instrument, one for each indent, in µm, mN, s and mN/µm.

    columns: which columns to take, such as {"depth": 2, "force": "Load"}, by number from 1 or name; None: known names.
    units: those that the file does not say, such as {"depth": "nm", "force": "mN"}.

    Raises UserError if the file is not understood, with what stands there and how to say it.
    """
    path = os.fspath(path)
    chosen = checked_columns((columns or {}).items())
    given = given_units(f"{quantity}={unit}" for quantity, unit in (units or {}).items())
    found = read_raw(path, chosen)[1]
    if isinstance(found, results.ResultsTable):
        raise UserError(f"'{path}' holds results, one row an indent, and no curve")
    return [in_own_units(curve, path, given) for curve in found]
