# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ready cases by their names: in this checkout, and where program, package and cases are installed."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import elasto_plastic_contact
from elasto_plastic_contact import UserError
from elasto_plastic_contact.program import (INSTALLED_CASES, MPI_ENVIRONMENT, cases_folder, checkout, find_case,
                                            find_program, ready_case)


class InCheckout(unittest.TestCase):
    def test_names(self):
        case = checkout() / "parameter_files/indentation/cone_axisymmetric.prm"
        for name in ("indentation/cone_axisymmetric.prm", "indentation/cone_axisymmetric", "cone_axisymmetric"):
            self.assertEqual(find_case(name), case)
        self.assertEqual(find_case(case.with_suffix("")), case)
        self.assertEqual(ready_case("sphere_3d"), checkout() / "parameter_files/sphere_3d.prm")
        with self.assertRaisesRegex(UserError, "'strip_punch' fits several ready cases: 'limit_load/strip_punch.prm', 'veri"):
            ready_case("strip_punch")
        with self.assertRaisesRegex(UserError, "no parameter file '../README', and no ready case '../README' in '/.* --list-cases"):
            find_case("../README")
        with self.assertRaisesRegex(UserError, "no ready case 'indentation/kone_axi.* Did you mean 'indentation/cone_axi"):
            find_case("indentation/kone_axisymmetric")

    def test_first_lines(self):
        for file in cases_folder().rglob("*.prm"):
            self.assertRegex(file.read_text(encoding="utf-8"), r"^# [^\n]+[^.]\.\n#?\n", file)

    def test_places(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "sphere_3d.prm")
            file.touch()
            self.assertEqual(find_case("sphere_3d", (folder,)), file)
            self.assertEqual(find_case("sphere_3d.prm", ("nowhere", folder)), file)


class Installed(unittest.TestCase):
    """As a package lays them out, with nothing of the checkout."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.prefix = pathlib.Path(folder.name, "usr").resolve()
        self.package = self.prefix / "lib/python3/dist-packages"
        self.program = self.prefix / "bin/elasto_plastic_contact"
        self.program.parent.mkdir(parents=True)
        shutil.copy(find_program(), self.program)
        shutil.copytree(pathlib.Path(elasto_plastic_contact.__file__).parent, self.package / "elasto_plastic_contact",
                        ignore=shutil.ignore_patterns("__pycache__"))
        shutil.copytree(cases_folder() / "material", self.prefix / INSTALLED_CASES / "material")
        self.home = pathlib.Path(folder.name, "home")
        self.home.mkdir()

    def python(self, text):
        environment = os.environ | {"PYTHONPATH": str(self.package), "PYTHONDONTWRITEBYTECODE": "1",
                                    "ELASTO_PLASTIC_CONTACT": ""}
        return subprocess.run([sys.executable, "-c", text], capture_output=True, text=True, check=False, cwd=self.home,
                              env=environment)

    def start(self, *arguments):
        return subprocess.run([self.program, *arguments], capture_output=True, text=True, check=False, cwd=self.home,
                              env=os.environ | MPI_ENVIRONMENT)

    def test_package_finds_program(self):
        found = self.python("from elasto_plastic_contact.program import find_program; print(find_program())")
        self.assertEqual(found.stdout, f"{self.program}\n", found.stderr)

    def test_package_finds_cases(self):
        found = self.python("from elasto_plastic_contact.program import find_case; print(find_case('voce'))")
        self.assertEqual(found.stdout, f"{self.prefix / INSTALLED_CASES / 'material/voce.prm'}\n", found.stderr)

    def test_package_is_no_checkout(self):
        ended = self.python("from elasto_plastic_contact.program import checkout; checkout()")
        self.assertRegex(ended.stderr, f"works in a checkout of ElastoPlasticContact only .* '{self.package}/elasto_")

    def test_no_cases(self):
        shutil.rmtree(self.prefix / INSTALLED_CASES)
        found = self.python("from elasto_plastic_contact.program import find_case; find_case('voce')")
        self.assertRegex(found.stderr, f"there are no ready cases: they would be in '{self.prefix}/share/")

    def test_list(self):
        lines = self.start("--list-cases").stdout.splitlines()
        self.assertEqual(len(lines), len(list((cases_folder() / "material").iterdir())))
        self.assertEqual(lines, sorted(lines))
        self.assertRegex(lines[-1], "^material/voce.prm  +Tension of a bar whose hardening saturates .*unloading$")

    def test_results_are_in_the_current_folder(self):
        cases = self.prefix / INSTALLED_CASES
        before = sorted(self.prefix.rglob("*"))
        for path in (cases / "material", cases):
            path.chmod(0o555)
            self.addCleanup(path.chmod, 0o755)
        ended = self.start("voce", "--set", "Loading/Number of steps=2", "--set", "Geometry/Initial refinements=0")
        self.assertEqual(ended.returncode, 0, ended.stderr)
        self.assertEqual(ended.stdout.splitlines()[0], f"Parameter file: {cases / 'material/voce.prm'}")
        self.assertTrue((self.home / "output/voce/history.csv").exists())
        self.assertEqual(sorted(self.prefix.rglob("*")), before)

    def test_file_of_current_folder_comes_first(self):
        (self.home / "voce.prm").write_text("set Dimension = 7\n")
        for name in ("voce", "voce.prm"):
            self.assertRegex(self.start(name).stderr, "^Error: voce.prm, line 1: .*'Dimension' is '7'")


if __name__ == "__main__":
    unittest.main()
