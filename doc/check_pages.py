#!/usr/bin/python3
# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Check the pages: links lead to files and headings that exist, so do the names of cases, no
picture is left over, and none has lost its colours to a palette; tables of results are computed.

    doc/check_pages.py
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGES = [ROOT / "README.md", *sorted((ROOT / "doc").glob("*.md"))]
IMAGES = ROOT / "doc" / "images"
RESULTS = ("gallery.md", "tutorial.md")  # whose tables are computed (CONTRIBUTING.md)
PALETTE = 3  # the colour type of PNG, byte 25 of a file


def headings(page):
    """The anchors that web sites with repositories give to the headings of a page."""
    titles = re.findall(r"^#+ (.*)$", page.read_text(encoding="utf-8"), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-") for title in titles}


def links(text):
    """All that are not to other sites."""
    found = re.findall(r"\]\(([^)\s]+)\)", text) + re.findall(r"^\[[^\]]+\]: (\S+)$", text, re.MULTILINE)
    return [link for link in found if not link.startswith("http")]


def check_links(page, text):
    for link in links(text):
        name, _, anchor = link.partition("#")
        target = (page.parent / name).resolve() if name else page
        if not target.exists():
            yield f"there is no '{name}'"
        elif anchor and anchor not in headings(target):
            yield f"there is no heading '#{anchor}' in {target.name}"


def check_cases(text):
    for case in re.findall(r"parameter_files/[\w/]+\.prm", text):
        if not (ROOT / case).exists():
            yield f"there is no case '{case}'"


def check_tables(page, text):
    for before, table in re.findall(r"^(.*)\n((?:[ ]*\|.*\n)+)", text, re.MULTILINE) if page.name in RESULTS else ():
        if re.search(r"\d\.\d", table) and "<!-- table: " not in before:
            yield f"the table '{table.splitlines()[0].strip()}' has no recipe"


def check_pictures():
    used = {(page.parent / link).resolve() for page in PAGES for link in links(page.read_text(encoding="utf-8"))}
    for picture in sorted(IMAGES.iterdir()):
        if picture not in used:
            yield f"{picture.name}: no page shows it"
        if picture.suffix == ".png" and picture.read_bytes()[25] == PALETTE:
            yield f"{picture.name}: a palette of at most 256 colours instead of full colour"


def main():
    errors = list(check_pictures())
    for page in PAGES:
        text = page.read_text(encoding="utf-8")
        found = (*check_links(page, text), *check_cases(text), *check_tables(page, text))
        errors += [f"{page.name}: {error}" for error in found]
    sys.exit("\n".join(errors) or 0)


if __name__ == "__main__":
    main()
