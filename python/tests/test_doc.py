# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the documentation shows does run: all blocks of doc/recipes/python.md, one after the other, and the
study of doc/recipes/studies.md; the change of doc/develop/example_hardening_law.md fits the files it changes."""

import contextlib
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

from elasto_plastic_contact.study.plan import read_study

DOC = pathlib.Path(__file__).resolve().parents[2] / "doc"
PYTHON = "recipes/python.md"


def blocks(page, language):
    """The line and the text of each block."""
    text = (DOC / page).read_text(encoding="utf-8")
    for found in re.finditer(rf"^```{language}\n(.*?)^```$", text, re.MULTILINE | re.DOTALL):
        yield text.count("\n", 0, found.start(1)), found[1]


class Documentation(unittest.TestCase):
    def test_python(self):
        names, found = {}, list(blocks(PYTHON, "python"))
        self.assertGreater(len(found), 8)
        self.assertEqual((DOC / PYTHON).read_text(encoding="utf-8").count("```"), 2 * len(found))
        with tempfile.TemporaryDirectory() as folder, contextlib.chdir(folder):
            for line, block in found:
                # (empty lines before it, so that an error names the line of the page)
                exec(compile("\n" * line + block, DOC / PYTHON, "exec"), names)  # pylint: disable=exec-used
            self.assertTrue(os.path.isfile("force_depth.png"))

    def test_study(self):
        (_, block), = blocks("recipes/studies.md", "json")
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "study.json"
            path.write_text(block, encoding="utf-8")
            self.assertGreater(len(read_study(path).runs), 3)

    @unittest.skipUnless(shutil.which("git"), "needs git")
    def test_change(self):
        change = "".join(block for _, block in blocks("develop/example_hardening_law.md", "diff"))
        self.assertEqual(change.count("diff --git"), 10)
        result = subprocess.run(["git", "apply", "--check", "-"], input=change, cwd=DOC.parent,
                                stderr=subprocess.PIPE, text=True, check=False)
        self.assertEqual(result.returncode, 0, result.stderr)


if __name__ == "__main__":
    unittest.main()
