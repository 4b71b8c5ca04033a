# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The JSON schema of all entries of a parameter file, made from the program's own reference
(--print-parameters, which is doc/lookup/parameters.md). It describes an object such as
{"Dimension": 2, "Material/Yield stress": 400}, whose keys are 'Section/Entry'.

    epc schema > entries.json
"""

import argparse
import difflib
import functools
import json
import pathlib
import re
import sys

from .errors import UserError

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
                "doc/lookup/parameters.md lists them as 'Section/Entry'")
        raise UserError(f"{place}: there is no entry '{path}'. {hint}")


def main(arguments):
    argparse.ArgumentParser(prog="schema", description=__doc__,
                            formatter_class=argparse.RawDescriptionHelpFormatter).parse_args(arguments)
    sys.stdout.write(FILE.read_text(encoding="utf-8"))
    return 0
