# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What problems of fits are refused, and with which words; data of all kinds."""

import copy
import json
import pathlib
import tempfile
import unittest

import numpy

from elasto_plastic_contact import UserError
from elasto_plastic_contact.__main__ import main
from elasto_plastic_contact.fitting.command import find_problem
from elasto_plastic_contact.fitting.reading import read_problem
from elasto_plastic_contact.program import ROOT

CURVE = "Depth (µm),Force (N)\n" + "".join(f"{h},{h * h}\n" for h in range(1, 51)) + "".join(
    f"{50 - 0.1 * k},{2500 - 120 * k}\n" for k in range(1, 20))
PROBLEM = {
    "parameters": {"sigma_Y": {"start": 400, "lower": 100, "upper": 1000},
                   "n": {"start": 0.1, "lower": 0, "upper": 0.5}},
    "constants": {"E": 200000},
    "entries": {"Material/Yield stress": "sigma_Y", "Material/Power law exponent": "n",
                "Material/Power law reference strain": "sigma_Y / E"},
    "experiments": {"cone": {
        "case": "indentation/cone_finite_strain.prm", "units": {"length": "mm", "force": "N"}, "load to": "depth",
        "coarse": {"Geometry/Initial refinements": 3},
        "data": [{"curve": "curve.csv", "noise": {"relative": 0.01, "of largest": 0.001}}]}},
    "candidates": {"hardness": {"case": "indentation/sphere_finite_strain.prm",
                                "data": {"quantity": "hardness", "noise": {"relative": 0.02}}}}}
CONE, DATA = "experiments/cone", "experiments/cone/data/0"


