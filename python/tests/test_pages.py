# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers in the pages: where they are put, and which differences count."""

import unittest

from elasto_plastic_contact.errors import UserError
from tools.pages.places import differences, fill, names
from tools.pages.recipe import Content, count, percent, power

PAGE = """Two meshes:

  <!-- table: punch -->
  | elements | force | published |
  |---|---|---|
  | linear | 3.19 | $2 + \\pi$ |
  | quadratic | 3.21 | |
  <!-- end of table -->

The force is 3.21<!-- punch.force --> (0.5<!-- sphere.depth -->), over 3.2<!-- punch.share --> %.
"""


class Pages(unittest.TestCase):
    def test_fill(self):
        self.assertEqual(names(PAGE), {"punch", "sphere"})
        content = Content([[None, "3.2", None], [None, "3.3", ""], ["cubic", "3.4", ""]], {"force": "3.3", "share": "7"})
        filled = fill(PAGE, {"punch": content})
        self.assertIn("  |---|---|---|\n  | linear | 3.2 | $2 + \\pi$ |\n  | quadratic | 3.3 | |\n  | cubic | 3.4 | |\n  <!-- end",
                      filled)
        self.assertIn("The force is 3.3<!-- punch.force --> (0.5<!-- sphere.depth -->), over 7<!-- punch.share --> %.", filled)
        self.assertEqual(fill(filled, {"punch": content}), filled)
        self.assertNotIn("quadratic", fill(PAGE, {"punch": Content(content.rows[:1], content.numbers)}))

    def test_what_does_not_fit(self):
        numbers = {"force": "1", "share": "1"}
        for rows in ([[None, "1"]], [[None, "1", ""]] * 3):
            with self.assertRaisesRegex(UserError, "table 'punch', row"):
                fill(PAGE, {"punch": Content(rows, numbers)})
        with self.assertRaisesRegex(UserError, "does not fit into a text"):
            fill(PAGE, {"sphere": Content(numbers={"depth": "Processor (R)"})})
        with self.assertRaisesRegex(UserError, "'sphere' computes no 'depth'"):
            fill(PAGE, {"sphere": Content(numbers=numbers)})

    def test_differences(self):
        for before, after, n in (("| 3.1912 | 7 |", "| 3.1913 | 7 |", 0), ("| 3.1912 |", "| 3.1914 |", 1), ("10,752", "10,753", 0),
                                 ("10,752", "10,762", 1), ("6.86e-3", "6.87e-3", 0), ("6.86e-3", "6.86e-4", 1),
                                 ("+0.1 %", "-0.1 %", 1), ("| 1 | words", "| 1 | other words", 1), ("a\nb", "a", 1)):
            self.assertEqual(len(list(differences(before, after))), n, (before, after))

    def test_formats(self):
        self.assertEqual([count(9226.0), count(10752), percent(0.0048), percent(0.112), percent(0.09), power(0.00686)],
                         ["9226", "10,752", "0.48 %", "11 %", "9.0 %", "6.860e-3"])


if __name__ == "__main__":
    unittest.main()
