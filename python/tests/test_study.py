# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Studies: numbers, what is not run again, kills, failures, and messages about wrong files."""

import csv
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import unittest.mock

from elasto_plastic_contact import UserError
from elasto_plastic_contact.__main__ import main
from elasto_plastic_contact.errors import FileError
from elasto_plastic_contact.files import new_file
from elasto_plastic_contact.plots.study import draw
from elasto_plastic_contact.program import build_of
from elasto_plastic_contact.study.execution import curves_of_runs
from elasto_plastic_contact.study.plan import read_study

STRESSES, STRAINS = (300, 400), (0.01, 0.02)
STUDY = {
    "case": "verification/uniaxial_stress.prm",
    "set": {"Loading/Number of steps": 4, "Output/Fields": "never"},
    "vary": {"Material/Yield stress": list(STRESSES),
             "Boundary conditions/Prescribed displacement": [f"top: free; free; {strain}*t" for strain in STRAINS]},
    "at once": 2,
    "numbers": {"stress": {"table": "reactions", "column": "top_z"},
                "first time": {"table": "history", "column": "time", "take": 1},
                "iterations": {"table": "statistics", "column": "newton_iterations", "take": "maximum"},
                "fifth step": {"table": "history", "column": "time", "take": 5}},
}


class Studies(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.output = self.folder / "output"

    def command(self, data):
        path = self.folder / "study.json"
        text = data if isinstance(data, (str, bytes)) else json.dumps(data)
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return ["study", str(path), "--output-directory", str(self.output)]

    def table(self):
        with (self.output / "study.csv").open(newline="") as file:
            return list(csv.DictReader(file))

    def finished(self):
        return {path: path.stat().st_mtime_ns for path in self.output.glob("run_*/finished.json")}

    def test_all_combinations(self):
        self.assertEqual(main(self.command(STUDY)), 0)
        rows = self.table()
        self.assertEqual(len(rows), 4)
        for row, (stress, strain) in zip(rows, [(stress, strain) for stress in STRESSES for strain in STRAINS]):
            self.assertEqual(row["Material/Yield stress"], str(stress))
            self.assertAlmostEqual(float(row["stress"]), (stress + 2000 * strain) / 1.01, places=6)
            self.assertEqual(float(row["first time"]), 0.25)
            self.assertEqual(row["fifth step"], "")
        self.assertTrue((self.output / "study.png").read_bytes().startswith(b"\x89PNG"))

        self.assertFalse((self.output / "curves.png").exists())

        before = self.finished()
        more = {**STUDY, "vary": STUDY["vary"] | {"Material/Yield stress": [300, 500]}}
        self.assertEqual(main(self.command(more)), 0)
        self.assertEqual(len(self.finished()), 6)
        self.assertEqual(before, {path: self.finished()[path] for path in before})

    def test_curves(self):
        study = {**STUDY, "vary": {"Material/Yield stress": [300, 400]},
                 "plot": {"curves": {"table": "reactions", "x": "time", "y": "top_z"}}}
        self.assertEqual(main(self.command(study)), 0)
        self.assertTrue((self.output / "curves.png").read_bytes().startswith(b"\x89PNG"))
        for run, (time_of_step, force) in curves_of_runs(read_study(self.command(study)[1]), self.output):
            self.assertEqual(time_of_step, [0.25, 0.5, 0.75, 1])
            self.assertAlmostEqual(force[-1], (run["Material/Yield stress"] + 2000 * 0.02) / 1.01, places=6)

    def test_kill(self):
        runs = [{"Material/Yield stress": stress} for stress in range(300, 304)]
        study = {**STUDY, "at once": 1, "runs": runs}
        del study["vary"]
        process = subprocess.Popen([sys.executable, "-m", "elasto_plastic_contact", *self.command(study)],
                                   stdout=subprocess.DEVNULL)
        while process.poll() is None and not self.finished():
            time.sleep(0.005)
        process.send_signal(signal.SIGKILL)
        process.wait()
        before = self.finished()
        self.assertTrue(0 < len(before) < len(runs))
        self.assertFalse((self.output / "study.csv").exists())
        self.assertEqual(main(self.command(study)), 0)
        self.assertEqual(before, {path: self.finished()[path] for path in before})
        self.assertEqual([float(row["Material/Yield stress"]) for row in self.table()], list(range(300, 304)))

    def test_failure(self):
        """One of two runs finds no solution: the other one is there, the exit status says it."""
        study = {**STUDY, "vary": {"Nonlinear solver/Maximum number of iterations": [1, 50]},
                 "set": {"Loading/Maximum number of cuts": 0, "Output/Fields": "never"}}
        self.assertEqual(main(self.command(study)), 1)
        self.assertEqual([row["stress"] != "" for row in self.table()], [False, True])

    def test_refused_by_the_program(self):
        """Before anything is run."""
        study = {**STUDY, "vary": {"Material/Poisson's ratio": [0.3, 0.7]}}
        process = subprocess.run([sys.executable, "-m", "elasto_plastic_contact", *self.command(study)],
                                 capture_output=True, text=True, check=False)
        self.assertEqual(process.returncode, 2)
        self.assertRegex(process.stderr,
                         "(?s)the run with Material/Poisson's ratio = 0.7 is refused: .*Poisson's ratio")
        self.assertEqual(self.finished(), {})

    def test_names_of_folders(self):
        """Others for another entry in an included file, and for a program built anew, also with the same version;
        not for a comment."""
        included, case = self.folder / "steel.txt", self.folder / "case.prm"
        case.write_text("subsection Material\n  include steel.txt\nend\n")
        program = self.folder / "program"

        def name(stress, build):
            included.write_text(f"set Yield stress = {stress}")
            program.write_text(f"#!/bin/sh\necho 0.3.0\n# {build}\n")
            program.chmod(0o755)
            study = read_study(self.command({**STUDY, "case": str(case)})[1], str(program))
            return study.folder(study.runs[0])

        names = [name(stress, build) for stress, build in ((300, "one"), (300, "another"), (400, "one"),
                                                           ("300  # MPa", "one"))]
        self.assertEqual(len(set(names[:3])), 3)
        self.assertEqual(names[3], names[0])

    def test_build_with_a_library(self):
        """A program as a package has it, whose parts are in a library; 'ldd' says which."""
        bin_folder, library = self.folder / "bin", self.folder / "libelasto_plastic_contact_parts.so"
        bin_folder.mkdir()
        for name, text in (("ldd", f"echo 'libm.so.6 => /lib/libm.so.6 (0x1)'\n"
                                   f"echo ' {library.name} => {library} (0x2)'\n"), ("program", "")):
            (bin_folder / name).write_text(f"#!/bin/sh\n{text}")
            (bin_folder / name).chmod(0o755)
        path, program = f"{bin_folder}:{os.environ['PATH']}", bin_folder / "program"
        builds = []
        for text in ("one", "another", "one"):
            library.write_text(text)
            with unittest.mock.patch.dict(os.environ, PATH=path):
                builds.append(build_of(program))
        self.assertNotEqual(builds[0], builds[1])
        self.assertEqual(builds[0], builds[2])
        self.assertNotIn(build_of(program), builds)
        self.assertEqual(build_of(self.folder / "none"), "")

    def test_folder_of_others(self):
        self.output.mkdir()
        (self.output / "thesis.tex").touch()
        self.assertEqual(main(self.command(STUDY)), 2)
        self.assertEqual([path.name for path in self.output.iterdir()], ["thesis.tex"])

    def test_wrong_files(self):
        number = STUDY["numbers"]["stress"]
        for data, message in (
                ("{\"case\" 1}", "line 1, column 9: this is no JSON"),
                ("{\"case\": 1, \"case\": 2}", "'case' stands twice in one object"),
                ([], r"the study is \[\], but must be an object"),
                ({**STUDY, "varry": {}}, "a key of the study: there is no \"varry\". Did you mean 'vary'"),
                ({"case": "a.prm", "vary": {}}, "the study lacks 'numbers'"),
                ({**STUDY, "runs": []}, "either 'vary' .* or 'runs'"),
                ({**STUDY, "case": "nothing.prm"}, "no parameter file 'nothing.prm'"),
                ({**STUDY, "case": 3}, "'case' is 3, but must be the name of a parameter file"),
                ({**STUDY, "vary": {"Material/Yield": [1]}},
                 "vary: there is no entry 'Material/Yield'. Did you mean 'Material/Yield stress'"),
                ({**STUDY, "vary": {"Material/Yield stress": 1}},
                 "'vary/Material/Yield stress' is 1, but must be a list"),
                ({**STUDY, "vary": {"Material/Yield stress": [None]}},
                 "'vary/Material/Yield stress' is null, but must be a text"),
                ({**STUDY, "vary": {"Output/Fields": ["never"]}}, "'Output/Fields' stands in 'set' and is varied"),
                ({**STUDY, "vary": {"Material/Yield stress": [3, 4, 3]}}, "two runs are the same: .*Yield stress\": 3"),
                ({**STUDY, "at once": 0}, "'at once' is 0, but must be an integer >= 1"),
                ({**STUDY, "ranks": True}, "'ranks' is true, but must be an integer >= 1"),
                ({**STUDY, "numbers": {"n": {**number, "take": "biggest"}}},
                 "'numbers/n/take' is \"biggest\", but must be one of last, first"),
                ({**STUDY, "numbers": {"n": {"table": "history"}}}, "numbers/n lacks 'column'"),
                ({**STUDY, "numbers": {"n": {**number, "table": "histry"}}},
                 "numbers/n/table: there is no \"histry\". Did you mean 'history'. Allowed: history, .*, probes"),
                ({**STUDY, "numbers": {"n": {"table": "history", "column": "fource"}}},
                 "numbers/n/column: there is no \"fource\". Did you mean 'force'. Allowed: step, time, depth, force"),
                ({**STUDY, "plot": {"curves": {"table": "history", "x": "depth", "y": "fource"}}},
                 "plot/curves/y: there is no \"fource\". Did you mean 'force'"),
                ("\u00fc{}".encode("utf-16"), "is in UTF-16, which some editors call Unicode.*as UTF-8"),
                ("{\"\u00fc\": 1}".encode("latin-1"), "is not in UTF-8: invalid .* at byte 3"),
                ({**STUDY, "set": {}, "vary": {path: list(range(3000)) for path in (
                    "Material/Yield stress", "Loading/Depth", "Loading/Number of steps")}},
                 "'vary' makes 27000000000 runs, but at most 100000 are allowed"),
                ({**STUDY, "numbers": {"Material/Yield stress": number}},
                 "'numbers/Material/Yield stress' has the name of another column of study.csv"),
                ({**STUDY, "numbers": {"run": number}}, "'numbers/run' has the name of another column"),
                ({**STUDY, "vary": {"Material/Law": ["\0"]}}, r"the text \"\\u0000\" holds a character that is not allowed"),
                ("[" * 100000, "brackets are nested too deep"),
                ("9" * 5000, "Exceeds the limit"),
                ({**STUDY, "plot": {"y": ["force"]}}, "plot/y: there is no \"force\". Allowed: stress"),
                ({**STUDY, "plot": {"curves": {"x": "time", "y": "top_z"}}}, "plot/curves lacks 'table'"),
                ({**STUDY, "plot": {"curves": {"table": "reactions", "x": 1, "y": "top_z"}}},
                 "'plot/curves/x' is 1, but must be the name of a column"),
        ):
            with self.assertRaisesRegex(UserError, message):
                read_study(self.command(data)[1])
        table = {key: value for key, value in STUDY.items() if key != "vary"}
        with self.assertRaisesRegex(UserError, "runs/2 has other entries than the first one: Material/Law"):
            read_study(self.command({**table, "runs": [{"Dimension": 3}, {"Dimension": 3, "Material/Law": "x"}]})[1])

    def test_plot(self):
        """Values of different types, of which each line of the plot knows some only."""
        study = read_study(self.command({**STUDY, "vary": {"Material/Yield stress": [5, 6, [1, 2], "7"],
                                                           "Material/Law": ["a", "b"]}})[1])
        rows = [{**run, **dict.fromkeys(study.numbers, i if (run["Material/Law"] == "b") == (i < 4) else None)}
                for i, run in enumerate(study.runs)]
        draw(study, rows, self.folder / "study.png")
        self.assertTrue((self.folder / "study.png").read_bytes().startswith(b"\x89PNG"))
        study.x = "$\\wrong$"
        with self.assertRaisesRegex(UserError, "study.png' cannot be drawn: .*wrong"):
            draw(study, [{**row, study.x: 1.} for row in rows], self.folder / "study.png")

    def test_full_disk(self):
        """/dev/full stands for one."""
        with self.assertRaisesRegex(FileError, "table' cannot be written: No space left on device") as failure:
            with new_file(self.folder / "table") as file:
                os.dup2(os.open("/dev/full", os.O_WRONLY), file.fileno())
                file.write("text")
        self.assertEqual(failure.exception.status, 5)
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_wrong_column(self):
        """One that only a run can tell, as it has the name of a boundary, ends the study after the first of them."""
        study = {**STUDY, "at once": 1, "numbers": {"n": {"table": "reactions", "column": "topp_z"}}}
        process = subprocess.run([sys.executable, "-m", "elasto_plastic_contact", *self.command(study)],
                                 capture_output=True, text=True, check=False)
        self.assertEqual(process.returncode, 2)
        self.assertRegex(process.stderr, "'numbers/n/column': the table 'reactions' has no column 'topp_z'; it has step, ")
        self.assertLess(len(self.finished()), len(STRESSES) * len(STRAINS))


if __name__ == "__main__":
    unittest.main()
