# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command evaluate for files of instruments: tables, JSON, pictures, corrections, a run beside them, messages."""

import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy

from commands import command
from elasto_plastic_contact import read_curve, run
from elasto_plastic_contact.measured import MeasuredCurve
from elasto_plastic_contact.measured.tips import read_area
from test_measured_evaluation import HARDNESS, REDUCED, SHARP, indent

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "scripts/evaluate.py"


class Command(unittest.TestCase):
    """Files are in nm, mN and s."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.file = cls.write("indent.txt", indent((10., 20.), hold=5.))

    @classmethod
    def write(cls, name, curve, head=""):
        path = cls.folder / name
        rows = "".join(f"{t:.6f}\t{1e3 * h:.6f}\t{f:.6f}\n" for t, h, f in zip(curve.time, curve.depth, curve.force))
        path.write_text(f"{head}Time (s)\tDepth (nm)\tLoad (mN)\n{rows}")
        return path

    def command(self, *arguments, status=0):
        process = command("evaluate", *arguments)
        self.assertEqual(process.returncode, status, process.stderr)
        self.assertNotIn("Traceback", process.stderr)
        return process

    def expect_message(self, pattern, *arguments):
        lines = self.command(*arguments, status=2).stderr.splitlines()
        self.assertRegex(lines[-1], f"^evaluate: .*{pattern}")

    def found(self, *arguments):
        path = self.folder / "found.json"
        self.command(*arguments, "--json", path)
        return json.loads(path.read_text(encoding="utf-8"))

    def test_table_json_and_picture(self):
        picture = self.folder / "picture.png"
        process = self.command(self.file, self.file, "--berkovich", "--output", picture, "--poisson", 0.2)
        self.assertRegex(process.stdout, "tip: Berkovich, sharp: 3 faces at 65.27° to the axis")
        self.assertRegex(process.stdout, r"(?m)^ +indent +unloading +F_max +h_max .* H +E_r +E\* +E ")
        self.assertRegex(process.stdout, r"mean ± standard deviation\n")
        self.assertTrue(picture.read_bytes().startswith(b"\x89PNG"))
        found = self.found(self.file, "--area", SHARP)
        self.assertAlmostEqual(found["indents"][0]["unloadings"][1]["tip_hardness"] / HARDNESS, 1., places=3)
        self.assertEqual([segment["kind"] for segment in found["indents"][0]["segments"]][:3],
                         ["load", "hold", "unload"])
        self.assertAlmostEqual(found["statistics"]["all"]["tip_reduced_modulus"]["mean"] / REDUCED, 1., places=3)
        self.assertEqual(found["constants"]["indenter"], [1141., 0.07])
        self.assertIn("(diamond)", " ".join(found["remarks"]))

    def test_noise(self):
        """Of a force that scatters by 1 %: one unloading, and a sentence."""
        curve = indent((10.,))
        noisy = MeasuredCurve("1", curve.depth, curve.force + 0.1 * numpy.random.default_rng(2).normal(size=len(curve.force)),
                              curve.time)
        process = self.command(self.write("noisy.txt", noisy), "--area", SHARP)
        self.assertRegex(process.stdout, r"noise: the force scatters, so that a segment ends where it turns back by [4-9]\.[0-9]% of "
                                         "its largest value")
        self.assertNotIn("unloading 2", process.stdout)
        self.assertNotIn("noise: ", self.command(self.file, "--area", SHARP).stdout)

    def test_tips(self):
        section = {}
        for name, options in (("pyramid", ["--pyramid", 3, 65.27]), ("berkovich", ["--berkovich"]),
                              ("vickers", ["--vickers"]),
                              ("cube corner", ["--cube-corner"]), ("cone", ["--cone", 70.3]),
                              ("sphere", ["--sphere", 5000])):
            unloading = self.found(self.file, *options, "--epsilon", 0.75)["indents"][0]["unloadings"][0]
            section[name] = unloading["tip_area"] / unloading["contact_depth"] ** 2
        self.assertAlmostEqual(section["pyramid"], section["berkovich"])
        for name, value in (("berkovich", 24.494), ("vickers", 24.504), ("cube corner", 2.598), ("cone", 24.5)):
            self.assertAlmostEqual(section[name], value, delta=0.01)
        self.assertGreater(section["sphere"], 100.)

    def test_area_files(self):
        coefficients, table = self.folder / "tip.txt", self.folder / "tip.csv"
        coefficients.write_text(f"# calibrated\nC0 = {SHARP}\nC1 = 0\n")
        heights = numpy.linspace(0., 1000., 200)
        table.write_text("depth,area\n" + "".join(f"{h},{SHARP * h ** 2}\n" for h in heights))
        for path in (coefficients, table):
            found = self.found(self.file, "--area-file", path)
            self.assertAlmostEqual(found["indents"][0]["unloadings"][0]["tip_hardness"] / HARDNESS, 1., places=3)
        self.assertAlmostEqual(read_area(table, 1e-3)[0].area(0.5), SHARP * 0.25, places=6)
        for text in ("C0 = 24.5\nC1 = 1,234\n", "C0 = 24,5\nC1 = 1234\n", "C0 = 24,5\nC1 = 1.234,0\n"):
            coefficients.write_text(text)
            self.assertAlmostEqual(read_area(coefficients, 1.)[0].area(1.), 24.5 + 1234.)
        for text, words in (("C0 = 24.5\nC2 = 1\n", "coefficients C0, C2, but they must be C0, C1 and so on"),
                            ("nothing\n", "holds no area function: .*; its first line is 'nothing'"),
                            ("1 1\n3 2\n2 3\n", "depths do not grow"),
                            ("C0 = 24.5.1\n", "has the coefficient C0 '24.5.1', which is no number"),
                            ("1;1\n2;2\n1.003,5;3\n4;4\n", "one of its lines is '1.003,5;3': mend or remove it")):
            coefficients.write_text(text)
            self.expect_message(words, self.file, "--area-file", coefficients)

    def test_corrections(self):
        true = self.found(self.file, "--area", SHARP)["indents"][0]["unloadings"][1]
        curve = indent((10., 20.), hold=5., drift=1e-4)
        path = self.write("changed.txt",
                          MeasuredCurve("1", curve.depth + 2e-3 * curve.force + 0.06, curve.force, curve.time))
        self.expect_message("the depth of the indent '1' is not counted from the first contact: .* begins at 6[0-9.]+ nm, .* "
                            "by --zero-point fit, or .* --zero-point '5 nm'", path, "--area", SHARP)
        self.assertRegex(self.command(path, "--area", SHARP, "--zero-point", 0).stdout, "zero point: 0 nm, --zero-point")
        self.assertRegex(self.command(self.file, "--area", SHARP).stdout,
                         "zero point: 0, as in the file; the loading, continued, begins at [-0-9.e]+ nm, [-0-9.e]+ % of the depth\n")
        for drift, zero, words in (("hold", "fit",
                                    "drift: 0.1 nm/s, by the second half of the hold at 2 mN, .*: 2.* nm at the largest"),
                                   ("0.1 nm/s", "60 nm", "drift: 0.1 nm/s, by --drift: ")):
            options = ("--area", SHARP, "--drift", drift, "--zero-point", zero, "--frame-compliance", "2 nm/mN")
            found = self.found(path, *options)["indents"][0]
            self.assertRegex(" ".join(found["remarks"]), words)
            self.assertRegex(" ".join(found["remarks"]),
                             "frame: 2 nm/mN, by --frame-compliance: 40 nm at the largest force")
            for name, value in true.items():
                if name not in ("creep_depth", "creep_rate"):
                    self.assertAlmostEqual(found["unloadings"][1][name] / value, 1., delta=5e-3, msg=name)

    def test_corrections_of_the_instrument(self):
        head = ("File Version: Hysitron HighLoad\nMachine Comp: 0.0001 nm/µN\nTip C0: 24.5 nm^2/nm^2\nDrift Rate: 0.02 nm/s\n"
                "Test Data Points: 1000\n")
        curve = indent((10., 20.), hold=5.)
        path = self.write("test.hld", curve, head.replace("1000", str(len(curve.depth))))
        found = self.found(path)["indents"][0]
        self.assertAlmostEqual(found["unloadings"][0]["tip_hardness"] / HARDNESS, 1., places=3)
        self.assertRegex(" ".join(found["remarks"]),
                         "the file says 0.02 nm/s; not subtracted .*says 0.1 nm/mN; not subtracted")
        found = self.found(path, "--drift", "instrument", "--frame-compliance", "instrument")["indents"][0]
        self.assertRegex(" ".join(found["remarks"]),
                         "drift: 0.02 nm/s, by the file: .*frame: 0.1 nm/mN, by the file: 2 nm at")

    def test_results(self):
        path = self.folder / "results.csv"
        path.write_text("C (GPa),dP/dh (N/m),Wp/Wt,hm (um)\n" + "".join(f"{c},5e6,0.9,10\n" for c in range(26, 31)))
        process = self.command(path, "--json", self.folder / "means.json")
        self.assertRegex(process.stdout, r"C \(GPa\) +28 +1.58 +5.6 %")
        self.assertEqual(json.loads((self.folder / "means.json").read_text())["mean"], [28., 5e6, 0.9, 10.])
        batch = self.folder / "batch.txt"
        batch.write_text("Number of Data Points = 6\n        \nFile\thc(nm)\tPmax(µN)\tS(µN/nm)\thmax(nm)\tEr(GPa)\tH(GPa)\n"
                         + "".join(f"Steel 000{i} LC.hys\t160.4\t5997.6\t78.9\t217.3\t7{i}.0\t6.3\n" for i in range(6)))
        self.assertRegex(self.command(batch).stdout, r"Er\(GPa\) +72.5 +1.87 +2.6 %")
        batch.write_text("C (GPa),hm (um),Wp/Wt\n1,2,3\n")
        self.expect_message("names results of indents, and has less than 5 rows|holds no rows of numbers", batch)
        batch.write_text("C (GPa),hm (um),Wp/Wt\n" + "1,2,3,4\n" * 6)
        self.expect_message("has 4 values in line 2, and 3 names of columns above them", batch)
        force, stiffness = 10., 2. * REDUCED * math.sqrt(10. / HARDNESS / math.pi)
        depth = math.sqrt(force / HARDNESS / SHARP) + 0.75 * force / stiffness
        for column, value in (("Pm (mN)", force), ("C (GPa)", force / depth ** 2)):
            batch.write_text(f"{column},dP/dh (N/m),hm (um),Wp/Wt\n" + f"{value},{1e3 * stiffness},{depth},0.9\n" * 5)
            found = self.found(batch, "--area", SHARP)["statistics"]
            self.assertAlmostEqual(found["tip_hardness"]["mean"], HARDNESS)
            self.assertAlmostEqual(found["tip_reduced_modulus"]["mean"], REDUCED)
        self.assertRegex(self.command(batch, "--area", SHARP).stdout, r"(?m)^ *E_r +70 ± 0 +GPa$")
        batch.write_text("C (GPa),Wp/Wt,hm (um)\n" + "1,2,3\n" * 6)
        self.expect_message("no hardness to be found: that takes columns of dP/dh, h_m, and P_m or C, .*it has C .GPa., Wp",
                            batch, "--berkovich")
        self.expect_message("holds results, one row an indent, and no curve to draw", path, "--output",
                            self.folder / "no.png")
        self.expect_message("holds results, one row an indent, and no curve: give it alone", self.file, path)

    def test_without_what_it_takes(self):
        process = self.command(self.file)
        self.assertRegex(process.stdout,
                         "tip: not known, so that there is no hardness and no modulus: give it by --berkovich")
        self.assertRegex(process.stdout, r"F_max +h_max +S +C +W_t +W_p/W_t")
        curve = indent((10.,))
        rising = MeasuredCurve("1", curve.depth[:200], curve.force[:200], curve.time[:200])
        process = self.command(self.write("rising.txt", rising), "--berkovich")
        self.assertRegex(process.stdout, "no unloading was found; it takes a fall of the force")
        self.assertRegex(process.stdout, r"(?m)^indent +F_max +h_max +C +n$\n.*\n +1 +10 +0.3108 +103.5 +2$")
        process = self.command(self.file, "--berkovich", "--fit", 0.94, 0.95)
        self.assertRegex(process.stdout,
                         "unloading 1: fewer than three points that fall between 95 and 94 % of its force")
        process = self.command(self.file, "--area", -24.5)
        self.assertRegex(process.stdout, "unloading 1: its contact depth is .* where the section of the tip is -")
        process = self.command(self.file, "--area", 0.01)
        self.assertRegex(process.stdout, "unloading 1: its reduced modulus is above what the indenter alone would give")

    def test_messages(self):
        for words, *options in (
                ("--unit is 'depth', but must begin with .*'=', such as depth=nm|units of depth are", "--unit",
                 "depth"),
                ("--columns is 'depth:1', but must be like depth=2,force=3, or two names", "--columns", "depth:1"),
                ("--columns is 'deep=1', but must be like depth=2,force=3, of time", "--columns", "deep=1"),
                ("--fit is 0.9 0.5, but the first share must be below the second", "--fit", 0.9, 0.5),
                ("--indents has 3, but there are 1 of them, numbered from 1", "--indents", 3),
                ("argument --drift: it is 'fast', but must be a number with a unit, such as '0.3 nm/s', or hold or instrument",
                 "--drift", "fast"),
                ("argument --frame-compliance: it is '2', but must be a number with a unit, such as '0.3 nm/mN', or instrument",
                 "--frame-compliance", 2),
                ("argument --tip-unit: there is no unit of length 'mN'; there are pm", "--tip-unit", "mN"),
                ("does not say the drift rate of the instrument: give it by --drift '0.05 nm/s'", "--drift",
                 "instrument"),
                ("does not say the frame compliance of the instrument: give", "--frame-compliance", "instrument"),
                ("the frame compliance of the indent '1', 12 nm/mN by --frame-compliance, is too large: the frame would "
                 "take 216 nm of a depth that changes by 188.5 nm. Give a smaller one", "--frame-compliance", "12 nm/mN"),
                ("argument --zero-point: it is '3 mN', but must be a depth, such as '5 nm'", "--zero-point", "3 mN"),
                ("no depth beyond its zero point, 9000 nm: its largest one is ", "--zero-point", "9 µm"),
                ("--length-unit is that of a run, and there is none", "--length-unit", "mm")):
            with self.subTest(words):
                lines = self.command(self.file, *options, status=2).stderr.splitlines()
                self.assertRegex(lines[-1], words)
        without_hold = self.write("no_hold.txt", indent())
        self.expect_message("has no hold below 35 % of its largest force after the unloading", without_hold, "--drift",
                            "hold")
        curve = indent()
        unloading = MeasuredCurve("1", curve.depth[200:], curve.force[200:], curve.time[200:])
        self.expect_message("has too few points of a loading to fit its zero point",
                            self.write("unloading.txt", unloading),
                            "--zero-point", "fit")
        no_time = self.folder / "no_time.txt"
        no_time.write_text("Depth (nm)\tLoad (mN)\n" + "".join(f"{h}\t{f}\n" for h, f in zip(curve.depth, curve.force)))
        self.expect_message("has no time, and its drift is a rate", no_time, "--drift", "0.1 nm/s")

    def test_rows_that_are_not_in_the_order_of_time(self):
        """Read backwards, with a time and without, with units and without, and a time that falls on the way."""
        curve = indent()
        rows = numpy.column_stack([curve.time, 1e3 * curve.depth, curve.force])
        fallen = numpy.where(numpy.arange(len(rows)) < 200, rows.T, rows.T - [[5.], [0.], [0.]]).T
        heads = ("Time (s)", "Depth (nm)", "Load (mN)"), ("time", "depth", "force")
        falls, works = "has a time that falls from .* in row {} to .* .column '{}'.: .*sort them", "gives back more work .*sort them"
        for head, table, first, message in ((heads[0], rows[::-1], 0, falls.format(1, "Time .s.")),
                                            (heads[1], rows[::-1], 0, falls.format(1, "time")),
                                            (heads[0], fallen, 0, falls.format(200, "Time .s.")),
                                            (heads[0], rows[::-1], 1, works), (heads[1], rows[::-1], 1, works)):
            path = self.folder / "order.csv"
            numpy.savetxt(path, table[:, first:], delimiter=",", header=",".join(head[first:]), comments="")
            self.expect_message(f"order.csv'.*{message}", path, "--berkovich")

    def test_order_of_time_that_is_right(self):
        """A time that stands still, a tip that is pulled off, a preload, rows of zeros at the end."""
        curve = indent()
        rows = numpy.column_stack([curve.time, 1e3 * curve.depth, curve.force])
        twice = numpy.repeat(rows, 2, axis=0)
        pulled = numpy.vstack([rows, rows[-1] + [[1., -5., -0.05 * curve.force.max()]]])
        zeros = numpy.vstack([rows, numpy.zeros((3, 3))])
        # (of an elastic ball, which gives back all that it takes; the part below the preload was not recorded)
        depth = numpy.concatenate([numpy.linspace(0.55, 1., 100), numpy.linspace(1., 0., 200)])
        preloaded = numpy.column_stack([numpy.arange(300.), 1e3 * depth, 10. * depth ** 1.5])
        for table in (twice, pulled, zeros, preloaded):
            path = self.folder / "right.csv"
            numpy.savetxt(path, table, delimiter=",", header="Time (s),Depth (nm),Load (mN)", comments="")
            read_curve(path)
        numpy.savetxt(path, zeros, delimiter=",", header="Time (s),Depth (nm),Load (mN)", comments="")
        self.assertEqual(len(read_curve(path)[0].depth), len(rows))

    def test_missing_library(self):
        """Of a kind of file that is not read otherwise."""
        folder = self.folder / "without"
        folder.mkdir()
        for name, start, package in (("xlrd", b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", "python3-xlrd"),
                                     ("openpyxl", b"PK\x03\x04 xl/", "python3-openpyxl"),
                                     ("h5py", b"\x89HDF\r\n\x1a\n", "python3-h5py")):
            (folder / f"{name}.py").write_text(f"raise ModuleNotFoundError(\"No module named '{name}'\", name='{name}')\n")
            path = self.folder / f"needs_{name}"
            path.write_bytes(start)
            process = subprocess.run([sys.executable, SCRIPT, path], capture_output=True, text=True, check=False,
                                     env=os.environ | {"PYTHONPATH": str(folder)})
            self.assertEqual(process.returncode, 2)
            self.assertRegex(process.stderr, f"^evaluate: .*{name}.* The Debian package {package} installs it")

    def test_units_that_are_not_named(self):
        """As a table of this program: in its own units, and without what takes others."""
        table = self.folder / "own.csv"
        curve = indent()
        table.write_text("depth,force\n" + "".join(f"{h},{f}\n" for h, f in zip(curve.depth, curve.force)))
        process = self.command(table, "--berkovich")
        self.assertRegex(process.stdout, "^curve,zero_point,max_depth,")
        process = self.command(table, "--berkovich", "--unit", "depth=um", "--unit", "force=mN")
        self.assertRegex(process.stdout, "a table of numbers, 1 indent")
        for options in (("--json", "x.json"), ("--drift", "1 nm/s"), ("--poisson", 0.2)):
            self.expect_message(f"{options[0]} is for curves whose units are known, and without --run", table,
                                "--berkovich", *options)
        self.expect_message("--zero-point has a unit, and the curve is evaluated", table, "--berkovich", "--zero-point",
                            "5 nm")

    def test_hold_of_a_run(self):
        """A curve of the program as a measured one: the rate sensitivity of its hold is that of indentation.csv, whose
        contact area is the computed one in place of the section of the tip, and that of the material."""
        creeping = run("creep/rate_jump.prm", self.folder / "creeping", {
            "Geometry/Initial refinements": 3, "Refinement/Elements over contact radius": 5, "Output/Fields": "never",
            "Loading/History": "0.5: depth 0.1 | 6: strain rate 0.1 | 20: force rate 0", "Loading/Number of steps": 40})
        units = [part for unit in ("depth=mm", "force=N", "time=s") for part in ("--unit", unit)]
        found = self.found(creeping.path("history.csv"), "--cone", 70.3, *units)["indents"][0]["last_hold"]
        row = creeping.table("indentation")[-1]
        self.assertAlmostEqual(found["creep_depth"] / (1e6 * row["creep_depth"]), 1., delta=0.02)
        self.assertAlmostEqual(found["hold_rate_sensitivity"] / row["hold_rate_sensitivity"], 1., delta=0.05)
        self.assertAlmostEqual(found["hold_rate_sensitivity"] / 0.2, 1., delta=0.05)

    def test_beside_a_run(self):
        """A curve in nm and mN of what a run has computed gives the numbers of the run."""
        cone = run("indentation/cone_axisymmetric.prm", self.folder / "cone", {
            "Geometry/Local refinements": 5, "Geometry/Local radius": 4, "Refinement/Elements over contact radius": 0,
            "Loading/History": "1: depth 0.02 | 2: force 0", "Loading/Number of steps": 20, "Output/Fields": "never"})
        history = cone.history
        head = "Depth (nm)\tLoad (mN)\n"
        rows = "".join(f"{1e6 * row['depth']}\t{1e3 * row['force']}\n" for row in history)
        path = self.folder / "instrument.txt"
        path.write_text(head + rows)
        units = ("--length-unit", "mm", "--force-unit", "N")
        lines = self.command(path, "--run", self.folder / "cone", *units).stdout.splitlines()
        self.assertEqual([line.partition(",")[0] for line in lines], ["curve", "measured", "computed"])
        measured, computed = ([float(value) for value in line.split(",")[1:]] for line in lines[1:])
        numpy.testing.assert_allclose(measured, computed, rtol=1e-4)
        self.expect_message("has the unit of length 'foot', which is none of pm, .*: give it by --length-unit", path,
                            "--run",
                            self.folder / "cone", "--length-unit", "foot")
        path.write_text(f"{head}{rows}\n{head}{rows}")
        self.expect_message("holds 2 indents, and one is compared with the run: choose it, such as by --indents 1",
                            path, "--run",
                            self.folder / "cone", *units)
        self.expect_message("2 files are given, but one curve is compared with a run", path, path, "--run",
                            self.folder / "cone")
        results = self.folder / "results_for_run.csv"
        results.write_text("C (GPa),Wp/Wt,hm (um)\n" + "1,2,3\n" * 6)
        self.expect_message("holds results, one row an indent, and no curve to compare", results, "--run",
                            self.folder / "cone")


if __name__ == "__main__":
    unittest.main()
