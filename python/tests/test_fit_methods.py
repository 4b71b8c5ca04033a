# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts of a fit with functions in place of the program: minima, derivatives, noise, regions, coverage, uniqueness."""

import types
import unittest
import unittest.mock

import numpy
from scipy import optimize, stats

from elasto_plastic_contact import UserError
from elasto_plastic_contact.fitting import optimisation
from elasto_plastic_contact.fitting.flow_stress import flow_stress, total_strain
from elasto_plastic_contact.fitting.formulas import Formula
from elasto_plastic_contact.fitting.models import CorrectedModel, FunctionModel
from elasto_plastic_contact.fitting.optimisation import Derivatives, minimise, noise_of, polish
from elasto_plastic_contact.fitting.problem import Experiment, Parameter, Problem
from elasto_plastic_contact.fitting.profiles import better_point, profiles
from elasto_plastic_contact.fitting.runs import Failure
from elasto_plastic_contact.fitting.statistics import (UNKNOWN, covariance, covariance_of_known, directions,
                                                       independent_points, quality)
from elasto_plastic_contact.fitting.uniqueness import Material, family, representative
from tools.verification.fit_coverage import Repetitions

# A sphere of the radius 1 whose hardness is three times the flow stress at the plastic strain 0.2 a/R (Tabor, 1951).
DEPTHS = numpy.linspace(0.002, 0.1, 120)
TRUTH = numpy.array([numpy.log(400.), 0.4])
LOWER, UPPER = numpy.array([numpy.log(100.), 0.]), numpy.array([numpy.log(2000.), 1.])
START = numpy.array([numpy.log(900.), 0.1])
BOUND = stats.chi2.ppf(0.95, 1)


def tabor(x):
    yield_stress, exponent = numpy.exp(x[0]), 0.5 * x[1]
    strain = 0.2 * numpy.sqrt(2. * DEPTHS)
    return 3. * yield_stress * (1. + 200000. * strain / yield_stress) ** exponent * 2. * numpy.pi * DEPTHS


SIGMA = 0.01 * tabor(TRUTH).max()


def measured(seed):
    return tabor(TRUTH) + SIGMA * numpy.random.default_rng(seed).normal(size=len(DEPTHS))


def model_of(seed, lower=LOWER, upper=UPPER):
    y = measured(seed)
    return FunctionModel(lambda x: (tabor(x) - y) / SIGMA, lower, upper)


class Formulas(unittest.TestCase):
    def test_values(self):
        names, values = ["sigma_Y", "E"], {"sigma_Y": 400., "E": 200000.}
        for text, value in (("sigma_Y / E", 0.002), ("2 * sqrt(sigma_Y) - -1", 41.),
                            ("max(sigma_Y, E) ** 0.5", 200000 ** 0.5),
                            (3, 3.), ("exp(log(E))", 200000.)):
            self.assertAlmostEqual(Formula(text, names, "entries/x")(values), value, places=8)

    def test_messages(self):
        for text, message in (("sigma +", "is no formula"),
                              ("sigma_y", "there is no 'sigma_y': there are sigma_Y, exp"),
                              ("__import__('os')", "is no formula"), ("'a'", "is no formula"),
                              ("E if E else 1", "is no formula"),
                              ("exp(x=1)", "is no formula")):
            with self.assertRaisesRegex(UserError, message):
                Formula(text, ["sigma_Y"] if "y" in text else ["sigma_Y", "E", "x", "sigma"], "entries/x")
        with self.assertRaisesRegex(UserError, "is no finite number with E = 0: change the bounds"):
            Formula("1 / E", ["E"], "entries/x")({"E": 0.})


