# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Variants of load histories: what they change, and how results are compared."""

import tempfile
import unittest

from elasto_plastic_contact.verification.contact_uniqueness import changes, worst_of
from elasto_plastic_contact.verification.uniqueness_histories import histories
from elasto_plastic_contact.verification.uniqueness_variants import VARIANTS, as_entries, mirrored


def row(force, depth=1, area=1, pressure=1):
    return {"force": force, "depth": depth, "contact_area": area, "max_pressure": pressure}


class Variants(unittest.TestCase):
    def test_units(self):
        base = histories()["sphere in space, force"]
        changed = VARIANTS["length 1e-3 and stress 1e6"].change(base)
        for name, factor in (("Indenter/Radius", 1e-3), ("Geometry/Local radius", 1e-3), ("Material/Yield stress", 1e6)):
            self.assertAlmostEqual(changed.entries[name] / base.entries[name] / factor, 1)
        self.assertAlmostEqual(changed.entries["Loading/History"][0][2], base.entries["Loading/History"][0][2])
        plane = VARIANTS["length 1e6"].change(histories()["cylinder, force"])
        self.assertAlmostEqual(plane.entries["Loading/History"][0][2], 150e6)

    def test_mirrored(self):
        self.assertIsNone(mirrored(histories()["cone"]))
        for name in ("cylinder beside the middle", "Vickers' pyramid", "rough surface"):
            base = histories()[name]
            self.assertNotEqual(mirrored(base), base)
            self.assertEqual(mirrored(mirrored(base)), base)
        quarter = mirrored(histories()["sphere in space"]).entries
        self.assertEqual(quarter["Boundary conditions/Roller"], ("right", "front"))
        self.assertEqual(quarter["Geometry/Upper corner"][0], 0)

    def test_each_history_is_changed(self):
        for name, base in histories().items():
            for variant in ("shape", "load", "direct", "length 1e6"):
                self.assertNotEqual(VARIANTS[variant].change(base), base, (name, variant))

    def test_text(self):
        with tempfile.TemporaryDirectory() as folder:
            entries = as_entries(histories()["rough profile"], folder)
            self.assertEqual(len(entries["Indenter/File"].read_text(encoding="utf-8").split()), 9)
        self.assertTrue(entries["Loading/History"].startswith("1: depth 0.004 | 1.2: depth 0.00384 | 1.4: "))

    def test_changes(self):
        found = changes([row(1), row(100)], [row(1.5), row(101, area=1.1)])
        self.assertAlmostEqual(found["force"], 0.5)
        self.assertAlmostEqual(found["contact_area"], 0.1)
        self.assertAlmostEqual(changes([row(0), row(100)], [row(0.01), row(100)])["force"], 0.1)
        self.assertIsNone(changes([row(1)], [row(1), row(1)]))
        self.assertEqual(worst_of({"a": found, "b": found | {"force": 0.7}, "c": "other steps"}),
                         [0.7, 0, found["contact_area"], 0, "b; c: other steps"])


if __name__ == "__main__":
    unittest.main()
