# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Displacements as muParser and deal.II understand them; every material test has its curve."""

import contextlib
import io
import math
import pathlib
import tempfile
import unittest

import numpy

from elasto_plastic_contact import run
from elasto_plastic_contact.plots.material_test import evaluate, stress_strain
from elasto_plastic_contact.program import CASES

TIMES = numpy.array([0.5, 1., 2.5])


class Displacements(unittest.TestCase):
    def test_expressions(self):
        for expression, exact in (
                ("0.02*t", 0.02 * TIMES), ("0", 0. * TIMES), ("-t^2", -TIMES ** 2),
                ("if(t <= 1, t, if (t<2, 7, 2 - t))", [0.5, 1., -0.5]),
                ("if(t > 0.6 && t < 2 || t == 2.5, 1, 0)", [0., 1., 1.]),
                ("0.01*(1 - 4*abs(t/4 - 0.25 - floor(t/4 + 0.25)))", [0.005, 0.01, -0.005]),
                ("int(t) + sign(-t) + ceil(t)", [1., 1., 5.]),
                ("max(t, 1) + min(1, t, 2) + atan2(0, 1) + ln(e) + 0*pi", [2.5, 3., 4.5])):
            numpy.testing.assert_allclose(evaluate(expression, TIMES), exact, err_msg=expression)

    def test_beyond(self):
        for expression in ("x*t", "t > 1 ? 2 : 3", "__import__('os')", "0.1*t)"):
            with contextlib.redirect_stderr(io.StringIO()) as remark:
                self.assertIsNone(evaluate(expression, TIMES))
            self.assertIn(f"'{expression}' cannot be evaluated here", remark.getvalue())


class MaterialTests(unittest.TestCase):
    def test_all(self):
        cases = sorted(CASES.glob("material/*.prm"))
        self.assertGreater(len(cases), 5)
        with tempfile.TemporaryDirectory() as folder:
            for case in cases:
                results = run(case, pathlib.Path(folder) / case.stem, {
                    "Loading/Number of steps": 8, "Geometry/Initial refinements": 0, "Output/Fields": "never"})
                strain, stress = stress_strain(results)
                self.assertEqual(len(strain), 9, case)
                self.assertTrue(0. < numpy.abs(strain).max() <= 0.1, case)
                self.assertTrue(100. < numpy.abs(stress).max() < 3000., case)
                self.assertTrue(math.isclose(strain[0], 0.) and math.isclose(stress[0], 0.), case)


if __name__ == "__main__":
    unittest.main()