class FlowStresses(unittest.TestCase):
    def test_laws(self):
        strain = numpy.array([0., 0.01, 0.2])
        base = {"Material/Yield stress": "400", "Material/Isotropic hardening modulus": "1000",
                "Material/Law": "perfectly plastic"}
        numpy.testing.assert_allclose(flow_stress(base, strain), 400.)
        base["Material/Law"] = "isotropic hardening"
        numpy.testing.assert_allclose(flow_stress(base, strain), 400. + 1000. * strain)
        kinematic = base | {"Material/Law": "kinematic hardening", "Material/Kinematic hardening modulus": "500"}
        numpy.testing.assert_allclose(flow_stress(kinematic, strain), 400. + 500. * strain)
        nonlinear = base | {"Material/Law": "nonlinear hardening", "Material/Voce stress": "100",
                            "Material/Voce rate": "20",
                            "Material/Power law exponent": "0.3", "Material/Power law reference strain": "0.002",
                            "Material/Hardening table": "0.01: 450 | 0.05: 500",
                            "Material/Back stress moduli": "2000 | 300",
                            "Material/Recovery rates": "40 | 0"}
        expected = (400. + 1000. * strain + 100. * (1. - numpy.exp(-20. * strain))
                    + 400. * ((1. + strain / 0.002) ** 0.3 - 1.) + numpy.interp(strain, [0., 0.01, 0.05],
                                                                                [0., 50., 100.])
                    + 50. * (1. - numpy.exp(-40. * strain)) + 300. * strain)
        numpy.testing.assert_allclose(flow_stress(nonlinear, strain), expected)
        two = {"Material/Law": "perfectly plastic", "Material/Yield stress": "400, 500",
               "Material/Young's modulus": "1000, 2000"}
        numpy.testing.assert_allclose(flow_stress(two, strain, 1), 500.)
        numpy.testing.assert_allclose(total_strain(two, 500., strain, 1), 0.25 + strain)
        with self.assertRaisesRegex(UserError, "no stress-strain curve"):
            flow_stress({"Material/Law": "linear elastic"}, strain)


