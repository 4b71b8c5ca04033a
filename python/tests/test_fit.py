# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fits of runs of the program: a tension test with an exact answer, what is not run again, a sphere, quantities."""

import contextlib
import csv
import io
import json
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import numpy

from elasto_plastic_contact import UserError, fit, run
from elasto_plastic_contact.fitting.flow_stress import flow_stress
from elasto_plastic_contact.fitting.predictions import QUANTITIES, Curve
from elasto_plastic_contact.fitting.results import sentences
from elasto_plastic_contact.fitting.runs import Runs
from elasto_plastic_contact.fitting.statistics import UNKNOWN
from elasto_plastic_contact.program import ROOT
from elasto_plastic_contact.study.plan import Case, read_json
from tools.__main__ import main
from tools.inputs.fit_data import CREEP, measured

YOUNG, YIELD_STRESS, HARDENING, STRAIN, NOISE = 200000., 400., 2000., 0.02, 2.
TIMES = numpy.arange(1, 9) / 8.
TENSION = {
    "parameters": {"Y": {"start": 250, "lower": 100, "upper": 1000}, "H": {"start": 500, "lower": 0, "upper": 20000}},
    "entries": {"Material/Yield stress": "Y", "Material/Isotropic hardening modulus": ["H"]},
    "experiments": {"bar": {
        "case": "verification/uniaxial_stress.prm",
        "set": {"Loading/Number of steps": 8, "Geometry/Initial refinements": 0},
        "data": {"table": "bar.csv", "columns": ["t", "stress"], "noise": {"absolute": NOISE},
                 "computed": {"table": "reactions", "x": "time", "y": "top_z"}}}},
    "at once": 2}

# A sphere on a coarse mesh, a third of a second a run.
SPHERE = {"Geometry/Initial refinements": 2, "Geometry/Local refinements": 5, "Loading/Number of steps": 18,
          "Loading/History": "1: depth 0.1 | 1.2: force 0", "Material/Law": "nonlinear hardening",
          "Material/Isotropic hardening modulus": 0}
SWIFT = {"Material/Yield stress": "sigma_Y", "Material/Power law exponent": "n",
         "Material/Power law reference strain": "sigma_Y / E"}

# What stands for the program: notes its folder of temporary files, is slow, and fails for some values.
PROGRAM = """#!/bin/sh
for last; do
  [ "$before" = --output-directory ] && folder=$last
  before=$last
done
case "$*" in
  *=2*) echo "no convergence" >&2; exit 3 ;;
  *=9*) echo "wrong" >&2; exit 2 ;;
  *=8*) echo "disk full" >&2; exit 5 ;;
esac
mkdir -p "$folder"
sleep 0.2
echo "$TMPDIR" >"$folder/place"
"""


def exact(yield_stress, hardening):
    return (yield_stress + hardening * STRAIN * TIMES) / (1. + hardening / YOUNG)


