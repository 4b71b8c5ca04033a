# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A hook of MkDocs: the menu is the list of doc/README.md, whose headings are its parts."""

import pathlib
import re


def on_config(config):
    door = (pathlib.Path(config["docs_dir"]) / "doc/README.md").read_text(encoding="utf-8")
    _, *parts = re.split(r"^## (.+)$", door, flags=re.MULTILINE)
    menu = [{title: [{label[0].upper() + label[1:]: f"doc/{page}"}
                     for label, page in re.findall(r"\[([^\]]+)\]\(([^)#]+\.md)\)", text)]}
            for title, text in zip(parts[::2], parts[1::2])]
    config["nav"] = [{"README": "README.md"}, {"All pages": "doc/README.md"}, *menu]
    return config