class Minima(unittest.TestCase):
    def test_minimum(self):
        """That of another method, from a bad start."""
        model = model_of(1)
        found = minimise(model, START, 0.02)
        self.assertTrue(found.converged)
        best = optimize.minimize(lambda x: (model.residuals(x) ** 2).sum(), TRUTH, method="Nelder-Mead",
                                 options={"xatol": 1e-9, "fatol": 1e-9})
        self.assertLess(found.chi_square - best.fun, 0.01)
        self.assertGreaterEqual(found.chi_square - best.fun, -1e-6)

    def test_unknown_noise(self):
        """Sigmas that are a hundred times too large stop nothing too early."""
        model = model_of(1)
        best = minimise(model, START, 0.02)
        other = FunctionModel(lambda x: 0.01 * model.residuals(x), LOWER, UPPER, noise_is_known=False)
        self.assertLess((1e4 * minimise(other, START, 0.02).chi_square - best.chi_square), 0.02)

    def test_bound(self):
        """A minimum that lies beyond a bound: the best point on it."""
        model = model_of(1, upper=numpy.array([UPPER[0], 0.3]))
        found = minimise(model, START, 0.02)
        self.assertTrue(found.converged)
        self.assertEqual(found.x[1], 0.3)
        best = optimize.minimize_scalar(lambda a: (model.residuals([a, 0.3]) ** 2).sum(), bounds=(5., 7.),
                                        method="bounded")
        self.assertLess(found.chi_square, best.fun + 0.02 * best.fun / len(DEPTHS))

    def test_failed_runs(self):
        """Where the first step leads there is no result: said, and avoided."""
        y, said = measured(1), []

        def function(x):
            if x[0] > numpy.log(480.) and x[1] > 0.3 or x[0] < numpy.log(250.):
                raise ArithmeticError("no convergence")
            return (tabor(x) - y) / SIGMA

        model = FunctionModel(function, LOWER, UPPER)
        found = minimise(model, START, 0.02, said.append)
        self.assertTrue(found.converged)
        self.assertTrue(any("the run has failed; nearer points are tried: no convergence" in text for text in said))
        self.assertLess(abs(found.x[0] - TRUTH[0]), 0.2)
        with self.assertRaisesRegex(UserError, "the run at the start has failed.*no convergence. Give another start"):
            minimise(model, numpy.array([numpy.log(200.), 0.1]), 0.02)

    def test_wrong_derivatives(self):
        """Where improved derivatives lead nowhere, they are taken anew."""
        with unittest.mock.patch.object(optimisation, "improved", lambda slopes, *_: numpy.roll(slopes, 40, axis=0)):
            found = minimise(model_of(1), START, 0.02, tolerance=1e-4)
        self.assertTrue(found.converged, found.remark)

    def test_not_smooth(self):
        """A function with jumps of half a percent has no minimum to this tolerance: no endless search."""
        y = measured(1)
        model = FunctionModel(lambda x: (tabor(x) * (1. + 0.005 * numpy.sin(1e5 * x.sum() * DEPTHS)) - y) / SIGMA,
                              LOWER, UPPER)
        found = minimise(model, START, 0.02)
        self.assertLess(abs(found.x - TRUTH).max(), 0.3)
        self.assertTrue(found.converged or found.remark)

    def test_coarse_and_fine(self):
        """A coarse model with 5 % more force leads to the minimum of the fine one, which is asked a few times."""
        fine, y = model_of(2), measured(2)
        coarse = FunctionModel(lambda x: (tabor(x) * (1.05 + 0.02 * x[1]) - y) / SIGMA, LOWER, UPPER)
        found = minimise(coarse, START, 0.02)
        for _ in range(3):
            at, = fine.evaluate([found.x])
            shifted = CorrectedModel(coarse, at - coarse.residuals(found.x))
            found = polish(shifted, found.x, found.jacobian, [0, 1], residuals=at)
        best = minimise(model_of(2), found.x, 0.02)
        self.assertLess((fine.residuals(found.x) ** 2).sum() - best.chi_square, 0.2)
        self.assertEqual(fine.n_evaluations, 4)

    def test_corrected(self):
        """A coarse model with the values and derivatives of the fine one at its minimum has the regions of the fine
        one."""
        fine, y = model_of(2), measured(2)
        coarse = FunctionModel(lambda x: (tabor(x) * (1.05 + 0.05 * x[1]) - y) / SIGMA, LOWER, UPPER)
        best = minimise(fine, TRUTH, 0.005, tolerance=1e-6)
        at, = coarse.evaluate([best.x])
        slopes = Derivatives(coarse, 0.005)(best.x, at)
        corrected = CorrectedModel(coarse, best.residuals - at, best.x, best.jacobian - slopes)
        deviations = numpy.sqrt(numpy.diag(covariance(best.jacobian)))
        for pair, others in zip(profiles(corrected, best, BOUND, deviations), profiles(fine, best, BOUND, deviations)):
            for end, other in zip(pair, others):
                self.assertLess(abs(end.x - other.x).max(), 0.1 * deviations.max())

    def test_derivatives(self):
        model = model_of(1)
        exact = optimize.approx_fprime(TRUTH, model.residuals, 1e-7)
        found = Derivatives(model, 0.02)(TRUTH, model.residuals(TRUTH))
        numpy.testing.assert_allclose(found, exact, atol=2e-3 * numpy.abs(exact).max())
        corner = Derivatives(model, 0.002)(UPPER, model.residuals(UPPER))  # one-sided there
        numpy.testing.assert_allclose(corner, optimize.approx_fprime(UPPER, model.residuals, -1e-7),
                                      atol=5e-3 * numpy.abs(corner).max())

        def fails_above(x):
            if x[0] > TRUTH[0] + 1e-9:
                raise ArithmeticError("no convergence")
            return model.residuals(x)

        one_sided = Derivatives(FunctionModel(fails_above, LOWER, UPPER), 0.02)(TRUTH, model.residuals(TRUTH))
        numpy.testing.assert_allclose(one_sided, exact, atol=0.03 * numpy.abs(exact).max())

        def fails_around(x):
            if x[0] != TRUTH[0]:
                raise ArithmeticError("no convergence")
            return model.residuals(x)

        with self.assertRaisesRegex(UserError, "fail on both sides, so that there are no derivatives"):
            Derivatives(FunctionModel(fails_around, LOWER, UPPER), 0.02)(TRUTH, model.residuals(TRUTH))

    def test_noise(self):
        """Errors of the function are found to a factor of two; what is smooth has none."""
        self.assertLess(noise_of(model_of(1), TRUTH), 1e-4)
        generator, y = numpy.random.default_rng(3), measured(1)
        size = 0.003 * tabor(TRUTH).max()
        noisy = FunctionModel(lambda x: (tabor(x) + size * generator.normal(size=len(DEPTHS)) - y) / SIGMA, LOWER,
                              UPPER)
        exact = optimize.approx_fprime(TRUTH, model_of(1).residuals, 1e-7).sum(axis=1)
        expected = 0.3 / numpy.sqrt((exact ** 2).mean())
        self.assertLess(abs(numpy.log(noise_of(noisy, TRUTH) / expected)), numpy.log(2.))


