# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A parameter file with its comments, before it is written."""

import pathlib
from dataclasses import dataclass, field

TOP = ""  # the section of the entries that are in none


@dataclass
class Case:
    """title: one sentence without its full stop; remarks: lines of the head of the file; chosen: what has been chosen
    and why, by
    its name, to print and for the head; files: texts by their names, that lie beside it; surface: None, or the path of
    the user's height map, which the file names '{surface}'; kind_of_time: see duration."""
    title: str
    units: object
    kind_of_time: str = ""
    remarks: list = field(default_factory=list)
    chosen: dict = field(default_factory=dict)
    sections: dict = field(default_factory=lambda: {TOP: []})
    files: dict = field(default_factory=dict)
    surface: pathlib.Path | None = None

    def set(self, section, entry, value, comment=""):
        """An entry, in the order of the calls."""
        self.sections.setdefault(section, []).append((entry, str(value), comment))

    def text(self):
        """Of the file."""
        head = [f"{self.title}.", "", *self.remarks, "", "Chosen ('epc new', rules in doc/lookup/new_cases.md):",
                *(f"  {name}: {what}" for name, what in self.chosen.items()), f"Units: {self.units}."]
        lines = [f"# {line}".rstrip() for line in head]
        for section, entries in self.sections.items():
            lines += block(section, entries)
        return "\n".join(lines) + "\n"


def block(section, entries):
    """The lines of a section, with the signs of equality in one column."""
    if not entries:
        return []
    indent = "  " if section else ""
    width = max(len(entry) for entry, _, _ in entries)
    lines = [f"{indent}set {entry:{width}} = {value}" + (f"  # {comment}" if comment else "")
             for entry, value, comment in entries]
    return ["", f"subsection {section}", *lines, "end"] if section else lines
