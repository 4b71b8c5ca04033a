# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The evaluation of an unloading: a known law, the program's own, noise, laboratory constants."""

import dataclasses
import tempfile
import unittest

import numpy

from elasto_plastic_contact import UserError, run
from elasto_plastic_contact.oliver_pharr import Tip, evaluate, fit_power_law, jumps_of_meshes
from elasto_plastic_contact.rounded_pyramid import section


def test_of_law(exponent, final_depth, noise=0.):
    """Loading to the depth 1 and force 10, and unloading by 10 ((h - h_f) / (1 - h_f))^m."""
    depth = numpy.append(numpy.linspace(0., 1., 200, endpoint=False), numpy.linspace(1., final_depth, 300))
    force = numpy.where(numpy.arange(500) < 200, 10. * depth ** 2,
                        10. * ((depth - final_depth).clip(0.) / (1. - final_depth)) ** exponent)
    return depth, force + noise * numpy.random.default_rng(1).normal(size=500)


class OliverPharr(unittest.TestCase):
    def test_fit(self):
        depth = numpy.linspace(0.8, 1., 7)
        for exact in ((3., 1.5, 0.7), (2., 2., -1.), (5., 1.05, 0.79)):  # coefficient, exponent, final depth
            found = fit_power_law(depth, exact[0] * (depth - exact[2]) ** exact[1])
            numpy.testing.assert_allclose(found, (numpy.log(exact[0]), *exact[1:]), rtol=1e-5)

    def test_rounded_pyramid(self):
        """A ball at the tip, and far above it the sharp pyramid that its centre moves in, less the rounded edges."""
        for n_faces, angle in ((3, 35.264), (3, 65.27), (4, 68.)):
            self.assertAlmostEqual(section(1e-4, n_faces, angle, 2.), numpy.pi * 1e-4 * (4. - 1e-4))
            missing = 2. * (1. / numpy.sin(numpy.radians(angle)) - 1.)
            sharp = Tip.pyramid(n_faces, angle, missing).area(1e3)
            self.assertAlmostEqual(section(1e3, n_faces, angle, 2.) / sharp, 1., delta=1e-4)
            self.assertLess(section(1e3, n_faces, angle, 2.), sharp)
        self.assertEqual(section(0., 4, 68., 2.), 0.)

    def test_law(self):
        found, = evaluate(*test_of_law(1.4, 0.7), Tip.cone(70.3))
        self.assertAlmostEqual(found.stiffness, 1.4 * 10. / 0.3, places=4)
        height = 1. - (2. - 4. / numpy.pi) * 10. / found.stiffness
        self.assertAlmostEqual(found.contact_depth, height)
        area = numpy.pi * (height * numpy.tan(numpy.radians(70.3))) ** 2
        self.assertAlmostEqual(found.tip_hardness, 10. / area)
        self.assertAlmostEqual(found.tip_reduced_modulus, numpy.sqrt(numpy.pi / area) / 2. * found.stiffness)

    def test_constants_of_laboratories(self):
        curve, polynomial = test_of_law(1.4, 0.7), Tip.polynomial([24.5, 3.])
        theory, = evaluate(*curve, polynomial, epsilon=0.75)
        usual, = evaluate(*curve, polynomial, beta=1.034)
        self.assertEqual(theory.tip_area, 24.5 * theory.contact_depth ** 2 + 3. * theory.contact_depth)
        self.assertAlmostEqual(theory.tip_reduced_modulus / usual.tip_reduced_modulus, 1.034, places=12)

    def test_noise(self):
        exact, = evaluate(*test_of_law(1.4, 0.7), Tip.sphere(5.))
        found, = evaluate(*test_of_law(1.4, 0.7, 0.01), Tip.sphere(5.), noise=0.01)
        self.assertAlmostEqual(found.stiffness / exact.stiffness, 1., delta=0.02)
        dense = [numpy.interp(numpy.linspace(0, 499, 20000), range(500), column) for column in test_of_law(1.4, 0.7)]
        dense[1] += 0.01 * numpy.random.default_rng(2).normal(size=20000)
        found, = evaluate(*dense, Tip.sphere(5.), noise=0.01)
        self.assertAlmostEqual(found.stiffness / exact.stiffness, 1., delta=0.02)

    def test_what_is_refused(self):
        depth, force = test_of_law(1.4, 0.7)
        for constants, message in (({"beta": 0.}, "beta: it is '0.0', but must be a number > 0"),
                                   ({"epsilon": 5.}, "epsilon: it is '5.0', but must be a number > 0 and <= 1"),
                                   ({"noise": numpy.nan}, "noise: it is 'nan', but must be"),
                                   ({"beta": [1., 2.]}, r"beta: it is '\[1.0, 2.0\]', but must be a number")):
            with self.assertRaisesRegex(UserError, message):
                evaluate(depth, force, Tip.cone(70.3), **constants)
        for curve in (([], []), ([1., 2.], [1.]), (depth, None), (depth, depth * numpy.nan), ("ab", "cd")):
            with self.assertRaisesRegex(UserError, "depth and force must be finite numbers"):
                evaluate(*curve, Tip.cone(70.3))

    def test_too_few_points(self):
        depth, force = test_of_law(1.4, 0.7)
        self.assertEqual(evaluate(depth[:205], force[:205], Tip.cone(70.3)), [])
        self.assertEqual(evaluate(depth[:200], force[:200], Tip.cone(70.3)), [])

    def test_history_of_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            results = run("indentation/cone_axisymmetric.prm", folder, {
                "Geometry/Local refinements": 4, "Geometry/Local radius": 4, "Refinement/Elements over contact radius": 0,
                "Loading/History": "1: depth 0.02 | 2: force 3 | 3: depth 0.03 | 4: force 0",
                "Loading/Number of steps": 40, "Indenter/Initial gap": 0.001, "Output/Fields": "never"})
            self.compare(results, Tip.cone(70.3), 0.001)
            results = run("indentation/sphere_axisymmetric.prm", folder, {
                "Geometry/Local refinements": 6, "Geometry/Local radius": 4,
                "Refinement/Elements over contact radius": 0, "Loading/Number of steps": 30, "Output/Fields": "never"},
                          overwrite=True)
            self.compare(results, Tip.sphere(results.number("Indenter/Radius")))

    def test_constants_of_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            results = run("indentation/cone_axisymmetric.prm", folder, {
                "Geometry/Local refinements": 3, "Loading/Number of steps": 40, "Output/Fields": "never",
                "Evaluation/Beta": 1.05, "Evaluation/Epsilon": 0.75, "Evaluation/Young's modulus of the indenter": 1e6,
                "Evaluation/Poisson's ratio of the indenter": 0.5})
            self.compare(results, Tip.cone(70.3), beta=1.05, epsilon=0.75, indenter_compliance=0.75e-6)
            row = results.indentation[0]
            of_rigid_indenter = row["stiffness"] / (2. * 1.05) * numpy.sqrt(numpy.pi / row["contact_area"])
            self.assertAlmostEqual(row["reduced_modulus"] * (1. / of_rigid_indenter + 0.75e-6), 1.)

    def test_history_on_meshes_that_change(self):
        with tempfile.TemporaryDirectory() as folder:
            results = run("indentation/sphere_axisymmetric.prm", folder, {
                "Geometry/Initial refinements": 3, "Geometry/Local refinements": 7, "Geometry/Local radius": 4,
                "Refinement/Elements over contact radius": 0, "Loading/Number of steps": 30,
                "Loading/History": "1: depth 0.002 | 2: force 0", "Refinement/Strategy": "Kelly",
                "Refinement/Refinement fraction": 0.1, "Refinement/Coarsening fraction": 0.3,
                "Refinement/Steps between adaptations": 2, "Refinement/Maximum number of unknowns": 1500,
                "Output/Fields": "never"})
            top = int(results.history["force"].argmax())
            shift, factor = jumps_of_meshes(results)
            self.assertTrue(shift[-1] != shift[top] or factor[-1] != factor[top])
            self.compare(results, Tip.sphere(results.number("Indenter/Radius")))

    def compare(self, results, tip, gap=0., **constants):
        found = evaluate(results.history["depth"], results.history["force"], tip, initial_gap=gap,
                         jumps=jumps_of_meshes(results), **constants)
        self.assertEqual(len(found), len(results.indentation))
        for unloading, row in zip(found, results.indentation):
            for name, value in dataclasses.asdict(unloading).items():
                self.assertAlmostEqual(value / row[name], 1., delta=1e-7, msg=name)


if __name__ == "__main__":
    unittest.main()