class Errors(unittest.TestCase):
    def test_independent_points(self):
        generator = numpy.random.default_rng(1)
        white = generator.normal(size=2000)
        self.assertGreater(independent_points(white), 1500)
        correlated = numpy.zeros(20000)
        for i in range(1, len(correlated)):
            correlated[i] = 0.8 * correlated[i - 1] + generator.normal()
        self.assertLess(abs(independent_points(correlated) / (20000. * 0.2 / 1.8) - 1.), 0.25)  # (1 - r) / (1 + r)

    def test_scale(self):
        """Of noise that is not known: estimated; of noise that is twice what is said: remarked."""
        generator = numpy.random.default_rng(2)
        residuals = 3. * generator.normal(size=1000)
        self.assertLess(abs(quality(residuals, [400, 600], 2, False).scale / 9. - 1.), 0.25)
        found = quality(residuals, [400, 600], 2, True)
        self.assertIn("larger than the given noise explains", found.remark)
        self.assertGreater(found.scale, 8.)
        good = quality(residuals / 3., [1000], 2, True)
        self.assertEqual((good.scale, good.remark), (1., ""))
        self.assertAlmostEqual(good.threshold, BOUND)
        self.assertIn("no more independent values than parameters", quality(numpy.ones(2), [2], 2, False).remark)

    def test_trend(self):
        """Residuals of 15 standard deviations that are a line: said, and no errors of a good fit."""
        for n_parameters in (2, 3):
            found = quality(numpy.linspace(-15., 15., 180), [180], n_parameters, True)
            self.assertLess(found.independent - n_parameters, 1.)
            self.assertIn("larger than the given noise explains", found.remark)
            self.assertGreaterEqual(found.scale, found.chi_square / found.freedom)

    def test_unknown(self):
        """One residual says nothing of a second coordinate, two that are the same neither."""
        for jacobian in (numpy.array([[50., 10.]]), numpy.array([[50., 10.], [50., 10.]])):
            self.assertGreater(numpy.sqrt(numpy.diag(covariance(jacobian))).min(), 0.1 * UNKNOWN)
            known = numpy.array([50., 10.]) / numpy.linalg.norm(jacobian)
            expected = numpy.outer(known, known) / (known @ known) / numpy.linalg.norm(jacobian) ** 2
            numpy.testing.assert_allclose(covariance_of_known(jacobian), expected)
            self.assertEqual([error == UNKNOWN for _, error, _ in directions(jacobian)], [False, True])

    def test_linear(self):
        """Of a linear model, profiles end where the normal distribution says, at the bounds of a flat direction,
        too."""
        generator = numpy.random.default_rng(4)
        terms = generator.normal(size=(50, 3)) * [1., 3., 0.2]
        y = generator.normal(size=50)
        model = FunctionModel(lambda x: terms @ x - y, [-9.] * 3, [9.] * 3)
        found = minimise(model, numpy.zeros(3), 0.01)
        deviations = numpy.sqrt(numpy.diag(numpy.linalg.inv(terms.T @ terms)))
        numpy.testing.assert_allclose(numpy.sqrt(numpy.diag(covariance(found.jacobian))), deviations, rtol=1e-6)
        for i, (lower, upper) in enumerate(profiles(model, found, BOUND, deviations)):
            self.assertTrue(lower.is_closed and upper.is_closed)
            numpy.testing.assert_allclose([found.x[i] - lower.x[i], upper.x[i] - found.x[i]],
                                          BOUND ** 0.5 * deviations[i], rtol=0.05)
        self.assertEqual(len(directions(found.jacobian)), 3)

    def test_profile(self):
        """The ends are where the sum of squares, least over the other coordinate, is higher by 3.84."""
        model = model_of(5)
        found = minimise(model, START, 0.02)
        best = minimise(model, found.x, 0.005, tolerance=1e-6)
        ends = profiles(model, best, BOUND, numpy.sqrt(numpy.diag(covariance(best.jacobian))))
        for i, pair in enumerate(ends):
            for end in pair:
                def others(value, held=end.x[i], i=i):
                    x = numpy.array([value, value])
                    x[i] = held
                    return (model.residuals(x) ** 2).sum()

                least = optimize.minimize_scalar(others, bounds=(LOWER[1 - i], UPPER[1 - i]), method="bounded",
                                                 options={"xatol": 1e-9}).fun
                self.assertTrue(end.is_closed)
                self.assertLess(abs((least - best.chi_square) / BOUND - 1.), 0.15)

    def test_far_end(self):
        """Nine steps of 0.7 do not come to the end at 98, nor to the bound."""
        model = FunctionModel(lambda x: numpy.array([x[0], 0.02 * x[1]]), [-9.] * 2, [9.] * 2)
        best = minimise(model, numpy.zeros(2), 0.01)
        (lower, upper), far = profiles(model, best, BOUND, numpy.sqrt(numpy.diag(covariance(best.jacobian))))
        self.assertTrue(lower.is_closed and upper.is_closed)
        for end in far:
            self.assertFalse(end.is_closed)
            self.assertIn("farther away than 9 points reach", end.remark)

    def test_unsettled(self):
        """Where the search of the other parameters has not ended, the end of a region is marked, and a repetition does
        not count; a new beginning helps."""
        model = model_of(5)
        best = minimise(model, START, 0.02)
        deviations = numpy.sqrt(numpy.diag(covariance(best.jacobian)))
        repeat = Repetitions(FunctionModel(lambda x: tabor(x) / SIGMA, LOWER, UPPER), TRUTH)
        self.assertIsNotNone(repeat(1))
        with unittest.mock.patch.object(optimisation, "MOST_STEPS", 1):
            ends = [end for pair in profiles(model, best, BOUND, deviations) for end in pair]
            self.assertFalse(any(end.remark for end in ends), [end.remark for end in ends])
        moved = types.SimpleNamespace(converged=False, chi_square=1e9)
        with unittest.mock.patch("tools.verification.fit_coverage.held", lambda *_: moved):
            self.assertIsNone(repeat(1))
        with (unittest.mock.patch.object(optimisation, "MOST_STEPS", 1),
              unittest.mock.patch("elasto_plastic_contact.fitting.profiles.RESTARTS", 0)):
            ends = [end for pair in profiles(model, best, BOUND, deviations) for end in pair]
        self.assertTrue(any("have not come to rest" in end.remark for end in ends))

    def test_better_point(self):
        """Of two minima, a profile from the worse one finds the better one."""
        model = FunctionModel(lambda x: numpy.array([4. * (x[0] ** 2 - 1.), 2. - x[0] - x[1], 3. * x[1]]), [-3., -3.],
                              [3., 3.])
        best = minimise(model, numpy.array([-1., 0.]), 0.001)
        self.assertLess(best.x[0], 0.)
        ends = profiles(model, best, 200., numpy.array([1., 1.]))
        self.assertGreater(better_point(ends, 20.)[0], 0.5)
        good = minimise(model, numpy.array([1., 0.]), 0.001)
        self.assertIsNone(better_point(profiles(model, good, 20., numpy.array([0.1, 0.1])), 20.))

    def test_coverage(self):
        """The true values lie in 95 % of the regions of 300 noises: within three deviations of that frequency."""
        inside = numpy.zeros(2)
        for seed in range(300):
            model = model_of(1000 + seed)
            best = minimise(model, TRUTH, 0.02)
            ends = profiles(model, best, BOUND, numpy.sqrt(numpy.diag(covariance(best.jacobian))))
            inside += [pair[0].x[i] <= TRUTH[i] <= pair[1].x[i] for i, pair in enumerate(ends)]
        for share in inside / 300.:
            self.assertLess(abs(share - 0.95), 3. * (0.95 * 0.05 / 300.) ** 0.5)


