# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Variants of load histories: what they change, and how results are compared; spots of rough surfaces."""

import tempfile
import unittest

from tools.verification.contact_uniqueness import changes, worst_of
from tools.verification.rough_spots import n_spots
from tools.verification.uniqueness_histories import histories
from tools.verification.uniqueness_variants import VARIANTS, as_entries, mirrored


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


class Spots(unittest.TestCase):
    def test_number(self):
        """Four faces in a row, the last with points of its own; pressure at three groups of points."""
        points = [(x, y, 0) for x in range(4) for y in range(2)] + [(3, 0, 0), (3, 1, 0), (4, 0, 0), (4, 1, 0)]
        cells = [[0, 1, 3, 2], [2, 3, 5, 4], [4, 5, 7, 6], [8, 9, 11, 10]]
        pressure = {(0, 0): 1, (0, 1): 2, (2, 1): 1, (3, 0): 1, (4, 1): 3}
        fields = {"points": points, "cells": cells, "contact_pressure": [pressure.get(p[:2], 0) for p in points]}
        self.assertEqual(n_spots(fields), 2)
        fields["contact_pressure"] = [0] * len(points)
        self.assertEqual(n_spots(fields), 0)


if __name__ == "__main__":
    unittest.main()
