# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What follows of measured curves: segments, drift, tips, a known material, scatter."""

import argparse
import math
import re
import unittest

import numpy

from elasto_plastic_contact.measured import MeasuredCurve
from elasto_plastic_contact.measured.arguments import zero_point
from elasto_plastic_contact.measured.corrections import drift_in_hold, from_zero_point
from elasto_plastic_contact.measured.creep import integral
from elasto_plastic_contact.measured.curve import Notes
from elasto_plastic_contact.measured.evaluation import Constants, evaluate_indent, statistics
from elasto_plastic_contact.measured.segments import find_segments
from elasto_plastic_contact.measured.tips import tip_of_instrument
from elasto_plastic_contact.oliver_pharr import Tip

# A material and a tip: modulus and hardness in GPa, the sharp Berkovich pyramid as 24.5 h^2.
REDUCED, HARDNESS, SHARP, EXPONENT = 70., 8., 24.5, 1.5


def cycle(force, begin=0.):
    """Depths in µm and forces in mN of a load from 'begin' (a force) to a force and of its unloading to 10 % of it, of
    the material above."""
    contact_depth = math.sqrt(force / HARDNESS / SHARP)
    stiffness = 2. * REDUCED * math.sqrt(force / HARDNESS / math.pi)
    depth = contact_depth + 0.75 * force / stiffness
    final = depth - EXPONENT * force / stiffness
    up, down = numpy.linspace(begin, force, 200), numpy.linspace(force, 0.1 * force, 200)
    return (depth * numpy.sqrt(up / force), up), (final + (depth - final) * (down / force) ** (1. / EXPONENT), down)


def indent(forces=(10.,), hold=0., drift=0., **others):
    """Cycles up to these forces in 10 s each, with holds at the largest force and, at the end, at the lowest one; the
    depth grows by the drift, in µm/s."""
    depths, loads, begin = [], [], 0.
    for force in forces:
        (depth, up), (back, down) = cycle(force, begin)
        n_held = int(hold * 20)
        depths += [depth, numpy.full(n_held, depth[-1]), back]
        loads += [up, numpy.full(n_held, force), down]
        begin = 0.1 * force
    depths.append(numpy.full(int(hold * 20), depths[-1][-1]))
    loads.append(numpy.full(int(hold * 20), loads[-1][-1]))
    depth, force = numpy.concatenate(depths), numpy.concatenate(loads)
    time = 0.05 * numpy.arange(len(depth))
    return MeasuredCurve("1", depth + drift * time, force, time, **others)


def evaluated(curve, **constants):
    segments, cycles = find_segments(curve)
    return evaluate_indent(curve, segments, cycles,
                           Constants(**{"tip": Tip.polynomial([SHARP]), "epsilon": 0.75} | constants))


def creeping(sensitivity, reduced, force=10., rate=0.02, duration=60.):
    """A load in 10 s, a hold in which the hardness is HARDNESS (r / rate)^sensitivity at the rate r = (dh/dt) / h, and
    the unloading, of a material with this reduced modulus in GPa."""
    first = math.sqrt(force / HARDNESS / SHARP)
    contact = numpy.linspace(first, 2. * first, 4000)
    stiffness = 2. * reduced * contact * math.sqrt(SHARP / math.pi)
    depth = contact + 0.75 * force / stiffness
    rates = rate * (contact / first) ** (-2. / sensitivity)
    spent = integral(1. / (depth * rates), depth)
    held = numpy.linspace(0., duration, int(20 * duration))
    creep = numpy.interp(held, spent, depth)
    end_stiffness = numpy.interp(creep[-1], depth, stiffness)
    up, down = numpy.linspace(0., force, 200), numpy.linspace(force, 0.1 * force, 200)
    final = creep[-1] - EXPONENT * force / end_stiffness
    depths = [depth[0] * numpy.sqrt(up / force), creep[1:],
              final + (creep[-1] - final) * (down[1:] / force) ** (1. / EXPONENT)]
    times = [10. * up / force, 10. + held[1:], 10. + duration + 10. * (1. - down[1:] / force)]
    forces = [up, numpy.full(len(held) - 1, force), down[1:]]
    return MeasuredCurve("1", *map(numpy.concatenate, (depths, forces, times)))


