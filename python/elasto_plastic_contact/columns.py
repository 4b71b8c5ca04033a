# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The columns of the tables that a run can write, as far as they can be known before it: made from
the program's own reference, doc/lookup/tables.md."""

import functools
import json
import pathlib
import re

from .program import checkout

FILE = pathlib.Path(__file__).with_name("columns.json")

# Tables whose columns have the names of boundaries and of probe points.
TABLES_OF_NAMES = ("reactions", "probes")


def make_columns(reference):
    """The columns of each table of the reference, a page in Markdown."""
    _, *tables = re.split(r"^## (.+)\.csv$", reference, flags=re.MULTILINE)
    return {name: re.findall(r"^\| `(\w+)` \|", text, re.MULTILINE) for name, text in zip(tables[::2], tables[1::2])}


def columns_of_reference():
    """The columns of each table, as the page has them."""
    return make_columns((checkout() / "doc/lookup/tables.md").read_text(encoding="utf-8"))


@functools.lru_cache
def known_columns():
    """The columns of each table, by its name without '.csv'."""
    return json.loads(FILE.read_text(encoding="utf-8"))