class Problems(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "curve.csv").write_text(CURVE)
        (self.folder / "imprint.csv").write_text("x,height\n" + "".join(f"{x},{-x}\n" for x in range(5)))

    def read(self, problem):
        path = self.folder / "problem.json"
        path.write_text(problem if isinstance(problem, str) else json.dumps(problem))
        return read_problem(path)

    def changed(self, place, value):
        """The problem with another value at 'key/key/...', or without it (None)."""
        problem = copy.deepcopy(PROBLEM)
        *keys, last = [int(key) if key.isdigit() else key for key in place.split("/")] if place else [None]
        at = problem
        for key in keys:
            at = at[key]
        if value is None:
            del at[last]
        else:
            at[last] = value
        return problem

    def refuse(self, message, place, value):
        with self.assertRaisesRegex(UserError, message):
            self.read(self.changed(place, value))

    def block(self, data):
        problem = self.changed(DATA, data)
        problem["experiments"]["cone"].pop("load to")
        return self.read(problem).experiments[0].blocks

    def refuse_data(self, message, **data):
        with self.assertRaisesRegex(UserError, message):
            self.block(data)

    def test_good_one(self):
        problem = self.read(PROBLEM)
        experiment, = problem.experiments
        self.assertEqual([block.kind for block in experiment.blocks], ["load", "unload"])
        self.assertEqual(experiment.cases["coarse"].common["Geometry/Initial refinements"], 3)
        self.assertEqual(experiment.cases["fine"].common["Loading/History"], "1: depth 0.05 | 1.2: force 0")
        load = experiment.blocks[0]
        self.assertAlmostEqual(load.x[-1], 0.05)  # mm
        numpy.testing.assert_allclose(load.sigma, numpy.hypot(0.01 * load.y, 0.001 * 2500.))
        self.assertEqual(experiment.entries({"sigma_Y": 400., "n": 0.2, "E": 200000.}),
                         {"Material/Yield stress": 400., "Material/Power law exponent": 0.2,
                          "Material/Power law reference strain": 0.002})
        self.assertTrue(problem.noise_is_known)
        self.assertEqual(len(problem.candidates), 1)

    def history(self, case, quantity, entries):
        """Of the experiment with another case and further entries, on the fine and on the coarse mesh."""
        problem = self.changed(f"{CONE}/case", case)
        problem["experiments"]["cone"] |= {"load to": quantity, "set": entries}
        cases = self.read(problem).experiments[0].cases
        return [cases[stage].common["Loading/History"] for stage in ("fine", "coarse")]

    def test_load_to(self):
        """Forces of the history are those on the modelled part, depths begin where the indenter is at first, also where
        an included file says so."""
        cone, sector = "indentation/cone_finite_strain.prm", "indentation/berkovich_sector.prm"
        self.assertEqual(self.history(cone, "force", {}), ["1: force 2500.0 | 1.2: force 0"] * 2)
        sixth, _ = self.history(sector, "force", {})
        self.assertAlmostEqual(float(sixth.split()[2]), 2500. / 6.)
        (self.folder / "with_gap.prm").write_text("subsection Indenter\n  include gap.txt\nend\n")
        (self.folder / "gap.txt").write_text("set Initial gap = \\\n  0.03  # mm\n")
        self.assertEqual(self.history("with_gap.prm", "depth", {}), ["1: depth 0.08 | 1.2: force 0"] * 2)
        self.assertEqual(self.history(cone, "depth", {"Indenter/Initial gap": 0.02})[0],
                         "1: depth 0.07 | 1.2: force 0")
        for message, *changes in (
                ("is not known before the run unless the body is axisymmetric or a sector",
                 "indentation/berkovich_finite_strain.prm", "force", {}),
                ("is not known before the run", sector, "force", {"Indenter/Position": "0.1, 0"}),
                ("is not known before the run", sector, "force", {"Geometry/Sector angle": "wide"}),
                ("does not know how fast the measurement was, and 'Material/Rate law' is 'Norton'", cone, "depth",
                 {"Material/Rate law": "Norton"}),
                ("'Indenter/Initial gap' of 'experiments/cone' is 'wide', but must be a number", cone, "depth",
                 {"Indenter/Initial gap": "wide"})):
            with self.subTest(message), self.assertRaisesRegex(UserError, message):
                self.history(*changes)
        problem = copy.deepcopy(PROBLEM)
        problem["entries"]["Indenter/Initial gap"] = "0.01 * n"
        with self.assertRaisesRegex(UserError, "load to' is 'depth', and 'entries' change 'Indenter/Initial gap'"):
            self.read(problem)

    def test_included(self):
        """Files that include others are followed, and not for ever."""
        for text, message in (("include problem.prm", "'.*problem.prm' is included while it is being read"),
                              ("include nowhere.prm", "'.*nowhere.prm' cannot be read"),
                              ("set Dimension", "'.*problem.prm' is damaged in line 1")):
            (self.folder / "problem.prm").write_text(text)
            self.refuse(message, f"{CONE}/case", "problem.prm")

    def test_ready_problems(self):
        """By their names, if there is no file of that name."""
        path = self.folder / "sphere.json"
        for name in ("sphere", "sphere.json"):
            self.assertEqual(find_problem(pathlib.Path(name)), ROOT / "parameter_files/fit/sphere.json")
        self.assertEqual(find_problem(path), path)
        self.assertEqual(find_problem(pathlib.Path("nothing.json")), pathlib.Path("nothing.json"))

    def test_file(self):
        for text, message in (("{", "this is no JSON"), ("[]", "the problem is \\[\\], but must be an object"),
                              ('{"parameters": 1, "parameters": 2}', "stands twice")):
            with self.assertRaisesRegex(UserError, message):
                self.read(text)
        self.assertEqual(main(["fit", str(self.folder / "nothing.json")]), 2)

    def test_parameters(self):
        self.refuse("a key of the problem: there is no \"experiment\". Did you mean 'experiments'", "experiment", {})
        self.refuse("the problem lacks 'entries'", "entries", None)
        self.refuse("'parameters' is {}, but must be an object", "parameters", {})
        self.refuse("'parameters/2n': a name in formulas is letters", "parameters/2n", {})
        self.refuse("'parameters/n' lacks 'upper'", "parameters/n/upper", None)
        self.refuse("'parameters/n/start' is '1', but must be a number", "parameters/n/start", "1")
        self.refuse("start 2, lower 0 and upper 0.5, but must have lower < upper and the start between",
                    "parameters/n/start", 2)
        self.refuse("parameters/n/scale: there is no \"cubic\"", "parameters/n/scale", "cubic")
        self.refuse("has a scale 'log' and the lower bound 0, which must be above 0", "parameters/n/scale", "log")
        self.refuse("'parameters/E' is a constant, too", "parameters/E", {"start": 1, "lower": 1, "upper": 2})
        self.refuse("'parameters/Q' stands in none of the formulas", "parameters/Q",
                    {"start": 1, "lower": 1, "upper": 2})
        self.refuse("'constants' must be an object", "constants", 3)
        self.refuse("'constants/E' is 'x', but must be a number", "constants/E", "x")
        self.refuse("'the problem/step' is 0, but must be a number > 0 and <= 0.5", "step", 0)
        self.refuse("'at once' is 0, but must be an integer >= 1", "at once", 0)

    def test_entries(self):
        problem = copy.deepcopy(PROBLEM)
        problem["entries"]["Material/Yield"] = "n"
        with self.assertRaisesRegex(UserError, "entries: there is no entry 'Material/Yield'. Did you mean"):
            self.read(problem)
        problem = copy.deepcopy(PROBLEM)
        problem["entries"]["Material/Voce rate"] = True
        with self.assertRaisesRegex(UserError, "'entries/Material/Voce rate' is True, but must be a formula"):
            self.read(problem)
        self.refuse("'experiments/cone/set' sets 'Material/Yield stress', which 'entries' do", f"{CONE}/set",
                    {"Material/Yield stress": 3})
        self.refuse("there is no parameter file 'nowhere'", f"{CONE}/case", "nowhere")

    def test_experiments(self):
        self.refuse("'experiments/cone/data' is empty", f"{CONE}/data", [])
        self.refuse("'experiments/cone/units/length' is 'foot', but must be one of pm", f"{CONE}/units",
                    {"length": "foot"})
        self.refuse("'experiments/cone/units/length' is 'mm', and the case says 'Output/Length unit = µm': leave one of "
                    "them out", f"{CONE}/set", {"Output/Length unit": "µm", "Output/Force unit": "N"})
        self.read(self.changed(f"{CONE}/set", {"Output/Length unit": "mm", "Output/Force unit": "N"}))
        self.refuse("does not say the units of its case, and its data have some", f"{CONE}/units", None)
        self.refuse("experiments/cone/load to: there is no \"time\"", f"{CONE}/load to", "time")
        self.refuse("'experiments/cone/load to' takes a curve, and there is none", DATA,
                    {"quantity": "hardness", "value": 3, "noise": {"relative": 0.1}})
        self.refuse("some data have a 'noise', and some of 'experiments/cone/data' have none", f"{CONE}/data",
                    [{"curve": "curve.csv"}, {"quantity": "hardness", "value": 3, "noise": {"relative": 0.1}}])

    def test_curves(self):
        noise = {"relative": 0.01}
        self.refuse_data("must be an object with one of the keys curve, imprint, table, quantity", noise=noise)
        self.refuse_data("a key of 'experiments/cone/data/1': there is no \"noize\"", curve="curve.csv", noize=1)
        self.refuse_data("nowhere.csv", curve="nowhere.csv")
        self.refuse_data("indents' is \\[2\\], but must be a list of numbers from 1 to 1", curve="curve.csv",
                         indents=[2])
        self.refuse_data("cycle' is 2, but must be an integer >= 1 and <= 1", curve="curve.csv", cycle=2)
        self.refuse_data("compare: there is no \"time\"", curve="curve.csv", compare="time")
        self.refuse_data("segments: there is no \"held\"", curve="curve.csv", segments=["held"])
        self.refuse_data("segments' is 3, but must be a text or a list of texts", curve="curve.csv", segments=3)
        self.refuse_data("zero point': it is '5', but must be a number with a unit", curve="curve.csv",
                         **{"zero point": 5})
        self.refuse_data("above' is 2, but must be a number >= 0 and < 1", curve="curve.csv", above=2)
        self.refuse_data("fewer than 3 points above", curve="curve.csv", above=0.999)
        self.refuse_data("points' is 1, but must be an integer >= 3", curve="curve.csv", points=1)
        self.refuse_data("noise' is 3, but must be an object", curve="curve.csv", noise=3)
        self.refuse_data("without 'weight'", curve="curve.csv", noise=noise, weight=2)
        self.refuse_data("noise/relative' is -1, but must be a number >= 0", curve="curve.csv", noise={"relative": -1})
        self.refuse_data("noise' is zero for some values", curve="curve.csv", noise={"relative": 0})
        (self.folder / "load.csv").write_text("\n".join(CURVE.splitlines()[:40]))
        self.refuse_data("has no unloading; leave 'unload' out", curve="load.csv", segments=["load", "unload"])

    def test_curve_that_does_not_begin_at_the_contact(self):
        """Is refused unless the problem says its zero point."""
        rows = numpy.loadtxt(self.folder / "curve.csv", delimiter=",", skiprows=1) + [20., 0.]
        numpy.savetxt(self.folder / "shifted.csv", rows, delimiter=",", header="Depth (µm),Force (N)", comments="",
                      encoding="utf-8")
        self.refuse_data("is not counted from the first contact: .* begins at 2e.04 nm, .* in the problem of a fit by "
                         "\"zero point\"", curve="shifted.csv")
        fitted = "'shifted.csv': zero point: 2e.04 nm, .* Errors and regions take it for exact"
        for zero, remarks in (("20 µm", []), ("0 nm", []), ("fit", [fitted])):
            found = self.read(self.changed(DATA, {"curve": "shifted.csv", "zero point": zero})).remarks()
            self.assertEqual(len(found), len(remarks))
            for remark, pattern in zip(found, remarks):
                self.assertRegex(remark, pattern)

    def test_holds(self):
        """Depths over the time since the hold began, in units of the case, also of a load that is not unloaded."""
        force = numpy.concatenate([numpy.linspace(0., 5., 51), numpy.full(60, 5.), numpy.linspace(4.9, 0., 50)])
        depth = numpy.concatenate([numpy.sqrt(force[:51]), 5. ** 0.5 + 0.01 * numpy.arange(1, 61) ** 0.5,
                                   2.3 - 0.1 * (5. - force[111:])])
        rows = [f"{time},{h},{f}" for time, (h, f) in enumerate(zip(depth, force))]
        for name, used in (("held.csv", rows), ("end.csv", rows[:111]), ("loaded.csv", rows[:51])):
            (self.folder / name).write_text("\n".join(["Time (s),Depth (µm),Force (N)", *used]))
        data = {"curve": "held.csv", "segments": "hold", "noise": {"absolute": 0.02}}
        problem = self.changed(DATA, data)
        del problem["experiments"]["cone"]["load to"]
        problem["experiments"]["cone"]["units"]["time"] = "min"
        for item in (data, data | {"curve": "end.csv", "segments": ["hold"]}):
            problem["experiments"]["cone"]["data"] = [item]
            hold, = self.read(problem).experiments[0].blocks
            self.assertEqual((hold.kind, hold.labels), ("hold", ("time", "depth")))
            numpy.testing.assert_allclose(hold.x, numpy.arange(61.)[:len(hold.x)] / 60., atol=1e-12)
            self.assertGreaterEqual(len(hold.x), 60)
            numpy.testing.assert_allclose(hold.y[1:], 1e-3 * depth[51:51 + len(hold.x) - 1])
            numpy.testing.assert_allclose(hold.sigma, 2e-5)
        self.assertEqual([block.kind for block in self.block({"curve": "held.csv"})], ["load", "unload"])
        for message, changes in (("has no time, which its hold takes", {"curve": "curve.csv"}),
                                 ("has no hold at its largest force", {"curve": "loaded.csv"}),
                                 ("give it an item of 'data' of its own", {"segments": ["load", "hold"]}),
                                 ("leave out 'compare' and 'above'", {"compare": "force"}),
                                 ("leave out 'compare' and 'above'", {"above": 0.1})):
            self.refuse_data(message, **data | changes)

    def test_top(self):
        """With a force that is largest before the deepest point, or behind it, this is where the loading ends."""
        rows = CURVE.splitlines()
        for number in (48, 51):
            (self.folder / "noisy.csv").write_text("\n".join(row.partition(",")[0] + ",2510" if i == number else row
                                                             for i, row in enumerate(rows)))
            load, unload = self.block({"curve": "noisy.csv", "noise": {"absolute": 2.}})
            self.assertEqual(load.x.max(), 0.05)
            self.assertEqual(unload.x.max(), 0.05)
            self.assertTrue((numpy.diff(load.x) > 0.).all() and (numpy.diff(unload.x) < 0.).all())

    def test_curves_of_points(self):
        """Means of several points have less noise, points that are not independent more; depths over forces."""
        load, _ = self.block({"curve": "curve.csv", "noise": {"absolute": 2.}, "points": 10, "above": 0.01})
        self.assertEqual(len(load.y), 10)
        self.assertAlmostEqual(load.sigma[-1], 2. / 2., places=6)  # four or five points
        same, _ = self.block({"curve": "curve.csv", "noise": {"absolute": 2.}, "independent points": 10, "above": 0.})
        self.assertAlmostEqual(same.sigma[0], 2. * (len(same.y) / 10.) ** 0.5)
        depths, = self.block({"curve": "curve.csv", "noise": {"relative": 0.01}, "compare": "depth",
                              "segments": "load"})
        numpy.testing.assert_allclose(depths.y, (depths.x ** 0.5) * 1e-3, rtol=1e-9)
        weighted, _ = self.block({"curve": "curve.csv", "weight": 4})
        self.assertAlmostEqual(weighted.sigma[0], 0.005 * 2500.)

    def test_imprints_and_tables(self):
        imprint, = self.block({"imprint": "imprint.csv", "unit": "µm", "noise": {"absolute": 1e-4}})
        numpy.testing.assert_allclose(imprint.y, -1e-3 * numpy.arange(5.))
        self.refuse_data("unit' is 'foot', but must be one of", imprint="imprint.csv", unit="foot")
        self.refuse_data("has no column 'z'; it has x, height. Choose by \"columns\"", imprint="imprint.csv",
                         columns=["x", "z"])
        self.refuse_data("columns' is 3, but must be a list of two names", imprint="imprint.csv", columns=3)
        self.refuse_data("'experiments/cone/data/1/computed' is null", table="imprint.csv")
        self.refuse_data("computed/y: there is no \"strength\"", table="imprint.csv",
                         computed={"table": "history", "x": "time", "y": "strength"})
        (self.folder / "gap.csv").write_text("x,height\n1,nan\n")
        self.refuse_data("has values that are not finite", imprint="gap.csv")

    def test_absolute_noise(self):
        """In the unit of the data, of curves that of the file: 2 mN, 5 nm, 0.1 µm."""
        rows = [row.split(",") for row in CURVE.splitlines()[1:]]
        (self.folder / "small.csv").write_text("Depth (nm),Force (mN)\n" + "".join(
            f"{1e3 * float(depth)},{1e3 * float(force)}\n" for depth, force in rows))
        load, _ = self.block({"curve": "small.csv", "noise": {"absolute": 2.}})
        numpy.testing.assert_allclose(load.sigma, 2e-3)
        depths, _ = self.block({"curve": "small.csv", "compare": "depth", "noise": {"absolute": 5.}})
        numpy.testing.assert_allclose(depths.sigma, 5e-6)
        imprint, = self.block({"imprint": "imprint.csv", "unit": "µm", "noise": {"absolute": 0.1}})
        numpy.testing.assert_allclose(imprint.sigma, 1e-4)
        self.refuse_data("noise/absolute' is 'x', but must be a number", quantity="hardness", value=3,
                         noise={"absolute": "x"})
        self.refuse_data("noise' is 3, but must be an object", quantity="hardness", value=3, noise=3)

    def test_quantities(self):
        hardness, = self.block({"quantity": "hardness", "value": [3.0, 3.2, 3.1], "unit": "GPa"})
        numpy.testing.assert_allclose([hardness.y[0], hardness.sigma[0]], [3100., 100. / 3. ** 0.5])
        slope, = self.block({"quantity": "unloading slope", "value": 5e6, "unit": "N/m", "noise": {"absolute": 1e5}})
        numpy.testing.assert_allclose([slope.y[0], slope.sigma[0]], [5e3, 100.])
        share, = self.block({"quantity": "plastic work share", "value": 0.9, "noise": {"absolute": 0.01}})
        numpy.testing.assert_allclose(share.y, 0.9)
        self.refuse_data("quantity: there is no \"colour\"", quantity="colour", value=3)
        self.refuse_data("value' is None, but must be a number, or a list", quantity="hardness")
        self.refuse_data("fit' is for unloading slope and unloading slope over depth, not for 'hardness'", quantity="hardness",
                         value=3, fit=[0.5, 0.95])
        for shares in (0.5, [0.5], [0.95, 0.5], [0, 0.5], [0.5, "x"]):
            self.refuse_data("fit' is .*, but must be two shares of the largest force, the lower one first, such as",
                             quantity="unloading slope", value=3, fit=shares)
        self.refuse_data("fit' is for unloading slopes with a name", quantity={"table": "history", "column": "force",
                                                                               "take": "last"}, value=3,
                         fit=[0.5, 0.95])
        self.refuse_data("unit' is 'mm', but must be one of Pa", quantity="hardness", value=3, unit="mm")
        self.refuse_data("'plastic work share' has none", quantity="plastic work share", value=0.9, unit="%")
        self.refuse_data("is for quantities with a name", quantity={"table": "history", "column": "force"}, value=3,
                         unit="N")

    def test_candidates(self):
        data = "candidates/hardness/data"
        self.refuse("must be an object with one of the keys curve, imprint, quantity and a 'noise'", data,
                    {"quantity": "hardness"})
        self.refuse("a key of 'candidates/hardness/data/1': there is no \"value\"", data,
                    {"quantity": "hardness", "noise": {"relative": 0.1}, "value": 3})
        self.refuse("points' is 1, but must be an integer >= 2", data,
                    {"curve": "computed", "noise": {"relative": 0.1}, "points": 1})
        self.refuse("a key of 'candidates/hardness': there is no \"coarse\"", "candidates/hardness/coarse", {})


if __name__ == "__main__":
    unittest.main()