class Uniqueness(unittest.TestCase):
    """One number, a flow stress at a known plastic strain, for two parameters."""

    def setUp(self):
        self.parameters = [Parameter("sigma_Y", 300., 100., 2000., True), Parameter("n", 0.1, 0.05, 0.5, False)]
        names = ["sigma_Y", "n", "E"]
        formulas = {path: Formula(text, names, path) for path, text in (
            ("Material/Yield stress", "sigma_Y"), ("Material/Power law exponent", "n"),
            ("Material/Power law reference strain", "sigma_Y / E"))}
        self.problem = Problem("one number", self.parameters, {"E": 200000.},
                               [Experiment("cone", {"fine": types.SimpleNamespace(common={})}, formulas, [])], True)
        base = {"Material/Law": "nonlinear hardening", "Material/Young's modulus": "200000",
                "Material/Isotropic hardening modulus": "0"}
        self.material = Material(self.problem, base)
        self.truth = numpy.array([p.coordinate(v) for p, v in zip(self.parameters, (400., 0.2))])
        self.stress = float(self.material.stress(self.truth, numpy.array([0.033]))[0])

    def test_flat_direction(self):
        model = FunctionModel(lambda x: (self.material.stress(x, numpy.array([0.033])) / self.stress - 1.) / 0.01,
                              *self.problem.bounds())
        best = minimise(model, self.problem.start(), 0.02)
        matrix = covariance(best.jacobian)
        ends = profiles(model, best, BOUND, numpy.sqrt(numpy.diag(matrix)))
        self.assertFalse(all(end.is_closed for pair in ends for end in pair))
        self.assertTrue(any("reaches its bound" in end.remark for pair in ends for end in pair))
        # (what one number does not say: errors of both parameters, one flat direction)
        self.assertGreater(numpy.sqrt(numpy.diag(matrix)).min(), 0.1 * UNKNOWN)
        (known, error, row), (singular, unknown, flat) = directions(best.jacobian)
        self.assertAlmostEqual(error * numpy.linalg.norm(best.jacobian), 1.)
        self.assertEqual((singular, unknown), (0., UNKNOWN))
        self.assertLess(abs(best.jacobian @ flat)[0], 1e-9 * known)
        found = representative(self.material, family(best.x, ends, BOUND), covariance_of_known(best.jacobian), 1.96)
        self.assertLess(abs(found.plastic_strain / 0.033 - 1.), 0.15)
        self.assertLess(abs(found.stress / self.stress - 1.), 0.01)
        self.assertTrue(0.97 < found.lower / self.stress < 1. < found.upper / self.stress < 1.03)
        self.assertLess(found.spread, 0.05)
        self.assertGreater(found.spread_elsewhere, 0.3)


class FailedRuns(unittest.TestCase):
    def test_polish(self):
        model = FunctionModel(lambda x: 1. / 0. * x, [0.], [1.])
        self.assertIsInstance(model.evaluate([numpy.array([0.5])])[0], Failure)
        self.assertIsNone(polish(model, numpy.array([0.5]), numpy.ones((1, 1)), [0]))


if __name__ == "__main__":
    unittest.main()
