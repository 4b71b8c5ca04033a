#!/usr/bin/env python3
# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks that every file of include/ and source/ stands in a room, and includes headers of its own room and of
those below it only, and that a program can be built without bounds/: one file asks for it.
Usage: rooms.py [root of the checkout]"""

import pathlib
import re
import sys

# From bottom to top (doc/develop, "Layout").
ROOMS = """
base simd mesh material indenter loading contact solver mechanics loads multigrid adaptivity evaluation
output input restart problem contact_run
bounds/conic bounds/mesh bounds/body bounds/stress bounds/mechanism bounds/error bounds
app
""".split()
# For which source/app/without_bounds.cc stands in (CMake's option STRICT_BOUNDS).
ASKS_FOR_BOUNDS = "source/app/with_bounds.cc"


def complaints(root):
    for path in sorted(path for top in ("include", "source") for path in (root / top).rglob("*.*")):
        name, room = path.relative_to(root), path.parent.relative_to(root).as_posix().partition("/")[2]
        if room not in ROOMS:
            yield f"{name} stands in no room. Move it into one, or add its folder to the list in {sys.argv[0]}."
            continue
        for header in re.findall(r'^ *# *include "(.*/.*)"', path.read_text(encoding="utf-8"), re.MULTILINE):
            other = header.rpartition("/")[0]
            if other not in ROOMS or ROOMS.index(other) > ROOMS.index(room):
                yield f"{name} includes {header}, but {other} is not below {room}."
            elif other.startswith("bounds") and not room.startswith("bounds") and name.as_posix() != ASKS_FOR_BOUNDS:
                yield f"{name} includes {header}, but of what is not in bounds/, only {ASKS_FOR_BOUNDS} may do so."


found = list(complaints(pathlib.Path(sys.argv[1]) if sys.argv[1:] else pathlib.Path(__file__).resolve().parents[1]))
if found:
    sys.exit("\n".join(found))
