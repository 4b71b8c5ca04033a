#!/usr/bin/env python3
# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Prints, as a table in Markdown, how large the program is: lines of include/ and source/ by rooms, short files, files
outside of rooms, includes that run up between rooms, what a reader of the algorithm has to read, and the pages.
Usage: count_lines.py [root of the checkout]"""

import pathlib
import re
import subprocess
import sys

SHORT_FILE = 60
# In which one looks something up (doc/check_pages.py).
LISTS = ("doc/lookup/parameters.md", "doc/lookup/tables.md", "doc/CHANGELOG.md", "doc/theory/references.md")


def lines(path):
    return path.read_text(encoding="utf-8").count("\n")


def sources(root):
    return sorted(path for top in ("include", "source") for path in (root / top).rglob("*.*"))


def lines_by_room(root):
    """By the first folder below include/ and source/, with the folders in it."""
    rooms = {}
    for path in sources(root):
        room = path.relative_to(root).parts[1]
        rooms[room] = rooms.get(room, 0) + lines(path)
    return rooms


def upward_includes(root):
    """What the test `rooms` complains of."""
    done = subprocess.run([sys.executable, root / "tests/rooms.py", root], capture_output=True, text=True, check=False)
    return done.stderr.count("\n")


def files_of_tour(root, heading):
    """The files that the section `heading` of the tour links to."""
    page = root / "doc/develop/tour.md"
    section = page.read_text(encoding="utf-8").partition(f"\n## {heading}\n")[2].partition("\n## ")[0]
    files = [(page.parent / link).resolve() for link in re.findall(r"\]\((\.\./\.\./(?:include|source)/[^)]*)\)", section)]
    if not files:
        sys.exit(f"{page} has no section '{heading}' with links to files. Write it, or mend its name in {sys.argv[0]}.")
    return set(files)


def rows(root):
    files, rooms = sources(root), lines_by_room(root)
    pages = {path.relative_to(root).as_posix(): lines(path) for path in (root / "doc").rglob("*.md")}
    longest = max(pages.keys() - LISTS, key=pages.get)
    yield "lines in include/ and source/", sum(rooms.values())
    for room in sorted(rooms):
        yield f"of them in {room}/", rooms[room]
    yield f"files below {SHORT_FILE} lines, of {len(files)}", sum(lines(path) < SHORT_FILE for path in files)
    yield "files directly in include/ and source/", sum(len(path.relative_to(root).parts) == 2 for path in files)
    yield "includes that run up between rooms", upward_includes(root)
    main_class = files_of_tour(root, "The main class")
    yield "lines to read: the main class", sum(map(lines, main_class))
    with_problem = main_class | files_of_tour(root, "Johnson's problem")
    yield "lines to read: Johnson's problem, with it", sum(map(lines, with_problem))
    yield "lines to read: the whole algorithm", sum(map(lines, files_of_tour(root, "The whole algorithm")))
    yield "pages", len(pages)
    yield f"lines of the longest page that is no list, {longest}", pages[longest]


checkout = pathlib.Path(sys.argv[1] if sys.argv[1:] else pathlib.Path(__file__).parents[1]).resolve()
print("| what | count |\n|---|---:|")
for row in rows(checkout):
    print("| {} | {:,} |".format(*row))
