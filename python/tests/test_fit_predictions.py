# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What fits look up in runs: curves with and without holds, quantities, imprints, columns."""

import types
import unittest

import numpy

from elasto_plastic_contact import UserError
from elasto_plastic_contact.fitting.predictions import (FITTED_SLOPES, QUANTITIES, Curve, column_at, curve_at, hold_at,
                                                          imprint_at)


def run_of(depth, force, **tables):
    """What stands for the Results of a run."""
    history = numpy.array(list(zip(depth, force)), [("depth", float), ("force", float)])
    return types.SimpleNamespace(history=history, number=lambda path: 0., modelled_part=1., table=tables.get)


class Predictions(unittest.TestCase):
    """A cone, force 100 depth^2 to the depth 2 in 40 steps, and an unloading by (depth - 1.5)^1.4 in ten."""
    LOAD, UNLOAD = numpy.arange(1, 41) / 20., 2. - numpy.arange(1, 11) / 20.
    RUN = run_of(numpy.append(LOAD, UNLOAD), numpy.append(100. * LOAD ** 2, 400. * ((UNLOAD - 1.5) / 0.5) ** 1.4))

    def test_curves(self):
        places = numpy.linspace(0.2, 2., 77)
        numpy.testing.assert_allclose(curve_at(self.RUN, "load", "force", places), 100. * places ** 2, rtol=2e-3)
        numpy.testing.assert_allclose(curve_at(self.RUN, "load", "depth", 100. * places ** 2), places, rtol=2e-3)
        places = numpy.linspace(1.6, 2., 33)
        numpy.testing.assert_allclose(curve_at(self.RUN, "unload", "force", places),
                                      400. * ((places - 1.5) / 0.5) ** 1.4, rtol=5e-3)
        self.assertLess(curve_at(self.RUN, "unload", "force", numpy.array([1.4]))[0], 0.)  # goes on

    def test_holds(self):
        """A hold of force, in which the depth creeps, or of depth, in which the force relaxes: then it unloads."""
        depth, force = self.RUN.history["depth"], self.RUN.history["force"]
        for creep, relaxed in ((0.1, 0.), (0., 50.)):
            held = numpy.linspace(0., 1., 6)[1:]
            unload = numpy.arange(40, 50)
            run = run_of([*depth[:40], *(2. + creep * held), *(depth[unload] + creep)],
                         [*force[:40], *(400. - relaxed * held), *(force[unload] * (1. - relaxed / 400.))])
            curve = Curve(run)
            numpy.testing.assert_allclose(curve.load[-1], [2., 400.])
            numpy.testing.assert_allclose(curve.unload[0], [2. + creep, 400. - relaxed])
            self.assertEqual(len(curve.unload), 11)

    def test_creep(self):
        """The depth over the time since the force is held, up to the end of the run or to its unloading."""
        time = numpy.arange(1., 31.)
        force, depth = numpy.minimum(time, 10.), numpy.where(time < 10., 0.1 * time, 1. + 0.01 * (time - 10.))
        places = numpy.array([0., 2.5, 20.])
        for unload in ([], [8., 4., 0.]):
            rows = (numpy.append(time, 31. + numpy.arange(len(unload))), numpy.append(depth, 0.1 * numpy.array(unload)),
                    numpy.append(force, unload))
            history = numpy.array(list(zip(*rows)), [(name, float) for name in ("time", "depth", "force")])
            run = types.SimpleNamespace(history=history, number=lambda path: 0.1)
            numpy.testing.assert_allclose(hold_at(run, places), 0.9 + 0.01 * places)
        self.refuse("the measured hold lasts 22 .*and that of the run only 20: hold longer", hold_at, run,
                    numpy.array([22.]))
        run.history = history[:11]
        self.refuse("the run has no hold of two steps or more at its largest force", hold_at, run, places)

    def test_quantities(self):
        values = {name: QUANTITIES[name][0](self.RUN) for name in QUANTITIES if "hardness" not in name}
        for name, value in (("loading curvature", 100.), ("unloading slope", 400. * 1.4 / 0.5),
                            ("unloading slope over depth", 200. * 1.4 / 0.5), ("largest force", 400.),
                            ("largest depth", 2.), ("residual depth", 1.5),
                            ("plastic work share", 1. - (400. * 0.5 / 2.4) / (100. * 8. / 3.))):
            self.assertLess(abs(values[name] / value - 1.), 5e-3, name)

    def test_fitted_slopes(self):
        """The unloading is a power law throughout, so that any shares give its slope."""
        for shares in ([0.5, 0.95], [0.2, 1.]):
            slope = FITTED_SLOPES["unloading slope"](self.RUN, shares)
            self.assertAlmostEqual(slope / (400. * 1.4 / 0.5), 1., delta=1e-6)
            self.assertAlmostEqual(FITTED_SLOPES["unloading slope over depth"](self.RUN, shares), 0.5 * slope)
        few = run_of([1., 2., 1.7, 1.5], [1., 4., 2., 0.])
        self.refuse("fewer than three points between 50 and 95 % of the largest force, which 'fit' takes",
                    FITTED_SLOPES["unloading slope"], few, [0.5, 0.95])

    def test_imprint(self):
        profile = numpy.array([(1, 0., 0., 0., -9.), (2, 0., 0., 0., -0.5), (2, 1., 0., 0.1, -0.2),
                               (2, 2., 0., 0., 0.)],
                              [(name, float) for name in ("step", "x", "height", "displacement_x", "displacement_y")])
        run = run_of([1.], [1.], surface_profile=profile)
        numpy.testing.assert_allclose(imprint_at(run, numpy.array([0., 1.1, 2.])), [-0.5, -0.2, 0.], atol=1e-12)

    def refuse(self, message, function, *arguments):
        with self.assertRaisesRegex(UserError, message):
            function(*arguments)

    def test_messages(self):
        self.refuse("the measured curve reaches the depth 3 .*and the run only 2: press further", curve_at, self.RUN,
                    "load",
                    "force", numpy.array([3.]))
        loaded = run_of(self.LOAD, self.LOAD ** 2)
        self.refuse("the run has no unloading of two steps or more", curve_at, loaded, "unload", "force", self.LOAD)
        few = run_of([1., 2., 1.7, 1.5], [1., 4., 2., 0.])
        self.refuse("fewer than three points above 70 % of the largest force", QUANTITIES["unloading slope"][0], few)
        table = numpy.array([(0., 1.), (1., 2.), (0.5, 3.)], [("x", float), ("y", float)])
        self.refuse("column 'x' of some.csv of the run turns back", column_at, run_of([1.], [1.], some=table), "some",
                    "x",
                    "y", numpy.array([0.5]))


if __name__ == "__main__":
    unittest.main()
