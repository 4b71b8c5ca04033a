# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the headings of columns mean."""

import re
import unicodedata

from .east_asian import words_of
from .units import FACTORS, KINDS, split_name, tidy

# The names of each quantity without blanks and signs, those of a line before those of the lines below.
NAMES = {
    "depth": (("displacementintosurface", "displacementintosample", "indentationdepth", "penetrationdepth", "depth",
               "correcteddepth", "indentdepth", "pd", "h", "eindringtiefe", "eindringweg", "profondeurdepenetration",
               "enfoncement"),
              ("penetration", "displacement", "disp", "indentdisp", "normaldisp", "normaldisplacement", "zdisp", "indenterdisplacement",
               "correcteddisplacement", "tipdisplacement", "indentationdisplacement", "weg", "normalweg",
               "tiefe", "profondeur", "deplacement", *words_of("depth")),
              ("rawdisplacement", "rawdepth", "indentation", "standardweg", "extension")),
    "force": (("loadonsample", "forceonsurface", "forceonsample", "correctedload", "correctedforce"),
              ("load", "force", "f", "p", "fn", "pn", "normalforce", "normalload", "indentload", "indentationload",
               "indentationforce", "testforce", "testload", "appliedload", "appliedforce", "forcesensor", "forcea", "kraft",
               "prüfkraft", "pruefkraft", "normalkraft", "last", "forcenormale", "charge", "effort",
               *words_of("force")),
              ("rawload", "rawforce", "standardkraft")),
    "time": (("timeonsample", "timeincontact", "testtime"),
             ("time", "t", "zeit", "elapsedtime", "prüfzeit", "pruefzeit", "temps",
              *words_of("time")),
             ("timestamp", "datetime", "clock", "uhrzeit", "heure")),
    "stiffness": (("harmoniccontactstiffness", "contactstiffness", "dynamicstiffness", "storagestiff", "stiffness"),
                  (), ()),
}

# A letter for a quantity behind its name, as in 'Load P', or two, as in 'Normal force (Fn)'.
SYMBOL = re.compile(r"(?<=\w)\s*[\s,]\W*(?:Δ|δ)?(?:[hdPpFLt]|Pd|Fn|Pn)\W*$")

# Signs, of which names are told apart without.
SIGN = re.compile(r"[^a-z0-9äöüß\u3040-\u30ff\u4e00-\u9fff]")

# Columns that number the indents of a table.
INDENTS = {"test", "testno", "testnumber", "indent", "indentno", "indentnumber", "indentation", "indentationno",
           "indentationnumber", "messung", "eindruck"}

# Columns of results, one row an indent.
RESULTS = {"loading_curvature": ("c", "loadingcurvature"),
           "stiffness": ("dpdh", "s", "unloadingslope", "unloadingstiffness"),
           "plastic_share": ("wpwt", "workratio"), "max_depth": ("hm", "hmax", "maxdepth", "maximumdepth"),
           "max_force": ("pm", "pmax", "fm", "fmax", "maxload", "maximumload", "maxforce"),
           "hardness": ("hardness", "hit"), "modulus": ("modulus", "eit", "e", "er", "youngsmodulus", "reducedmodulus")}


def key(name):
    """In small letters, without accents, blanks and signs."""
    letters = (letter if letter in "äöüß" else unicodedata.normalize("NFKD", letter)[0] for letter in name.lower())
    return SIGN.sub("", "".join(letters))


def name_and_unit(heading, kind):
    """The unit is empty unless it is of this kind."""
    name, unit = split_name(heading)
    return (name, unit) if unit in FACTORS[kind] else (heading, "")


def rank(heading, quantity):
    """How well a heading names a quantity: 0 best; None if it does not."""
    name = name_and_unit(heading, KINDS[quantity])[0]
    known = {key(name), key(SYMBOL.sub("", name))}
    return next((rank for rank, names in enumerate(NAMES[quantity]) if not known.isdisjoint(names)), None)


def best_rank(headings, quantity):
    """How well the best of them names it; None if none does."""
    return min((found for heading in headings if (found := rank(heading, quantity)) is not None), default=None)


def columns_of(headings, quantity):
    """The numbers of the columns that name it best."""
    best = best_rank(headings, quantity)
    return [column for column, heading in enumerate(headings) if best is not None and rank(heading, quantity) == best]


def unit_of(heading, unit, quantity):
    """Of a column with this heading and this cell in the row of units (or ''); empty if unknown."""
    below = tidy(unit.strip().strip("()[]"))
    return below if below in FACTORS[KINDS[quantity]] else name_and_unit(heading, KINDS[quantity])[1]


def indent_column(headings):
    """The number of the column that numbers the indents; None if there is not one."""
    found = [column for column, heading in enumerate(headings) if key(heading) in INDENTS]
    return found[0] if len(found) == 1 else None


def result_columns(headings):
    """The number of the column of each result that is there."""
    keys = [key(split_name(heading)[0]) for heading in headings]
    return {result: column for result, names in RESULTS.items() for column, name in enumerate(keys) if name in names}
