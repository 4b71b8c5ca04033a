# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""BibTeX of what a report cites: a copy of doc/references.bib that is installed, and this program itself."""

import functools
import json
import pathlib
import re

from ..program import checkout

FILE = pathlib.Path(__file__).with_name("references.json")

# deal.II's articles, by the version that they are about; of other versions the one about all.
DEAL_II = {"9.4": "arndt_2022", "9.5": "arndt_2023", "9.6": "africa_2024", "9.7": "arndt_2025"}
DEAL_II_ANY = "arndt_2021"


def entries_of_bibliography():
    """The entries of doc/references.bib by their keys."""
    text = (checkout() / "doc/references.bib").read_text(encoding="utf-8")
    return {re.match(r"@\w+\{(\w+),", entry)[1]: entry for entry in re.split(r"\n+(?=@)", text.strip())}


@functools.lru_cache
def known_entries():
    """The same without a checkout."""
    return json.loads(FILE.read_text(encoding="utf-8"))


def key_of_deal_ii(version):
    """version: such as 9.4.1, or None."""
    return DEAL_II.get(".".join((version or "").split(".")[:2]), DEAL_II_ANY)


def entry_of_program(program):
    """program: what the run has recorded of it, or None."""
    version = f"  version = {{{program['version']}}},\n" if program else ""
    note = f"  note    = {{revision {program['revision']}}},\n" if program and program["revision"] else ""
    return ("@software{elasto_plastic_contact,\n  author  = {{The ElastoPlasticContact authors}},\n"
            "  title   = {{ElastoPlasticContact}: elasto-plastic bodies in contact with a rigid indenter},\n"
            f"{version}{note}  license = {{LGPL-2.1-or-later}}\n}}")


def bibtex(program, keys):
    """Of the program and these keys of references.bib, each once, in this order."""
    return "\n\n".join([entry_of_program(program), *(known_entries()[key] for key in dict.fromkeys(keys))])
