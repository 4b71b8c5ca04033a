# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads texts, and writes files that are complete or not there."""

import contextlib
import os
import pathlib

from .errors import FileError, UserError


def read_text(path, errors="replace"):
    """The text of a file, with its ends of lines. errors: as in open(), of what is not UTF-8.
    Raises UserError."""
    try:
        data = pathlib.Path(path).read_bytes()
    except OSError as error:
        raise UserError(f"'{path}' cannot be read: {error.strerror}") from None
    remedy = "Save it as plain text, or as UTF-8"
    if b"\0" in data[:4] or data.startswith((b"\xff\xfe", b"\xfe\xff")):
        raise UserError(f"'{path}' is in UTF-16, which some editors call Unicode, or is no text. {remedy}")
    try:
        return data.decode("utf-8-sig", errors)
    except UnicodeDecodeError as error:
        raise UserError(f"'{path}' is not in UTF-8: {error.reason} at byte {error.start + 1}. {remedy}") from None


@contextlib.contextmanager
def new_file(path):
    """A text file to write into, which becomes 'path' at the end. Raises FileError."""
    path = pathlib.Path(path)
    unfinished = path.with_name(f"{path.name}.new")
    try:
        with unfinished.open("w", newline="", encoding="utf-8") as file:
            yield file
        os.replace(unfinished, path)
    except OSError as error:
        unfinished.unlink(missing_ok=True)
        raise FileError(path, error) from None
