# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands as they are typed: pictures, tables, and one message after a mistake."""

import argparse
import csv
import math
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import elasto_plastic_contact
from commands import command
from elasto_plastic_contact import Results, UserError, run
from elasto_plastic_contact.evaluate import run_to_compare, tip_of_run
from elasto_plastic_contact.plots.equilibrium import last_slip_lines
from elasto_plastic_contact.plots.quantities import shown_entry

SCRIPTS = pathlib.Path(__file__).resolve().parents[2] / "scripts"
CONE = {"Geometry/Local refinements": 5, "Geometry/Local radius": 4, "Refinement/Elements over contact radius": 0,
        "Loading/History": "1: depth 0.02 | 2: force 0", "Loading/Number of steps": 20,
        "Output/Fields": "never"}


def run_there(folder, *arguments):
    return subprocess.run([sys.executable, SCRIPTS / "command.py", "run", *map(str, arguments)], cwd=folder,
                          capture_output=True, text=True, check=False)


class Commands(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.cone = run("indentation/cone_axisymmetric.prm", cls.folder / "cone", CONE)

    def expect_message(self, pattern, name, *arguments, status=2):
        process = command(name, *arguments)
        self.assertNotIn("Traceback", process.stderr)
        self.assertRegex(process.stderr.splitlines()[-1], f"^{name}: .*{pattern}")
        self.assertEqual(process.returncode, status)

    def test_plot(self):
        process = command("plot", "energies", self.folder / "cone")
        self.assertEqual(process.stdout, f"{self.folder}/cone/energies.png\n")
        self.expect_message("no diagram 'energy' of a run; there are pressure, .* Others, .* equilibrium, friction, ",
                            "plot", "energy", self.folder / "cone")
        self.expect_message("nothing to show for stress_strain", "plot", "stress_strain", self.folder / "cone")
        self.expect_message("parameters.prm' cannot be read: No such file", "plot", "energies", self.folder)
        plots = self.folder / "plots" / "of_cone"
        process = command("plot", "energies", self.folder / "cone", "--output-directory", plots)
        self.assertEqual(process.stdout, f"{plots}/energies.png\n")
        self.expect_message("cannot be written: ", "plot", self.folder / "cone", "--output-directory",
                            self.folder / "cone" / "history.csv" / "plots", status=5)
        for step in (999, -21):
            self.expect_message(f"there is no step {step} in '.*history.csv': it has 20, counted from 0, or from -1 backwards",
                                "plot", self.folder / "cone", "--step", step)
        self.expect_message("argument --output-directory: it is 'a.png', but must be a folder; what names a picture is --panels",
                            "plot", self.folder / "cone", "--output", "a.png")
        self.expect_message("argument --parts: it is '0', but must be a number > 0", "plot", self.folder / "cone", "--parts", 0)

    def test_damaged_results(self):
        """Of copies of the run, one file each is not what the program has written."""
        for file, damage, pattern in (
                ("history.csv", lambda text: text.replace("force", "farce"), "lacks the column 'force'; it has step, "),
                ("history.csv", lambda text: "", "history.csv' holds no results yet"),
                ("parameters.prm", lambda text: text + "\nend\n", "parameters.prm' is damaged in line "),
                ("parameters.prm", lambda text: "set Kinematics\n", "parameters.prm' is damaged in line 1")):
            folder = self.folder / "damaged"
            shutil.copytree(self.folder / "cone", folder)
            (folder / file).write_text(damage((folder / file).read_text()))
            self.expect_message(pattern, "plot", "force_depth", folder)
            shutil.rmtree(folder)

    def test_damaged_fields(self):
        folder = self.folder / "fields"
        folder.mkdir()
        (folder / "solution.pvd").write_text('<VTKFile><DataSet timestep="0" file="a.vtu"/></VTKFile>')
        (folder / "parameters.prm").write_text("")
        for text in ("", "<VTKFile/", '<VTKFile><Piece NumberOfPoints="1"/></VTKFile>',
                     '<VTKFile><Piece><Points><DataArray type="Float32" format="binary">AQAA</DataArray></Points>'
                     '</Piece></VTKFile>'):
            (folder / "a.vtu").write_text(text)
            self.expect_message("a.vtu' is damaged, or has not been written by the program", "render", folder)

    def test_no_slip_lines(self):
        """deal.II writes a piece without points where nothing slips."""
        (self.folder / "slip_lines.pvd").write_text('<VTKFile><DataSet timestep="0" file="slip.vtu"/></VTKFile>')
        (self.folder / "slip.vtu").write_text(
            '<VTKFile><UnstructuredGrid><Piece NumberOfPoints="0" NumberOfCells="0"><Cells>'
            '<DataArray type="UInt8" Name="types"></DataArray></Cells><PointData Scalars="scalars">'
            '<DataArray type="Float32" Name="slip" NumberOfComponents="3"></DataArray></PointData></Piece>'
            '</UnstructuredGrid></VTKFile>')
        self.assertEqual(len(last_slip_lines(self.folder)["cells"]), 0)

    def test_full_disk(self):
        """/dev/full stands for one."""
        with open("/dev/full", "w") as full:
            process = subprocess.run([sys.executable, SCRIPTS / "plot.py", "energies", self.folder / "cone"], stdout=full,
                                     stderr=subprocess.PIPE, text=True, check=False)
        self.assertEqual((process.returncode, process.stderr), (5, "plot: 'standard output': No space left on device\n"))

    def test_shown_entry(self):
        history = self.cone.history
        self.assertEqual(shown_entry(self.cone, argparse.Namespace(step=None)), (9, history["force"].max()))
        self.assertEqual(shown_entry(self.cone, argparse.Namespace(step=-2)), (-2, history["force"][-2]))

    def test_evaluate(self):
        curve, picture = self.folder / "curve.csv", self.folder / "both.png"
        with curve.open("w", newline="") as file:
            writer = csv.writer(file)
            writer.writerow(["P", "h"])
            writer.writerows([[1e3 * row["force"], 1e6 * row["depth"]] for row in self.cone.history])
        units = ("--columns", "h", "P", "--factors", 1e-6, 1e-3)
        process = command("evaluate", curve, "--cone", 70.3, *units, "--run", self.folder / "cone", "--output", picture)
        *found, path = process.stdout.splitlines()
        measured, computed = csv.DictReader(found)
        self.assertEqual([measured.pop("curve"), computed.pop("curve")], ["measured", "computed"])
        self.assertEqual(measured, computed)
        self.assertAlmostEqual(float(computed["tip_hardness"]) / self.cone.indentation[0]["tip_hardness"], 1, places=5)
        self.assertEqual(path, str(picture))
        self.assertTrue(picture.read_bytes().startswith(b"\x89PNG"))

        process = command("evaluate", curve, *units, "--run", self.folder / "cone")
        self.assertEqual(process.stdout.splitlines(), found)
        process = command("evaluate", curve, "--cone", 70.3, *units, "--beta", 1.034)
        modulus = float(next(csv.DictReader(process.stdout.splitlines()))["tip_reduced_modulus"])
        self.assertAlmostEqual(float(computed["tip_reduced_modulus"]) / modulus, 1.034, places=4)
        self.expect_message(r"does not say the unit of depth \(column 'h'\) nor of force \(column 'P'\): give it, such as by --unit",
                            "evaluate", curve, "--sphere", 1)
        self.expect_message("no column 'x'; it has P, h", "evaluate", curve, "--sphere", 1, "--columns", "x", "P")
        for option, value, allowed in (
                ("--cone", 90, "> 0 and < 90"), ("--sphere", 0, "> 0"), ("--beta", 0, "> 0"), ("--beta", "inf", "> 0"),
                ("--epsilon", 5, "> 0 and <= 1"), ("--noise", "nan", ">= 0 and < 0.5"), ("--area", "nan", "a number")):
            self.expect_message(f"argument {option}: it is '{value}', but must be .*{allowed}", "evaluate", curve, *units,
                                option, value)
        self.expect_message("where the section of the tip is -", "evaluate", curve, *units, "--area", -24)
        self.expect_message("--indenter is 0 0.3, but must be a modulus > 0", "evaluate", curve, *units, "--cone", 70,
                            "--indenter", 0, 0.3)
        self.expect_message("no value of 'P' above 0", "evaluate", curve, "--columns", "h", "P", "--factors", 1, -1,
                            "--cone", 70)
        self.expect_message("no tip: give it by --cone, ", "evaluate", curve, *units)

    def test_tip_of_run(self):
        for entries, area in (({"Indenter/Type": "cone", "Indenter/Semi-apex angle": "45"}, math.pi / 4),
                              ({"Indenter/Type": "sphere", "Indenter/Radius": "2"}, math.pi * 0.5 * 3.5),
                              ({"Indenter/Type": "paraboloid", "Indenter/Radius": "2"}, math.pi * 2.),
                              ({"Indenter/Type": "pyramid", "Indenter/Number of faces": "4", "Indenter/Face angle": "45",
                                "Indenter/Truncation": "0.5", "Indenter/Rounding radius": "0"}, 4.),
                              ({"Indenter/Type": "pyramid", "Indenter/Number of faces": "4", "Indenter/Face angle": "68",
                                "Indenter/Rounding radius": "5"}, 17.1193499462),
                              ({"Indenter/Type": "area function", "Indenter/Area coefficients": "4, 6"}, 4.)):
            run_of_tip = Results(self.folder)
            run_of_tip.parameters = entries
            self.assertAlmostEqual(tip_of_run(run_of_tip).area(0.5), area)
        run_of_tip.parameters = {"Indenter/Type": "wedge"}
        with self.assertRaisesRegex(UserError, "'wedge', is none of cone, .*: give the tip by --cone"):
            tip_of_run(run_of_tip)
        with self.assertRaisesRegex(UserError, "one of plane strain or stress, whose indenter has no tip"):
            run_to_compare(self.plane_run())

    def plane_run(self):
        folder = self.folder / "plane"
        folder.mkdir()
        (folder / "parameters.prm").write_text("set Dimension = 2\nset Kinematics = plane strain\n")
        return folder

    def write_curve(self, name, rows, factor=1., shift=0.):
        """Depth and force of the cone."""
        path = self.folder / name
        with path.open("w", newline="") as file:
            writer = csv.writer(file)
            writer.writerow(["depth", "force"])
            writer.writerows([[factor * row["depth"] + shift, row["force"]] for row in rows])
        return path

    def test_evaluate_without_unloading(self):
        curve = self.write_curve("whole.csv", self.cone.history)
        loading = self.write_curve("loading.csv", self.cone.history[:10])
        folder = self.folder / "loading"
        folder.mkdir()
        for file in ("parameters.prm", "history.csv", "mesh_changes.csv"):
            shutil.copy(self.folder / "cone" / file, folder)
        lines = (folder / "history.csv").read_text().splitlines(keepends=True)
        for n_steps, words in ((10, "does not fall below 95 % of its largest value, .* as by 'Loading/History = "),
                               (12, "no unloading with three points between 95 and 50 % .* more 'Loading/Number of steps'")):
            (folder / "history.csv").write_text("".join(lines[:1 + n_steps]))
            process = command("evaluate", curve, "--run", folder)
            self.assertEqual([row["curve"] for row in csv.DictReader(process.stdout.splitlines())], ["measured"])
            self.assertEqual(process.returncode, 2)
            self.assertRegex(process.stderr, f"the run in '{folder}' has no unloading")
            self.assertRegex(process.stderr, words)
        process = command("evaluate", loading, "--cone", 70.3)
        self.assertEqual((process.returncode, process.stdout), (2, ""))
        self.assertRegex(process.stderr, "loading.csv' has no unloading: .* the file must hold it, in the order of time")

    def test_zero_point(self):
        def evaluated(*arguments):
            return next(csv.DictReader(command("evaluate", *arguments, "--cone", 70.3).stdout.splitlines()))

        curve = self.write_curve("true.csv", self.cone.history)
        shifted = self.write_curve("shifted.csv", self.cone.history, shift=0.05)
        self.assertEqual(float(evaluated(curve)["zero_point"]), 0.)
        self.expect_message("not counted from the first contact: .* begins at the depth 0.0[45].* --zero-point fit", "evaluate",
                            shifted, "--cone", 70.3)
        given, fitted = (evaluated(shifted, "--zero-point", value) for value in (0.05, "fit"))
        self.assertEqual(float(given["zero_point"]), 0.05)
        self.assertEqual(given["max_depth"], evaluated(curve)["max_depth"])
        self.assertAlmostEqual(float(given["tip_hardness"]) / float(evaluated(curve)["tip_hardness"]), 1., places=4)
        self.assertAlmostEqual(float(fitted["zero_point"]), 0.05, delta=0.002)
        self.assertEqual(float(evaluated(shifted, "--zero-point", 0)["max_depth"]), 0.07)
        self.expect_message("no depth beyond its zero point, 0.5", "evaluate", shifted, "--cone", 70.3, "--zero-point", 0.5)
        unloading = self.write_curve("unloading.csv", self.cone.history[9:])
        self.expect_message("too few points to fit its zero point", "evaluate", unloading, "--cone", 70.3, "--zero-point",
                            "fit")
        turned = self.write_curve("turned.csv", self.cone.history, factor=-1.)
        self.expect_message("no depth beyond its zero point, 0: turn the sign", "evaluate", turned, "--cone", 70.3)

    def test_options_without_effect(self):
        curve = self.write_curve("curve_of_options.csv", self.cone.history)
        self.expect_message("--indenter adds .* to that of a run, and there is no run", "evaluate", curve, "--cone", 70.3,
                            "--indenter", 1141000, 0.07)
        self.expect_message("--columns is 'depth' for both", "evaluate", curve, "--cone", 70.3, "--columns", "depth", "depth")
        self.expect_message("argument --output: it is 'both.gif', but must end with .png, .svg or .pdf", "evaluate", curve,
                            "--cone", 70.3, "--output", "both.gif")
        self.expect_message("contact depth of -.*, but it must be above 0", "evaluate", curve, "--cone", 70.3,
                            "--zero-point", 0.0199)
        cone = self.folder / "cone"
        for arguments, words in ((("energies", cone, "--hertz", "sphere"), "--hertz needs the diagram pressure"),
                                 ((cone, "--hertz", "sphere"), "--hertz needs the diagram pressure and fields"),
                                 (("energies", cone, "--parts", 4, "--normalised"), "--parts needs --hertz, or axes with units"),
                                 (("energies", cone, "--step", 2), "--step needs the diagram pressure"),
                                 (("energies", cone, "--centre", 1), "--centre needs the diagram pressure or imprint"),
                                 (("imprint", cone, "--centre", 1, 2), "--centre has 2 coordinates, but must have at most 1"),
                                 (("energies", cone, "--panels", "a.png", "--format", "svg"), "--format needs files of"),
                                 (("energies", cone, "--panels", "a.png", "--output-directory", "b"), "--output-directory needs"),
                                 (("energies", cone, "--normalised", "--length-unit", "mm"), "--length-unit needs axes"),
                                 (("pressure", cone, "--hertz", "sphere", "--normalised"), "--hertz sphere is for .* which is 'cone'"),
                                 (("imprints", cone, "--step", 0), "--step is of surfaces from above, and none"),
                                 (("imprints", cone, "--extent", 2), "--extent is of surfaces from above, and none"),
                                 (("cost", cone, "--length-unit", "mm"), "unrecognized arguments: --length-unit")):
            self.expect_message(words, "plot", *arguments)
        for arguments, words in ((("--panels", "pressure", "--zoom", 2), "--zoom is of the body"),
                                 (("--panels", "pressure", "--field", "stress"), "--field is of the body"),
                                 (("--animation", "film", "--title", "x"), "it goes not with --title")):
            self.expect_message(words, "render", cone, *arguments)

    def test_diagrams_of_what_is_not_there(self):
        """One message that says what it takes, and no picture."""
        cone, picture = self.folder / "cone", self.folder / "not_there.png"
        for name, words in (("pressure", "'Output/Fields' other than 'never'"), ("convergence", "'Refinement/Number of cycles'"),
                            ("stress_strain", "bodies without indenter"), ("reactions", "bodies without indenter"),
                            ("depth_time", "a material with a 'Rate law'"), ("hardness_rate", "a material with a 'Rate law'")):
            self.expect_message(f"nothing to show for {name}: .*{words}", "plot", name, cone)
        for name, words in (("friction", "is without friction: it takes a 'Contact/Friction coefficient' above 0"),
                            ("bounds", "no error_bound.csv in .*: it takes 'Analysis = contact with error bound'"),
                            ("equilibrium", "neither limit_load.pvd nor equilibrium.pvd"),
                            ("cycles", "turns back less than twice; it takes")):
            self.expect_message(words, "plot", name, cone, "--output", picture)
        self.assertFalse(picture.exists())

    def test_bar_in_one_step(self):
        bar, picture = self.folder / "bar", self.folder / "no_bar.png"
        run("verification/uniaxial_stress.prm", bar, {"Output/Fields": "never"})
        process = command("plot", bar)
        self.assertEqual((process.returncode, process.stdout), (0, ""))
        self.assertRegex(process.stderr, "^plot: the run in '.*' has nothing to show: pressure: it takes an indenter")
        self.expect_message("for energies: it takes several load steps", "plot", "energies", bar)
        self.expect_message("one in the plane: ParaView shows", "plot", "friction", bar, "--output", picture)
        self.expect_message("nothing to show for imprints", "plot", "imprints", bar, "--output", picture)
        curve = self.write_curve("curve_for_bar.csv", self.cone.history)
        self.expect_message("has no indenter", "evaluate", curve, "--cone", 70.3, "--run", bar)
        self.assertFalse(picture.exists())

    def test_run(self):
        """A new folder each time, with tables and pictures; after an error of the program nothing is drawn."""
        changes = [part for path, value in CONE.items() if path != "Output/Fields" for part in ("--set", f"{path}={value}")]
        folder = self.folder / "of_run"
        folder.mkdir()
        for arguments, name in ((changes, "cone_axisymmetric"), ([*changes, "--set", "Output/Fields=never"], "cone_axisymmetric_2")):
            process = run_there(folder, "cone_axisymmetric", 1, *arguments)
            self.assertEqual(process.returncode, 0, process.stderr)
            self.assertIn(f"/of_run/output/{name} (tables: *.csv", process.stdout)
            self.assertTrue((folder / "output" / name / "force_depth.png").exists())
        self.assertTrue((folder / "output/cone_axisymmetric/picture.png").exists())
        self.assertFalse((folder / "output/cone_axisymmetric_2/picture.png").exists())
        for arguments, words in ((["nonsense"], "^run: there is no parameter file 'nonsense'"),
                                 (["cone_axisymmetric", 0], "argument ranks: it is '0', but must be an integer >= 1"),
                                 (["cone_axisymmetric", 1, "--set", "Loading/Depht=1"], "There is no entry 'Loading/Depht'")):
            process = run_there(folder, *arguments)
            self.assertEqual(process.returncode, 2)
            self.assertRegex(process.stderr, words)
        self.assertEqual(len(list((folder / "output").iterdir())), 2)

    def test_missing_module(self):
        """Without 'site', Python does not find what has been installed."""
        process = subprocess.run([sys.executable, "-S", SCRIPTS / "plot.py", "--help"],
                                 capture_output=True, text=True, check=False)
        self.assertEqual(process.returncode, 2)
        # (the whole message in the output of a test that fails would tell CTest to skip it)
        self.assertRegex(process.stderr.partition(" in ")[2], f"^{sys.executable}. The Debian package python3-.* "
                         "for /usr/bin/python3, which runs these commands unless")

    def test_unknown(self):
        for option in ("parts", "shapes", "elements", "space-elements"):
            process = command("contact_law", f"--{option}=-1")
            self.assertEqual(process.returncode, 2)
            self.assertRegex(process.stderr, f"argument --{option}: (it is|there is no) '-1'")
        self.assertEqual(command("verify", "nonsense").returncode, 2)
        self.assertEqual(command("nonsense").returncode, 2)
        for arguments in (["--help"], ["verify", "--help"]):
            self.assertEqual(command(*arguments).returncode, 0)
        # (users have no commands of developers)
        process = subprocess.run([sys.executable, "-m", "elasto_plastic_contact", "verify"],
                                 capture_output=True, text=True, check=False)
        self.assertEqual(process.returncode, 2)
        self.assertRegex(process.stderr, "invalid choice: 'verify'")
        for module in pathlib.Path(elasto_plastic_contact.__file__).parent.rglob("*.py"):
            self.assertNotRegex(module.read_text(encoding="utf-8"), r"(from|import) +\.*tools\b", module)


if __name__ == "__main__":
    unittest.main()
