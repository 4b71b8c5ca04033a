# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The version stands in files of several tools, and is the same in all."""

import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]


class Version(unittest.TestCase):
    def test_files(self):
        version = re.search(r"^project\(.* VERSION (\S+)\)", (ROOT / "CMakeLists.txt").read_text(), re.MULTILINE)[1]
        for file, pattern in (("CITATION.cff", r"^version: (\S+)"), ("python/pyproject.toml", r'^version = "(\S+)"'),
                              ("doc/CHANGELOG.md", r"^## .*?([0-9]+\.[0-9]+\.[0-9]+)")):
            found = re.search(pattern, (ROOT / file).read_text(encoding="utf-8"), re.MULTILINE)[1]
            self.assertEqual(found, version, file)


if __name__ == "__main__":
    unittest.main()
