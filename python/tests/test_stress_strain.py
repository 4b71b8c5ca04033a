# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every material test of a bar has its curve, other bodies have none, and the curves are right."""

import math
import pathlib
import tempfile
import unittest

import numpy

from elasto_plastic_contact import run
from elasto_plastic_contact.plots.material_test import stress_strain
from elasto_plastic_contact.program import cases_folder

class MaterialTests(unittest.TestCase):
    def test_all(self):
        cases = sorted(cases_folder().glob("material/*.prm"))
        self.assertGreater(len(cases), 5)
        with tempfile.TemporaryDirectory() as folder:
            for case in cases:
                results = run(case, pathlib.Path(folder) / case.stem, {
                    "Loading/Number of steps": 8, "Geometry/Initial refinements": 0, "Output/Fields": "never"})
                if results.parameters.get("Geometry/Type", "box") != "box":
                    self.assertIsNone(stress_strain(results), case)
                    continue
                strain, stress = stress_strain(results)
                self.assertEqual(len(strain), 9, case)
                self.assertTrue(0. < numpy.abs(strain).max() <= 0.1, case)
                self.assertTrue(100. < numpy.abs(stress).max() < 3000., case)
                self.assertTrue(math.isclose(strain[0], 0.) and math.isclose(stress[0], 0.), case)

    def test_stress_control(self):
        with tempfile.TemporaryDirectory() as folder:
            for axis, traction in (("left", "-100*t; 0; 0"), ("top", "0; 0; 100*t")):
                others = {"left": "right, front, bottom", "top": "left, front, bottom"}[axis]
                results = run("verification/uniaxial_stress.prm", folder, {
                    "Boundary conditions/Roller": others,
                    "Boundary conditions/Free": "back, " + {"left": "top", "top": "right"}[axis],
                    "Boundary conditions/Prescribed displacement": "",
                    "Boundary conditions/Traction": f"{axis}: {traction}", "Loading/Number of steps": 2},
                              overwrite=True)
                strain, stress = stress_strain(results)
                numpy.testing.assert_allclose(stress, [0., 50., 100.], rtol=1e-9)
                numpy.testing.assert_allclose(strain, stress / 200000., rtol=1e-9)


if __name__ == "__main__":
    unittest.main()
