# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The studies of the page on fits: their problems can be read, their numbers fit into its table, and their standard
errors are those of a linear problem."""

import dataclasses
import pathlib
import tempfile
import types
import unittest
import unittest.mock

import numpy

from elasto_plastic_contact.fitting.models import FunctionModel
from elasto_plastic_contact.fitting.reading import read_problem
from elasto_plastic_contact.fitting.solve import Region
from tools.pages.fits import content_of_changes, content_of_cones, content_of_metals, content_of_pair
from tools.pages.places import fill, names
from elasto_plastic_contact.schema import check_path
from tools.verification.curve_and_imprint import (DEPTH, LOADING, NOISE, PAIR, PLACES, STEP, UNLOADING,
                                               coordinates_of, entries, residuals, standard_errors)
from tools.verification.curve_and_imprint_fit import FITS, problem_of_fit
from tools.verification.published_metals import (CONE, CONE_WITH_SLOPE, METALS, PYRAMID, SLOPE,
                                            problem_of, published_functions, tensile_entries)
from tools.verification import two_cones
from tools.verification.two_cones import ROWS, compare_with_material, compare_with_published
from tools.verification.two_cones import problem_of as problem_of_known

PAGES = pathlib.Path(__file__).resolve().parents[2] / "doc"
PAGE, PAGE_OF_CONES = PAGES / "recipes/fit.md", PAGES / "trust/published_cones.md"


class Studies(unittest.TestCase):
    def test_published_metals(self):
        for metal in METALS.values():
            problem = read_problem(problem_of(metal, CONE, coarse=False))
            self.assertEqual(problem.names, ["sigma_Y", "Es"])
            experiment, = problem.experiments
            self.assertEqual(sum(len(block.y) for block in experiment.blocks), 2)
            problem = read_problem(problem_of(metal, PYRAMID, coarse=True))
            self.assertEqual(problem.names, ["sigma_Y", "Es"])
            self.assertEqual(sum(len(block.y) for block in problem.experiments[0].blocks), 3)
            problem = read_problem(problem_of(metal, CONE_WITH_SLOPE, coarse=True))
            self.assertEqual(problem.names, ["sigma_Y", "Es", "n"])
            # (The stress of the tension test at the plastic strain 0.033, by its own law and as published, within 2 %.)
            modulus, yield_stress, stress, exponent = metal.tensile
            law = tensile_entries(metal)
            strain = law["Material/Power law reference strain"]
            self.assertLess(abs(yield_stress * (1. + 0.033 / strain) ** exponent / stress - 1.), 0.02)
            self.assertAlmostEqual(law["Material/Young's modulus"] / 0.91, 1e3 * modulus)

    def test_slopes_of_a_power_law(self):
        """The problem asks for them, and finds them in a run, where it finds initial ones otherwise."""
        tip = dataclasses.replace(PYRAMID, slope_fit=(0.2, 0.95))
        metal = METALS["Al 7075-T651"]
        data = problem_of(metal, tip, coarse=True)["experiments"]["berkovich"]["data"]
        self.assertEqual([item.get("fit") for item in data], [None, None, [0.2, 0.95]])
        read_problem(problem_of(metal, tip, coarse=True))
        unload = numpy.linspace(2., 1.5, 21)[1:]
        history = numpy.array([(h, h * h) for h in numpy.linspace(0.1, 2., 20)]
                              + [(h, 4. * ((h - 1.5) / 0.5) ** 1.4) for h in unload],
                              [(name, float) for name in ("depth", "force")])
        run = types.SimpleNamespace(history=history, number=lambda path: 0., modelled_part=1.)
        self.assertAlmostEqual(tip.find(SLOPE, run), 4. * 1.4 / 0.5 / 2., delta=1e-5)
        self.assertNotAlmostEqual(PYRAMID.find(SLOPE, run), 4. * 1.4 / 0.5 / 2., delta=1e-5)

    def test_published_functions(self):
        """Of a cone, against what the page says of this program's: within 1 per cent."""
        rows = [line.split("|")[4].strip() for line in PAGE.read_text(encoding="utf-8").splitlines()
                if line.startswith("|") and ("$C$ in GPa" in line or "$dF/dh / h_m$" in line)]
        for metal, (curvature, slope) in zip(METALS.values(), (rows[:2], rows[2:4])):
            found = published_functions(metal)
            self.assertLess(abs(found["loading curvature"] / float(curvature) - 1.), 0.01)
            self.assertLess(abs(found[SLOPE] / float(slope) - 1.), 0.01)

    def test_table_of_metals(self):
        """One row of the page for each number."""
        text = PAGE.read_text(encoding="utf-8")
        self.assertIn("published_metals", names(text))
        computed = [{name: mean for name, (mean, _) in metal.quantities().items()} for metal in METALS.values()]
        fits = [(metal.tensile[0], metal.tensile[2]) for metal in METALS.values()]
        filled = fill(text, {"published_metals": content_of_metals(computed, fits)})
        self.assertEqual(len(filled.splitlines()), len(text.splitlines()))
        self.assertEqual(filled.count("| +0.0 % |"), 10)

    def test_two_cones(self):
        """Four numbers for three parameters; what is published and the material itself compare as equal, in as many
        cells as the table of the page has."""
        compared = compare_with_published({(case, cone): quantities for case, row in ROWS.items()
                                           for cone, quantities in row.published().items()})
        for case, row in ROWS.items():
            problem = read_problem(problem_of_known(row.published(), coarse=True))
            self.assertEqual(problem.names, ["E", "sigma_Y", "n"])
            self.assertEqual(sum(len(block.y) for _, block in problem.blocks()), 4)
            values = row.values()
            known = problem.experiments[0].entries(problem.values([p.coordinate(values[p.name]) for p in problem.parameters]))
            for path, value in row.entries().items():
                self.assertAlmostEqual(known[path] / value, 1.)
            compared += compare_with_material(case, values)
        text = PAGE_OF_CONES.read_text(encoding="utf-8")
        filled = fill(text, {"two_cones": content_of_cones(compared)})
        self.assertEqual(len(filled.splitlines()), len(text.splitlines()))
        self.assertEqual(filled.count(", +0.0 %"), 27)

    def test_errors_of_two_cones(self):
        """Of residuals that are linear in the coordinates, what has to change where a quantity is larger by its noise; a
        row of the page for each."""
        jacobian = numpy.array([[30., 70., 80.], [100., -5., -30.], [30., -30., -40.], [20., 80., 110.]])

        class Linear(FunctionModel):
            def __init__(self, problem, *_):
                super().__init__(lambda x: jacobian @ x, *problem.bounds())

        with tempfile.TemporaryDirectory() as folder, unittest.mock.patch.object(two_cones, "ProgramModel", Linear):
            errors = two_cones.errors_of_fit(1005, pathlib.Path(folder), None, True, 1)
        self.assertEqual(list(errors)[1], ("blunt", SLOPE))
        coordinates = numpy.column_stack(list(errors.values())) / [[1.], [1.], [0.5]]  # (of E, sigma_Y, n)
        numpy.testing.assert_allclose(coordinates @ jacobian, numpy.eye(3), atol=1e-9)
        known = ROWS[1005].published()
        computed = {(1005, cone): dict(quantities) for cone, quantities in known.items()}
        computed[1005, "blunt"]["plastic work share"] += 0.006
        expected = two_cones.expected_change(1005, errors, computed)
        numpy.testing.assert_allclose(expected, -2. * errors["blunt", "plastic work share"])
        text = PAGE_OF_CONES.read_text(encoding="utf-8")
        changes = [[change] * 3 for change in (*errors.values(), expected)]
        filled = fill(text, {"two_cones_errors": content_of_changes(changes)})
        self.assertEqual(len(filled.splitlines()), len(text.splitlines()))

    def test_materials(self):
        for material in PAIR:
            values = entries(coordinates_of(material))
            for path in values:
                check_path(path, "set")
            numpy.testing.assert_allclose([values["Material/Yield stress"], values["Material/Power law exponent"],
                                           values["Material/Young's modulus"]], material)

    def test_fits_of_pair(self):
        """They begin at the second material, within bounds that hold both, and one has the imprint beside the curve."""
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            down = [f"{0.02 - 0.0001 * k},{400 - 30 * k}\n" for k in range(1, 13)]
            (folder / "curve.csv").write_text("Depth (mm),Force (N)\n" + "".join(
                [*(f"{0.001 * k},{k * k}\n" for k in range(1, 21)), *down]))
            (folder / "imprint.csv").write_text("x,height\n0,-0.02\n0.05,0.001\n0.1,0\n")
            problems = [read_problem(problem_of_fit(folder, fit)) for fit in FITS]
        self.assertEqual([[block.kind for _, block in problem.blocks()] for problem in problems],
                         [["load", "unload"], ["load", "unload", "imprint"]])
        for problem in problems:
            self.assertEqual([parameter.start for parameter in problem.parameters], list(PAIR[1]))
            for parameter, true in zip(problem.parameters, PAIR[0]):
                self.assertTrue(parameter.lower < true < parameter.upper)
            found = problem.experiments[0].entries(problem.values(problem.start()))
            known = entries(coordinates_of(PAIR[1]))
            numpy.testing.assert_allclose([found[path] for path in known], list(known.values()))

    def test_table_of_pair(self):
        """One row for each parameter, with both regions; an end that the data do not give has a mark."""
        regions = {name: Region(1., 2., (True, name != "n"), ("", "")) for name in ("sigma_Y", "n", "E")}
        one = types.SimpleNamespace(values=dict.fromkeys(regions, 1.5), regions=regions, n_runs=30)
        content = content_of_pair(dict.fromkeys(FITS, one))
        self.assertEqual([row[2:] for row in content.rows],
                         [["1.5, 1 to 2"] * 2, ["1.5, 1 to > 2"] * 2, ["1.5, 1 to 2"] * 2])
        self.assertEqual(content.numbers, {"runs": "60"})

    def test_standard_errors(self):
        """Of what is linear in the coordinates: one number each in loading, unloading and imprint."""
        first = (2. * LOADING, DEPTH * (1. - 0.1 * (1. - UNLOADING)), 0. * PLACES)
        slope = (UNLOADING[0] - 0.5) * 2. / (0.1 * DEPTH * (UNLOADING[0] - 0.5))

        def at(load, unload, height):
            return (first[0] + NOISE * 2. * load, first[1] - NOISE * 2. / slope * unload,
                    first[2] + NOISE * DEPTH * height)

        curve, imprint = residuals(first, at(1., 2., 3.), first)
        numpy.testing.assert_allclose(curve, numpy.repeat([1., 2.], [len(LOADING), len(UNLOADING)]))
        numpy.testing.assert_allclose(imprint, 3.)
        low, high = ([at(*(sign * STEP * row)) for row in numpy.eye(3)] for sign in (-1., 1.))
        alone, together = standard_errors(low, high, first)
        numpy.testing.assert_allclose(alone[:2], [len(LOADING) ** -0.5, len(UNLOADING) ** -0.5])
        self.assertGreater(alone[2], 1e6)  # (the curve says nothing of the third)
        numpy.testing.assert_allclose(together, [*alone[:2], len(PLACES) ** -0.5])


if __name__ == "__main__":
    unittest.main()
