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

from elasto_plastic_contact import Results, UserError, run
from elasto_plastic_contact.evaluate import tip_of_run
from elasto_plastic_contact.plots.equilibrium import last_slip_lines
from elasto_plastic_contact.plots.quantities import shown_entry

SCRIPTS = pathlib.Path(__file__).resolve().parents[2] / "scripts"
CONE = {"Geometry/Local refinements": 5, "Geometry/Local radius": 4, "Refinement/Elements over contact radius": 0,
        "Loading/History": "1: depth 0.02 | 2: force 0", "Loading/Number of steps": 20,
        "Output/Fields": "never"}


def command(name, *arguments):
    return subprocess.run([sys.executable, SCRIPTS / f"{name}.py", *map(str, arguments)],
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
        self.expect_message("cannot be written", "plot", self.folder / "cone", "--output-directory", "/nowhere", status=5)
        for step in (999, -21):
            self.expect_message(f"there is no step {step} in '.*history.csv': it has 20, counted from 0, or from -1 backwards",
                                "plot", self.folder / "cone", "--step", step)
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
        self.expect_message("no column 'depth'; it has P, h", "evaluate", curve, "--sphere", 1)
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
        self.expect_message("no tip: give it by --cone, ", "evaluate", curve)

    def test_tip_of_run(self):
        for entries, area in (({"Indenter/Type": "cone", "Indenter/Semi-apex angle": "45"}, math.pi / 4),
                              ({"Indenter/Type": "sphere", "Indenter/Radius": "2"}, math.pi * 0.5 * 3.5),
                              ({"Indenter/Type": "paraboloid", "Indenter/Radius": "2"}, math.pi * 2.),
                              ({"Indenter/Type": "pyramid", "Indenter/Number of faces": "4", "Indenter/Face angle": "45",
                                "Indenter/Truncation": "0.5", "Indenter/Rounding radius": "0"}, 4.),
                              ({"Indenter/Type": "area function", "Indenter/Area coefficients": "4, 6"}, 4.)):
            run_of_tip = Results(self.folder)
            run_of_tip.parameters = entries
            self.assertAlmostEqual(tip_of_run(run_of_tip).area(0.5), area)
        run_of_tip.parameters = {"Indenter/Type": "wedge"}
        with self.assertRaisesRegex(UserError, "'wedge', is none of cone, .*: give the tip by --cone"):
            tip_of_run(run_of_tip)
        run_of_tip.parameters = {"Indenter/Type": "pyramid", "Indenter/Rounding radius": "0.1"}
        with self.assertRaisesRegex(UserError, "'pyramid', is none of .* sharp or truncated pyramid"):
            tip_of_run(run_of_tip)
        run_of_tip.parameters = {"Dimension": "2", "Kinematics": "plane strain", "Indenter/Type": "cone"}
        with self.assertRaisesRegex(UserError, "one of plane strain or stress, whose indenter has no tip"):
            tip_of_run(run_of_tip)

    def test_missing_module(self):
        """Without 'site', Python does not find what has been installed."""
        process = subprocess.run([sys.executable, "-S", SCRIPTS / "plot.py", "--help"],
                                 capture_output=True, text=True, check=False)
        self.assertEqual(process.returncode, 2)
        # (the whole message in the output of a test that fails would tell CTest to skip it)
        self.assertRegex(process.stderr.partition(" in ")[2], f"^{sys.executable}. The Debian package python3-.* "
                         "for /usr/bin/python3, which runs the commands of scripts/ unless")

    def test_unknown(self):
        for option in ("parts", "shapes", "elements", "space-elements"):
            process = command("command", "contact_law", f"--{option}=-1")
            self.assertEqual(process.returncode, 2)
            self.assertRegex(process.stderr, f"argument --{option}: (it is|there is no) '-1'")
        self.assertEqual(command("verify", "nonsense").returncode, 2)
        self.assertEqual(command("command", "nonsense").returncode, 2)
        self.assertEqual(command("command", "--help").returncode, 0)


if __name__ == "__main__":
    unittest.main()
