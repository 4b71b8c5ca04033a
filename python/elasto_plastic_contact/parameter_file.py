# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads parameter files as the program does, with the files that they include."""

import pathlib

from .errors import UserError
from .files import read_text


def lines_of(path, errors="replace", including=()):
    """Triples of file, number of the line and its text without a comment, empty ones left out; a backslash joins lines,
    and 'include FILE' stands for the lines of another file, whose relative name begins in the folder of this one.
    errors: see read_text(); including: the files that include this one. Raises UserError."""
    path = pathlib.Path(path)
    if path.resolve() in including:
        raise UserError(f"'{path}' is included while it is being read: remove the 'include' that leads back to it")
    joined = ""
    lines = read_text(path, errors).splitlines()
    for number, line in enumerate(lines, 1):
        joined += line.strip()
        if joined.endswith("\\") and number < len(lines):
            joined = joined[:-1]
            continue
        text, joined = joined.split("#")[0].strip(), ""
        keyword, rest = keyword_of(text)
        if keyword == "include":
            yield from lines_of(path.parent / rest, errors, (*including, path.resolve()))
        elif text:
            yield path, number, text


def keyword_of(line):
    """The first word, in small letters, and what follows it."""
    keyword, *rest = line.split(maxsplit=1) or [""]
    return keyword.lower(), rest[0] if rest else ""


def read_entries(path):
    """The entries of a parameter file: 'Section/Entry' to text. Raises UserError."""
    values, sections = {}, []
    for file, number, line in lines_of(path):
        keyword, rest = keyword_of(line)
        if keyword == "subsection" and rest:
            sections.append(rest)
        elif line.lower() == "end" and sections:
            sections.pop()
        elif keyword == "set" and "=" in rest:
            entry, value = rest.split("=", 1)
            values["/".join(sections + [entry.strip()])] = value.strip()
        else:
            raise UserError(f"'{file}' is damaged in line {number}")
    return values