class Fits(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.stress = exact(YIELD_STRESS, HARDENING) + NOISE * numpy.random.default_rng(7).normal(size=8)
        rows = "".join(f"{t},{float(stress)!r}\n" for t, stress in zip(TIMES, self.stress))
        (self.folder / "bar.csv").write_text(f"t,stress\n{rows}")
        self.output, self.said = self.folder / "output", []

    def write(self, problem):
        path = self.folder / "bar.json"
        path.write_text(json.dumps(problem))
        return path

    def fit(self, problem):
        return fit(self.write(problem), self.output, report=self.said.append)

    def finished(self):
        return {path: path.stat().st_mtime_ns for path in self.output.glob("run_*/finished.json")}

    def test_tension(self):
        """Values and errors are those of the linear regression that this is; a second fit makes no run."""
        found = self.fit(TENSION)
        terms = numpy.column_stack([numpy.ones(8), STRAIN * TIMES])
        constant, slope = numpy.linalg.lstsq(terms, self.stress, rcond=None)[0]
        hardening = slope / (1. - slope / YOUNG)
        # (the derivatives of the stress: 1 and the plastic strain, over 1 + H / E)
        slopes = numpy.column_stack([numpy.ones(8), STRAIN * TIMES - terms @ [constant, slope] / YOUNG])
        errors = (1. + hardening / YOUNG) * NOISE * numpy.sqrt(numpy.diag(numpy.linalg.inv(slopes.T @ slopes)))
        for name, value, error in (("Y", constant * (1. + hardening / YOUNG), errors[0]), ("H", hardening, errors[1])):
            self.assertLess(abs(found.values[name] - value), 0.1 * error)
            self.assertLess(abs(found.standard_errors[name] / error - 1.), 0.05)
            region = found.regions[name]
            self.assertEqual(region.closed, (True, True))
            self.assertLess(abs((region.upper - region.lower) / (2. * 1.96 * error) - 1.), 0.08)
        self.assertTrue(found.regions["Y"].lower < YIELD_STRESS < found.regions["Y"].upper)
        self.assertTrue(found.verdict == "unique" and found.converged)
        self.check_files(found)

        before = self.finished()
        again = self.fit(TENSION)
        self.assertEqual((again.n_made, again.n_runs), (0, found.n_runs))
        self.assertEqual(again.values, found.values)
        self.assertEqual(before, self.finished())

    def test_one_value(self):
        """For two parameters: no small errors, and no end of a region that is found along what nothing is known of."""
        (self.folder / "bar.csv").write_text("t,stress\n1,430\n")
        found = self.fit(TENSION)
        self.assertEqual(found.verdict, "not unique")
        self.assertGreater(found.standard_errors["Y"], 1e6)
        self.assertEqual([error < UNKNOWN for _, error, _ in found.directions], [True, False])
        self.assertRegex("\n".join(sentences(found)), "the data say nothing of: [-+0-9. ]+ln\\(Y\\)|nothing of: .*H/")

    def check_files(self, found):
        with (self.output / "fit.csv").open(newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["parameter"] for row in rows], ["Y", "H"])
        self.assertEqual(list(rows[0]), ["parameter", "value", "standard_error", "lower", "upper"])
        self.assertAlmostEqual(float(rows[0]["value"]), found.values["Y"], places=9)
        data = json.loads((self.output / "fit.json").read_text())
        self.assertEqual(data["parameters"]["H"]["upper"], found.regions["H"].upper)
        self.assertAlmostEqual(data["correlation"]["matrix"][0][0], 1., places=12)
        self.assertLess(data["correlation"]["matrix"][0][1], -0.5)  # constant and slope of a line
        numpy.testing.assert_allclose(data["residuals"][0]["measured"], self.stress)
        self.assertEqual(set(data["flat_direction"]["components"]), {"Y", "H"})

    def test_command(self):
        """The table and the picture; kills; unknown noise."""
        problem = {**TENSION, "at once": 1,
                   "experiments": {"bar": json.loads(json.dumps(TENSION["experiments"]["bar"]))}}
        del problem["experiments"]["bar"]["data"]["noise"]
        command = ["fit", str(self.write(problem)), "--output-directory", str(self.output)]
        process = subprocess.Popen([sys.executable, "-m", "elasto_plastic_contact", *command],
                                   stdout=subprocess.DEVNULL)
        while process.poll() is None and len(self.finished()) < 3:
            time.sleep(0.005)
        process.send_signal(signal.SIGKILL)
        process.wait()
        before = self.finished()
        self.assertFalse((self.output / "fit.csv").exists())
        done = subprocess.run([sys.executable, "-m", "elasto_plastic_contact", *command], stdout=subprocess.PIPE,
                              text=True,
                              check=True)
        self.assertEqual(before, {path: self.finished()[path] for path in before})
        self.assertRegex(done.stdout, r"fine stage\n  Y = 250, H = 500: sum of squares")
        self.assertRegex(done.stdout, r"parameter +value +std. error +95 % region\nY ")
        self.assertRegex(done.stdout, "best known is the flow stress at the plastic strain")
        self.assertTrue((self.output / "fit.png").read_bytes().startswith(b"\x89PNG"))

    def test_coverage(self):
        """The command that repeats a fit with other noises: of eight regions each, seven at least hold the true
        value."""
        command = ["fit_coverage", str(self.write(TENSION)), "--output-directory", str(self.output), "--truth", "400"]
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            self.assertEqual(main([*command, "2000", "--repetitions", "8"]), 0)
        self.assertRegex(said.getvalue(), r"Y +[78] of 8, deviations .*\nH +[78] of 8, deviations ")
        self.assertRegex(said.getvalue(), r"sum of squares over degrees of freedom (0\.[4-9]|1\.[0-6])")
        self.assertEqual(main(command), 2)  # (one value for two parameters)

    def test_failed_start(self):
        problem = json.loads(json.dumps(TENSION))
        problem["experiments"]["bar"]["set"] |= {"Nonlinear solver/Maximum number of iterations": 1,
                                                 "Loading/Maximum number of cuts": 0}
        for _ in range(2):
            with self.assertRaisesRegex(UserError,
                                        "the run at the start has failed, so that there is nothing to begin with"):
                self.fit(problem)
        self.assertEqual(len(list(self.output.glob("run_*/failed.json"))), 1)

    def test_refused(self):
        problem = json.loads(json.dumps(TENSION))
        problem["experiments"]["bar"]["set"]["Material/Poisson's ratio"] = 0.7
        path = self.write(problem)
        with self.assertRaisesRegex(UserError, "the run at the start is refused: .*Poisson's ratio"):
            fit(path, self.output, report=self.said.append)
        self.assertEqual(main(["fit", str(path), "--output-directory", str(self.folder)]), 2)  # (no fit)

    def test_runs(self):
        """With a program that notes its folder of temporary files, is slow, and fails for one value: each run is made
        once and has a folder of its own; what fails is known the next time, too, and what is refused is tried again; an
        error of writing ends all."""
        program = self.folder / "program"
        program.write_text(PROGRAM)
        program.chmod(0o755)
        (self.folder / "case.prm").write_text("")
        case = Case(case=self.folder / "case.prm", common={}, ranks=1)
        tasks = [(case, {"Material/Yield stress": value}) for value in (1, 3, 4, 1, 2)]
        for n_made in (4, 0):
            with Runs(self.folder, str(program), 4) as runs:
                found = runs.results(tasks)
                self.assertEqual(runs.n_made, n_made)
            places = {pathlib.Path(result.path("place")).read_text() for result in found[:4]}
            self.assertEqual(len(places), 3)
            self.assertFalse(any(pathlib.Path(place.strip()).exists() for place in places))
            self.assertEqual(found[4].message, "no convergence")
        for _ in range(2):
            with Runs(self.folder, str(program), 1) as runs:
                refused, good = runs.results([(case, {"Material/Yield stress": value}) for value in (9, 1)])
                self.assertEqual((refused.message, runs.n_made), ("wrong", 1))
                self.assertTrue(good.path("place"))
        with Runs(self.folder, str(program), 1) as runs, self.assertRaisesRegex(UserError, "= 8 has ended: disk full"):
            runs.results([(case, {"Material/Yield stress": 8})])

    def test_flow_stress(self):
        """The stress that the program finds in a bar, at its plastic strain."""
        entries = {"Material/Law": "nonlinear hardening", "Material/Voce stress": 100, "Material/Voce rate": 30,
                   "Material/Power law exponent": 0.2, "Material/Power law reference strain": 0.002,
                   "Material/Hardening table": "0.01: 450 | 0.05: 500", "Material/Back stress moduli": "2000 | 300",
                   "Material/Recovery rates": "40 | 0", "Loading/Number of steps": 20, "Output/Fields": "never"}
        bar = run("verification/uniaxial_stress.prm", self.folder / "bar", entries)
        stress = bar.reactions["top_z"]
        plastic = STRAIN * bar.history["time"] - stress / YOUNG
        numpy.testing.assert_allclose(flow_stress(bar.parameters, plastic[3:]), stress[3:], rtol=2e-3)

    def sphere(self, name, entries):
        return run("indentation/sphere_finite_strain.prm", self.folder / name,
                   SPHERE | entries | {"Output/Fields": "never"})

    def test_sphere(self):
        """Yield stress and exponent of a sphere's curve with 1 % noise: the true ones lie in their regions."""
        truth = {"Material/Yield stress": 400, "Material/Power law exponent": 0.2,
                 "Material/Power law reference strain": 0.002}
        results = self.sphere("truth", truth)
        rows = measured(results, 0.01, numpy.random.default_rng(11))
        (self.folder / "sphere.csv").write_text("Depth (µm),Force (mN)\n"
                                                + "".join(f"{1e3 * h},{1e3 * f}\n" for h, f in rows))
        problem = {
            "parameters": {"sigma_Y": {"start": 600, "lower": 100, "upper": 2000},
                           "n": {"start": 0.1, "lower": 0, "upper": 0.5}},
            "constants": {"E": YOUNG}, "entries": SWIFT, "at once": 2,
            "experiments": {"sphere": {
                "case": "indentation/sphere_finite_strain.prm",
                "set": {key: value for key, value in SPHERE.items() if key != "Loading/History"},
                "units": {"length": "mm", "force": "N"}, "load to": "depth",
                "data": {"curve": "sphere.csv", "noise": {"of largest": 0.01}}}}}
        found = self.fit(problem)
        for name, value in (("sigma_Y", 400.), ("n", 0.2)):
            region = found.regions[name]
            self.assertTrue(region.lower < value < region.upper, (name, found.values, found.regions))
            self.assertLess(region.upper - region.lower, 0.6 * value)
        self.assertTrue(0.6 < found.quality.chi_square / found.quality.freedom < 1.5)
        stress = 400. * (1. + found.representative.plastic_strain * YOUNG / 400.) ** 0.2
        self.assertTrue(found.representative.lower < stress < found.representative.upper)

    def test_creep(self):
        """The rate exponent from the hold of the ready problem, on its coarse mesh: the true one lies in its region."""
        problem = read_json(ROOT / "parameter_files/fit/creep.json")
        experiment = problem["experiments"]["sphere"]
        experiment["set"] |= experiment.pop("coarse")
        truth = {path: CREEP[name] for path, name in problem["entries"].items()}
        history = run(experiment["case"], self.folder / "truth",
                      experiment["set"] | truth | {"Output/Fields": "never"}).history
        noise = 0.002 * history["depth"].max() * numpy.random.default_rng(3).normal(size=len(history))
        (self.folder / "creep.csv").write_text("Time (s),Depth (µm),Force (mN)\n0,0,0\n" + "".join(
            f"{row['time']},{row['depth'] + error},{row['force']}\n" for row, error in zip(history, noise)))
        problem |= {"parameters": {"n": problem["parameters"]["n"] | {"start": 3}}, "constants": {"D": CREEP["D"]},
                    "step": 0.05}
        found = self.fit(problem)
        region = found.regions["n"]
        self.assertTrue(region.lower < CREEP["n"] < region.upper, (found.values, region))
        self.assertLess(region.upper - region.lower, 0.1 * CREEP["n"])
        self.assertIsNone(found.representative)  # (the stress depends on the rate, too)
        residuals, = json.loads((self.output / "fit.json").read_text())["residuals"]
        self.assertEqual(residuals["kind"], "hold")

    def test_quantities(self):
        """Of a run, by its tables, and by what is known of elastic unloading and of works."""
        results = self.sphere("quantities", {"Material/Yield stress": 400, "Loading/Number of steps": 60})
        values = {name: find(results) for name, (find, _) in QUANTITIES.items()}
        self.assertEqual(values["largest force"], results.history["force"].max())
        self.assertEqual(values["largest depth"], 0.1)
        self.assertEqual(values["hardness"], results.indentation["hardness"][0])
        radius = results.indentation["contact_radius"][0]
        self.assertLess(abs(values["unloading slope"] / (2. * YOUNG / 0.91 * radius) - 1.), 0.15)
        self.assertAlmostEqual(values["unloading slope over depth"], 10. * values["unloading slope"], places=3)
        work = results.history["external_work"]
        top = int(results.history["force"].argmax())
        self.assertLess(abs(values["plastic work share"] - work[-1] / work[top]), 0.01)
        self.assertEqual(values["residual depth"], Curve(results).unload[-1, 0])
        # (a sphere's curve has a larger curvature at smaller depths)
        self.assertGreater(values["loading curvature"], values["largest force"] / 0.1 ** 2)


if __name__ == "__main__":
    unittest.main()
