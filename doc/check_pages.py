#!/usr/bin/python3
# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Check the pages: each is one that a reader bears, and is in the list of doc/README.md; links lead to
files and headings that exist, so do keys of references, the names of cases and entries, and what the source cites; no
picture is left over, and none has lost its colours to a palette; tables of results are computed.

    doc/check_pages.py
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
DOC = ROOT / "doc"
DOOR = DOC / "README.md"
PAGES = [ROOT / "README.md", *sorted(DOC.rglob("*.md"))]
IMAGES = DOC / "images"
LONGEST = 250  # lines, of a page that is read from its beginning
GENERATED = ("lookup/parameters.md", "lookup/tables.md")  # by the program
LISTS = (*GENERATED, "CHANGELOG.md", "theory/references.md")  # in which one looks something up
RESULTS = ("recipes/", "trust/", "start/tutorial")  # whose tables are computed (develop/contributing.md)
# (closed forms; what other revisions and machines took)
BY_HAND = ("trust/cost", "trust/iterations", "trust/small_strains")
CITING = {"include": "*.h", "source": "*.cc", "tests": "*.cc", "python": "*.py", "parameter_files": "*.prm",
          "scripts": "*"}
PALETTE = 3  # the colour type of PNG, byte 25 of a file


def name_of(page):
    return page.relative_to(DOC if DOC in page.parents else ROOT).as_posix()


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


def check_keys(text):
    """Of references: each leads somewhere."""
    defined = re.findall(r"^\[(\w+)\]:", text, re.MULTILINE)
    for key in sorted(set(re.findall(r"\[([a-z_]+_\d{4})\](?![:(])", text)) - set(defined)):
        yield f"there is no line '[{key}]: ...' (theory/references.md has those of all)"


def check_length(page, text):
    if page not in (ROOT / "README.md", DOOR) and name_of(page) not in LISTS and text.count("\n") > LONGEST:
        yield f"{text.count(chr(10))} lines, more than {LONGEST}: is it the answer to one question?"


def check_cases(text):
    for case in re.findall(r"parameter_files/[\w/]+\.prm", text):
        if not (ROOT / case).exists():
            yield f"there is no case '{case}'"


def check_entries(text):
    """What is set on a command line is an entry, over line ends, too."""
    known = re.findall(r"^### (.+)$", (DOC / GENERATED[0]).read_text(encoding="utf-8"), re.MULTILINE)
    text = re.sub(r"\s+", " ", text)
    for names in re.findall(r"--set (?:\"([^\"=]+)=|'([^=]+)=|([A-Z][\w/]+)=)", text):
        name = "".join(names)
        if name not in (*known, "Section/Entry"):
            yield f"there is no entry '{name}'"


def check_tables(page, text):
    name = name_of(page)
    if not name.startswith(RESULTS) or name.startswith(BY_HAND):
        return
    for before, table in re.findall(r"^(.*)\n((?:[ ]*\|.*\n)+)", text, re.MULTILINE):
        if re.search(r"\d\.\d", re.sub(r"`[^`]*`", "", table)) and "<!-- table: " not in before:
            yield f"the table '{table.splitlines()[0].strip()}' has no recipe"


def check_door():
    """Each page has its line there, and its own name: Doxygen's labels are made of names."""
    listed = [(DOOR.parent / link).resolve() for link in links(DOOR.read_text(encoding="utf-8"))]
    pages = [page for page in PAGES if page.name != "README.md"]
    for page in pages:
        if page not in listed:
            yield f"{name_of(page)}: not in the list of doc/README.md"
        if [other.name for other in pages].count(page.name) > 1:
            yield f"{name_of(page)}: another page has this name, too"


def check_citations():
    """doc/FOLDER, "Heading" and doc/FOLDER/PAGE.md in comments, over line ends, too."""
    titles = {folder: {re.sub(r"^#+ ", "", line) for page in folder.rglob("*.md")
                       for line in page.read_text(encoding="utf-8").splitlines() if line.startswith("#")}
              for folder in DOC.iterdir() if folder.is_dir()}
    for top, pattern in CITING.items():
        for file in sorted(path for path in (ROOT / top).rglob(pattern) if path.is_file() and path.suffix != ".pyc"):
            text = re.sub(r"\s*\n\s*(?:///|//|#)?\s*", " ", file.read_text(encoding="utf-8"))
            where = file.relative_to(ROOT)
            for folder, title in re.findall(r"\bdoc/(\w+), \"([^\"]+)\"", text):
                if title not in titles.get(DOC / folder, ()):
                    yield f"{where}: there is no heading '{title}' in a page of doc/{folder}"
            for page in re.findall(r"\bdoc/[\w/]+\.md", text):
                if not (ROOT / page).exists():
                    yield f"{where}: there is no page '{page}'"


def check_pictures():
    used = {(page.parent / link).resolve() for page in PAGES for link in links(page.read_text(encoding="utf-8"))}
    for picture in sorted(IMAGES.iterdir()):
        if picture not in used:
            yield f"{picture.name}: no page shows it"
        if picture.suffix == ".png" and picture.read_bytes()[25] == PALETTE:
            yield f"{picture.name}: a palette of at most 256 colours instead of full colour"


def main():
    errors = [*check_pictures(), *check_door(), *check_citations()]
    for page in PAGES:
        text = page.read_text(encoding="utf-8")
        found = (*check_links(page, text), *check_keys(text), *check_length(page, text), *check_cases(text),
                 *check_entries(text), *check_tables(page, text))
        errors += [f"{name_of(page)}: {error}" for error in found]
    sys.exit("\n".join(errors) or 0)


if __name__ == "__main__":
    main()