class Evaluation(unittest.TestCase):
    def test_segments(self):
        for forces in ((10.,), (10., 20., 40.)):
            segments, cycles = find_segments(indent(forces))
            self.assertEqual([segment.kind for segment in segments], ["load", "unload"] * len(forces))
            self.assertEqual([cycle.hold for cycle in cycles], [None] * len(forces))
        curve = indent((10., 20.), hold=5.)
        segments, cycles = find_segments(curve)
        self.assertEqual([segment.kind for segment in segments],
                         ["load", "hold", "unload", "load", "hold", "unload", "hold"])
        for cycle_found in cycles:
            held = curve.time[cycle_found.hold.end] - curve.time[cycle_found.hold.begin]
            self.assertAlmostEqual(held, 5., delta=0.3)
        noisy = indent((10.,), hold=5.)
        noise = numpy.random.default_rng(1).normal(size=(2, len(noisy.depth)))
        noisy = MeasuredCurve("1", noisy.depth + 1e-4 * noise[0], noisy.force + 0.01 * noise[1], noisy.time)
        segments, _ = find_segments(noisy)
        self.assertEqual([segment.kind for segment in segments], ["load", "hold", "unload", "hold"])

    def test_load_that_begins_slowly(self):
        time = numpy.linspace(0., 1., 500)
        for exponent in (1., 2., 3.):
            force = 10. * numpy.append(time ** exponent, (1. - time[1:]) ** exponent)
            segments, _ = find_segments(MeasuredCurve("1", numpy.append(time, 1. - 0.1 * time[1:]), force))
            self.assertEqual([segment.kind for segment in segments], ["load", "unload"])

    def test_hold_on_the_way(self):
        force = numpy.concatenate([numpy.linspace(0., 10., 200), numpy.linspace(10., 1., 200), numpy.full(300, 1.),
                                   numpy.linspace(1., 0., 30)])
        curve = MeasuredCurve("1", numpy.sqrt(force), force, 0.05 * numpy.arange(len(force)))
        segments, cycles = find_segments(curve)
        self.assertEqual([segment.kind for segment in segments], ["load", "unload", "hold", "unload"])
        self.assertEqual(len(cycles), 1)

    def test_known_material(self):
        found, = evaluated(indent(hold=5.), indenter=(1141., 0.07), poissons_ratio=0.2).unloadings
        self.assertAlmostEqual(found["tip_hardness"] / HARDNESS, 1., places=4)
        self.assertAlmostEqual(found["tip_reduced_modulus"] / REDUCED, 1., places=4)
        plane = 1. / (1. / REDUCED - (1. - 0.07 ** 2) / 1141.)
        self.assertAlmostEqual(found["plane_strain_modulus"] / plane, 1., places=4)
        self.assertAlmostEqual(found["youngs_modulus"] / plane, 0.96, places=4)
        self.assertAlmostEqual(found["exponent"], EXPONENT, places=4)
        self.assertAlmostEqual(found["loading_curvature"] / (10. / found["max_depth"] ** 2), 1., places=6)
        self.assertAlmostEqual(found["loading_exponent"], 2., places=6)
        self.assertAlmostEqual(found["total_work"] / (10. * found["max_depth"] / 3.), 1., delta=1e-3)
        elastic = 10. * (found["max_depth"] - found["final_depth"]) / (EXPONENT + 1.)
        self.assertAlmostEqual((found["total_work"] - found["plastic_work"]) / elastic, 1., delta=1e-3)
        self.assertAlmostEqual(found["creep_depth"], 0.)

    def test_cycles(self):
        """Works of later cycles are those of one load, as their reloads follow the unloadings."""
        for found in evaluated(indent((10., 20., 40.))).unloadings:
            self.assertAlmostEqual(found["tip_hardness"] / HARDNESS, 1., places=3)
            self.assertAlmostEqual(found["tip_reduced_modulus"] / REDUCED, 1., places=3)

    def test_creep(self):
        found, = evaluated(indent(hold=10., drift=2e-3)).unloadings
        self.assertAlmostEqual(found["creep_rate"], 2., places=3)
        self.assertAlmostEqual(found["creep_depth"], 20., delta=0.5)

    def test_rate_sensitivity_of_holds(self):
        """Also where a third of the depth is elastic, so that the section grows faster than the square of the depth."""
        for sensitivity, reduced in ((0.2, 1e3), (0.02, 1e3), (0.2, 50.), (0.02, 50.)):
            found, = evaluated(creeping(sensitivity, reduced)).unloadings
            self.assertAlmostEqual(found["tip_reduced_modulus"] / reduced, 1., delta=1e-3)
            self.assertAlmostEqual(found["hold_rate_sensitivity"] / sensitivity, 1., delta=0.01)

    def test_force_that_scatters(self):
        """Makes no segments of its own: one load and one unload, as without the noise."""
        curve = indent()
        noise = curve.force.max() * numpy.random.default_rng(5).normal(size=len(curve.force))
        for share in (0.003, 0.01, 0.03):
            segments, cycles = find_segments(MeasuredCurve("1", curve.depth, curve.force + share * noise))
            self.assertEqual([segment.kind for segment in segments], ["load", "unload"])
            self.assertEqual(len(cycles), 1)

    def test_rate_sensitivity_with_noise(self):
        """A line through noisy rates would have a much smaller slope."""
        curve = creeping(0.02, 70.)
        noise = 3e-4 * numpy.random.default_rng(3).normal(size=len(curve.depth))
        found, = evaluated(MeasuredCurve("1", curve.depth + noise, curve.force, curve.time)).unloadings
        self.assertAlmostEqual(found["hold_rate_sensitivity"] / 0.02, 1., delta=0.05)

    def test_rate_sensitivity_of_a_hold_at_the_end(self):
        """A sharp pyramid into a body without elasticity: h = h_0 (1 + t / tau)^(m / 2)."""
        time, sensitivity = numpy.linspace(0., 60., 900), 0.1
        depth = (1. + time[1:] / 2.) ** (0.5 * sensitivity)
        up = numpy.linspace(0., 10., 100)
        curve = MeasuredCurve("1", numpy.append(numpy.sqrt(0.1 * up), depth), numpy.append(up, numpy.full(899, 10.)),
                              numpy.append(up, 10. + time[1:]))
        found = evaluated(curve)
        self.assertEqual(found.unloadings, [])
        self.assertAlmostEqual(found.last_hold["hold_rate_sensitivity"], sensitivity, places=4)
        self.assertRegex(found.remarks[0],
                         "hold at the end: its rate sensitivity is that of the section of the tip at the depth itself")
        self.assertNotIn("hold_rate_sensitivity", evaluated(curve, tip=None).last_hold)

    def test_holds_without_a_rate_sensitivity(self):
        """Of a depth that stays, grows steadily (a drift), or falls."""
        for drift in (0., 2e-3, -1e-4):
            found = evaluated(indent(hold=10., drift=drift))
            self.assertNotIn("hold_rate_sensitivity", found.unloadings[0])
            self.assertRegex(found.remarks[0],
                             "unloading 1: the depth in its hold does not grow slower and slower so that a "
                             "rate sensitivity would stand out from noise and drift")

    def test_drift_in_hold(self):
        curve = indent(hold=10., drift=2e-4)
        rate, source = drift_in_hold(curve, find_segments(curve)[0])
        self.assertAlmostEqual(rate, 2e-4)
        self.assertIn("hold at 1 mN", source)

    def test_continuous_stiffness(self):
        (depth, force), _ = cycle(10.)
        depth, force = depth[1:], force[1:]
        stiffness = 2. * REDUCED * numpy.sqrt(force / HARDNESS / math.pi)
        curve = MeasuredCurve("1", depth, force, None, stiffness)
        found = evaluated(curve).continuous
        numpy.testing.assert_allclose(found["tip_hardness"], HARDNESS, rtol=1e-6)
        numpy.testing.assert_allclose(found["tip_reduced_modulus"], REDUCED, rtol=1e-6)

    def test_tip_of_instrument(self):
        curve = indent(notes=Notes(hardness=HARDNESS))
        tip, sentence = tip_of_instrument([curve], [find_segments(curve)[1]], 0.75)
        self.assertAlmostEqual(tip.area(1.), SHARP, places=2)
        self.assertIn("of 1 indent", sentence)
        tip, _ = tip_of_instrument([indent(notes=Notes(area_function=(24., 2.)))], [[]], 0.75)
        self.assertAlmostEqual(tip.area(2.), 100.)
        self.assertIsNone(tip_of_instrument([indent()], [[]], 0.75))

    def test_statistics(self):
        found = statistics([{"stiffness": 1.}, {"stiffness": 3.}, {"exponent": 2.}])
        self.assertEqual(found["stiffness"], {"mean": 2., "deviation": math.sqrt(2.), "number": 2})
        self.assertEqual(found["exponent"], {"mean": 2., "deviation": None, "number": 1})

    def test_zero_point_by_parts_of_the_loading(self):
        """Where one power holds, all parts begin at the same depth; where it changes, they do not, as the sentence says."""
        force = numpy.linspace(0., 10., 400)
        for depth, spread in ((numpy.sqrt(force), 0.), (force ** (2. / 3.) + 0.3 * force, 27.8)):
            _, sentence = from_zero_point(MeasuredCurve("1", depth + 0.005, force), "fit", 0.01)
            found = re.search("zero point: (.*) nm, where .*; by its first 20 % of the largest force, (.*) nm; "
                              "by its first 10 % of the largest force, (.*) nm", sentence)
            self.assertAlmostEqual(numpy.ptp([float(number) for number in found.groups()]), spread, delta=0.1)

    def test_zero_point_with_unit(self):
        self.assertEqual(zero_point("5 nm").value, 0.005)
        self.assertEqual((zero_point("fit"), zero_point("5")), ("fit", 5.))
        for text in ("five", "3 mN"):
            with self.assertRaisesRegex(argparse.ArgumentTypeError,
                                        f"it is '{text}', but must be a depth, such as '5 nm', .* or 'fit'"):
                zero_point(text)


if __name__ == "__main__":
    unittest.main()
