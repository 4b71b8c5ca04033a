# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The schema of all entries, and the columns of the tables: what is made of the references, and the committed ones."""

import pathlib
import unittest

from elasto_plastic_contact import UserError
from elasto_plastic_contact.columns import columns_of_reference, known_columns
from elasto_plastic_contact.schema import check_path, entries, make_schema, value_schema

REFERENCE = pathlib.Path(__file__).resolve().parents[2] / "doc/lookup/parameters.md"


class Schema(unittest.TestCase):
    def test_values(self):
        self.assertEqual(value_schema("text"), {"type": "string"})
        self.assertEqual(value_schema("number"), {"type": "number"})
        self.assertEqual(value_schema("integer >= 1"), {"type": "integer", "minimum": 1})
        self.assertEqual(value_schema("number <= 0.5"), {"type": "number", "maximum": 0.5})
        self.assertEqual(value_schema("number from 0 to 1"), {"type": "number", "minimum": 0, "maximum": 1})
        self.assertEqual(value_schema("`box`, `half ball`"), {"enum": ["box", "half ball"]})
        pairs = value_schema("list, separated by commas (at least 1, at most 2, each: `a`, `b`)")
        self.assertEqual(pairs["anyOf"][0],
                         {"type": "array", "items": {"enum": ["a", "b"]}, "minItems": 1, "maxItems": 2})
        with self.assertRaisesRegex(UserError, "allows 'colours', which has no schema"):
            value_schema("colours")

    def test_reference(self):
        page = REFERENCE.read_text(encoding="utf-8")
        self.assertEqual(make_schema(page)["properties"], entries())
        self.assertEqual(entries()["Loading/Depth"]["default"], "0.01")
        with self.assertRaisesRegex(UserError, "do not look like the others"):
            make_schema(page + "### Something/Else\n\nWithout values.\n")

    def test_columns(self):
        self.assertEqual(columns_of_reference(), known_columns())
        self.assertEqual(known_columns()["history"][:4], ["step", "time", "depth", "force"])
        self.assertEqual(known_columns()["error_bound"][-1], "wall_seconds")

    def test_names(self):
        check_path("Material/Yield stress", "set")
        with self.assertRaisesRegex(UserError, "set: there is no entry 'Material/Yeild stress'. Did you mean 'Mat"):
            check_path("Material/Yeild stress", "set")


if __name__ == "__main__":
    unittest.main()
