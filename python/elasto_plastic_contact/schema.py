# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The JSON schema of all entries of a parameter file, made from the program's own reference
(--print-parameters, which is doc/parameters.md). It describes an object such as
{"Dimension": 2, "Material/Yield stress": 400}, whose keys are 'Section/Entry'.

    scripts/command.py schema     brings it, and the columns of the tables, up to date with the program
"""

import argparse
import difflib
import functools
import json
import os
import pathlib
import re
import subprocess

from . import columns
from .errors import UserError
from .program import MPI_ENVIRONMENT, find_program
from .verification.runner import add_program

FILE = pathlib.Path(__file__).with_name("parameters.schema.json")

LIST = re.compile(r"list, separated by commas \((?:at least (\d+), )?(?:at most (\d+), )?each: (.*)\)")

# "### Path", a paragraph, "- Default: ", "- Values: "
ENTRY = re.compile(r"^### (.+)\n\n((?:.+\n)+)\n- Default: (.*)\n- Values: (.*)$", re.MULTILINE)


def value_schema(values):
    """Of what the reference says in words, such as 'integer >= 1'."""
    if values == "text":
        return {"type": "string"}
    if values == "[Bool]":
        return {"type": "boolean"}
    if values.startswith("`"):
        return {"enum": re.findall("`([^`]*)`", values)}
    if found := LIST.fullmatch(values):
        element = value_schema(found[3])
        length = {key: int(number) for key, number in zip(("minItems", "maxItems"), found.groups()) if number}
        # as a list, as its only element, or as it stands in a file
        return {"anyOf": [{"type": "array", "items": element, **length}, element, {"type": "string"}]}
    if found := re.fullmatch(r"(integer|number)(?: >= (\S+)| <= (\S+)| from (\S+) to (\S+))?", values):
        kind, lowest, highest, lower, upper = found.groups()
        limits = {"minimum": lowest or lower, "maximum": highest or upper}
        return {"type": kind, **{key: json.loads(limit) for key, limit in limits.items() if limit}}
    raise UserError(f"the reference allows '{values}', which has no schema yet")


def make_schema(reference):
    """The schema of a reference, a page in Markdown."""
    properties = {}
    for path, text, default, values in ENTRY.findall(reference):
        entry = value_schema(values)
        default = "" if default == "empty" else default.strip("`")
        if entry.get("type") in ("integer", "number", "boolean"):
            default = json.loads(default)
        text = re.sub(r"\\(.)", r"\1", text.strip()).replace("\n", " ")
        properties[path] = {"description": text, "default": default, **entry}
    if len(properties) != len(re.findall("^### ", reference, re.MULTILINE)):
        raise UserError("the reference has entries that do not look like the others")
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", "title": "Entries of a parameter file",
            "type": "object", "additionalProperties": False, "properties": properties}


@functools.lru_cache
def entries():
    """What the schema says of each entry, by 'Section/Entry'."""
    return json.loads(FILE.read_text(encoding="utf-8"))["properties"]


def check_path(path, place):
    """Refuses what is no entry; place: where it stands, for the message."""
    if path not in entries():
        close = difflib.get_close_matches(path, entries(), n=3, cutoff=0.4)
        hint = (f"Did you mean {' or '.join(map(repr, close))}?" if close else
                "doc/parameters.md lists them as 'Section/Entry'")
        raise UserError(f"{place}: there is no entry '{path}'. {hint}")


def main(arguments):
    parser = argparse.ArgumentParser(prog="schema", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    add_program(parser)
    parser.add_argument("--check", action="store_true", help="change nothing, fail if it is not up to date")
    chosen = parser.parse_args(arguments)
    reference = subprocess.run([find_program(chosen.program), "--print-parameters"], env=os.environ | MPI_ENVIRONMENT,
                               stdout=subprocess.PIPE, text=True, check=True).stdout
    bring_up_to_date(FILE, make_schema(reference), chosen.check)
    bring_up_to_date(columns.FILE, columns.make_columns(columns.REFERENCE.read_text(encoding="utf-8")), chosen.check)
    return 0


def bring_up_to_date(file, content, only_check):
    text = json.dumps(content, indent=1, ensure_ascii=False) + "\n"
    if not only_check:
        file.write_text(text, encoding="utf-8")
    elif file.read_text(encoding="utf-8") != text:
        raise UserError(f"{file} is not that of the program. Bring it up to date with the target 'parameters'.")
