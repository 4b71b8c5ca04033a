#!/usr/bin/python3
# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Names the links of pages, as they have been installed, that lead to nothing.

usage: installed_links.py FOLDER
"""

import pathlib
import sys

sys.dont_write_bytecode = True  # into the sources
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "doc"))
from check_pages import check_links  # noqa: E402 (it is found there)

FOLDER = pathlib.Path(sys.argv[1])
problems = [f"{page}: {problem}" for page in [FOLDER / "README.md", *sorted((FOLDER / "doc").rglob("*.md"))]
            for problem in check_links(page, page.read_text(encoding="utf-8"))]
sys.exit("\n".join(problems) or 0)
