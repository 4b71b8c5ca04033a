# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes files that are complete or not there."""

import contextlib
import os
import pathlib

from .errors import FileError


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
