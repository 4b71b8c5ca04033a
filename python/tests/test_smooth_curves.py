# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves through load histories: what they reproduce, and that they leave waves."""

import math
import unittest

from tools.verification.contact_law import biases, largest_pressure, pressure_errors, waves_of
from tools.verification.contact_law_bodies import SHAPES, mesh
from tools.verification.smooth_curves import SmoothCurve, at_place, initial_slope, waves

DEPTHS = [0.002 * (i + 1) / 120 for i in range(120)]


def loading(force, n_points=20):
    """A run as contact_law has it; the pressure is that on n_points nodes."""
    rows, profiles = [], {}
    for i, depth in enumerate(DEPTHS, 1):
        radius = math.sqrt(2 * depth)
        rows.append({"depth": depth, "force": force(depth), "contact_area": math.pi * radius**2, "contact_radius": radius,
                     "max_pressure": 2 * force(depth) / (math.pi * radius**2),
                     "mean_depth": depth, "mean_force": force(depth) if i % 5 == 0 else math.nan})
        mean = rows[-1]["force"] / rows[-1]["contact_area"]
        profiles[str(i)] = [(radius * j / n_points, mean) for j in range(n_points)]
    return {"history": rows, "profiles": profiles}


class SmoothCurves(unittest.TestCase):
    def test_its_own_powers(self):
        curve = SmoothCurve(DEPTHS, [3 * d - 5 * d**1.5 + 7 for d in DEPTHS], (0, 1, 1.5))
        for depth in (0.0005, 0.0019):
            self.assertAlmostEqual(curve(depth), 3 * depth - 5 * depth**1.5 + 7, places=12)

    def test_published_curves_are_smooth(self):
        """Fits of the force of a sphere, over the last two thirds (doc/trust/elements.md), within 0.05 %."""
        late = DEPTHS[40:]
        for force in (lambda d: d**1.263, lambda d: d**1.5, lambda d: d * math.log(1e5 * d)):
            self.assertLess(waves(late, [force(d) for d in late], SHAPES["sphere"].force), 5e-4)
        self.assertLess(waves(late, [d**2 for d in late], SHAPES["cone"].force), 1e-12)

    def test_waves_are_found(self):
        late = DEPTHS[40:]
        for n_waves in (3, 5, 10):
            wavy = [d**1.263 * (1 + 0.01 * math.sin(2 * math.pi * n_waves * d / 0.002)) for d in late]
            self.assertAlmostEqual(waves(late, wavy, SHAPES["sphere"].force), 0.01, delta=0.003)

    def test_slope_of_an_unloading(self):
        depths = [1, 0.99, 0.98, 0.97, 0.96]
        self.assertAlmostEqual(initial_slope(depths, [4 * (d - 0.8) ** 2 for d in depths]), 1.6)

    def test_between_places(self):
        self.assertEqual([at_place((1, 2, 4), (5, 6, 10), x) for x in (0, 1, 1.5, 3, 9)], [5, 5, 5.5, 8, 10])


class ContactLaw(unittest.TestCase):
    def test_errors(self):
        fine, run = loading(lambda d: d**1.3), loading(lambda d: 1.02 * d**1.3, 5)
        for found, expected in zip(biases(SHAPES["sphere"], run, [fine, fine]), (2, 2, 2)):
            self.assertAlmostEqual(found, expected, places=2)
        for found in pressure_errors(run, fine):
            self.assertAlmostEqual(found, 2)
        self.assertAlmostEqual(largest_pressure(run, fine), 102)
        self.assertLess(max(waves_of(SHAPES["sphere"], run)), 0.05)

    def test_meshes_have_the_same_sides(self):
        sides = {mesh(1, n, 2)["Geometry/Upper corner"] for n in (4, 5, 6, 10, 80)}
        self.assertEqual(len(sides), 1)
        self.assertEqual(mesh(1, 10, 3)["Geometry/Repetitions"], (5, 5, 5))


if __name__ == "__main__":
    unittest.main()
