# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""epc new as it is typed: what it writes and says, measured surfaces, what it asks for; messages."""

import contextlib
import io
import math
import os
import pathlib
import pty
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

from elasto_plastic_contact.__main__ import main
from tools.inputs.height_maps import write_pgm
from elasto_plastic_contact.program import PROGRAM_VARIABLE, find_program

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "scripts/command.py"

SOFT = ("--young-modulus", "1 GPa", "--yield-stress", "6 MPa")


def command(folder, *arguments):
    return subprocess.run([sys.executable, SCRIPT, "new", *map(str, arguments)], cwd=folder, capture_output=True,
                          text=True,
                          stdin=subprocess.DEVNULL, check=False)


class Command(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def expect_message(self, pattern, *arguments):
        process = command(self.folder, *arguments)
        self.assertEqual(process.returncode, 2, process.stderr)
        self.assertRegex(process.stderr.splitlines()[-1], f"^new: .*{pattern}")

    def ending_of(self, arguments):
        """The exit status and the last line on standard error, in this process, where nobody could be asked."""
        errors = io.StringIO()
        before = os.getcwd()
        os.chdir(self.folder)
        try:
            with contextlib.redirect_stderr(errors), open(os.devnull) as nobody, unittest.mock.patch("sys.stdin",
                                                                                                     nobody):
                status = main(["new", *arguments])
        except SystemExit as ending:
            status = ending.code
        finally:
            os.chdir(before)
        return status, errors.getvalue().splitlines()[-1]

    def test_writes_and_says_what(self):
        # (the time is that of a run by this process, and a program loaded once is no child of it)
        program = os.environ.get("LOADED_ONCE_PROGRAM", find_program())
        with unittest.mock.patch.dict(os.environ, {PROGRAM_VARIABLE: program}):
            process = command(self.folder, "material-test", "--material", "copper", "--output", "bar.prm")
        self.assertEqual((process.returncode, process.stderr), (0, ""))
        self.assertRegex(process.stdout, r"(?s)Strain +finite.*Units +mm, N, MPa\nTime +about [0-9]+ s of one.*File "
                                         r"+bar.prm\nRun +epc run bar.prm\n")
        self.assertIn("set Directory    = output/bar\n", (self.folder / "bar.prm").read_text(encoding="utf-8"))

    def test_replaces_nothing_silently(self):
        (self.folder / "cone.prm").write_text("mine")
        arguments = ("cone", "--material", "steel", "--depth", "1 um")
        self.expect_message("'cone.prm' exists: choose another --output, or replace it by --overwrite", *arguments)
        self.assertEqual((self.folder / "cone.prm").read_text(), "mine")
        self.assertEqual(command(self.folder, *arguments, "--overwrite").returncode, 0)
        (self.folder / "rough_heights.txt").write_text("mine")
        self.expect_message("'rough_heights.txt' exists", "rough", "--material", "steel", "--rms", "1 um", "--size",
                            "20 um")

    def surface(self, name, *others, size="20 um"):
        """The arguments for a measured surface."""
        return ("rough", "--material", "steel", "--surface", name, "--size", size, "--mesh", "coarse", *others)

    def test_measured_surface(self):
        """A matrix of heights and an image, of which the file names the place as seen from its own folder."""
        rows = [[math.sin(0.3 * i) * math.cos(0.2 * j) for j in range(40)] for i in range(40)]
        (self.folder / "heights.txt").write_text("\n".join(" ".join(f"{250 * h:.1f}" for h in row) for row in rows))
        write_pgm(self.folder / "heights.pgm", rows)
        (self.folder / "cases").mkdir()
        for name, kind, scale, factor in (("heights.txt", "height matrix", "1 nm", "0.001"),
                                          ("heights.pgm", "image", "500 nm", "0.5")):
            path = self.folder / f"cases/{kind[:5]}.prm"
            process = command(self.folder, *self.surface(name, "--height-scale", scale, "--depth", "300 nm", "--output",
                                                         path.relative_to(self.folder)))
            self.assertEqual(process.returncode, 0, process.stderr)
            text = path.read_text(encoding="utf-8")
            for words in (f"Type +.*= {kind}", f"File +.*= ../{name}", f"Height scale +.*= {factor} ",
                          "Side down +.*= light"):
                self.assertRegex(text, words)

    def test_messages_on_surfaces(self):
        (self.folder / "heights.txt").write_text("1 2 3 4 5\n2 3 four 5 6\n")
        (self.folder / "map#1.txt").write_text("1 2\n2 3\n")
        scale, depth = ("--height-scale", "1 nm"), ("--depth", "1 um")
        for pattern, *arguments in (
                ("--surface is 'nowhere.txt', which cannot be read: No such file",
                 *self.surface("nowhere.txt", *scale, *depth)),
                ("--surface is '.', which cannot be read: Is a directory", *self.surface(".", *scale, *depth)),
                ("the program refuses the file, perhaps for the surface 'heights.txt': .*number 3 in line 2 is not a",
                 *self.surface("heights.txt", *scale, *depth)),
                ("--surface is 'map#1.txt' as the file sees it, and '#' begins a comment there: give it another name",
                 *self.surface("map#1.txt", *scale, *depth)),
                ("--surface needs --height-scale '1 nm', the height of the number 1",
                 *self.surface("heights.txt", *depth)),
                ("--surface needs --depth '500 nm'", *self.surface("heights.txt", *scale)),
                ("--seed is that of a random surface", *self.surface("heights.txt", *scale, *depth, "--seed", "3")),
                ("--rms and --surface are given, but only one of them can be the surface",
                 *self.surface("heights.txt", *scale, *depth, "--rms", "1 um")),
                ("--height-scale is that of a measured surface", "rough", "--material", "steel", "--rms", "1 um",
                 "--size", "20 um", *scale)):
            with self.subTest(pattern):
                status, line = self.ending_of(arguments)
                self.assertEqual(status, 2)
                self.assertRegex(line, f"^new: .*{pattern}")
        self.assertFalse((self.folder / "rough.prm").exists())

    def test_without_a_program(self):
        process = command(self.folder, "cone", "--material", "steel", "--depth", "1 um", "--program", "/nowhere")
        self.assertEqual(process.returncode, 0, process.stderr)
        self.assertRegex(process.stdout,
                         "Time +not estimated, and the file not checked: there is no program '/nowhere'")

    def test_list_of_materials(self):
        process = command(self.folder, "--list-materials")
        self.assertRegex(process.stdout, r"steel-4340: AISI 4340.*\n    E = 212 GPa, nu = 0.293 \(Dowling 2012, table "
                                         r"5.2.*\n.*Johnson and Cook 1983")

    def test_asks_on_a_terminal_only(self):
        self.expect_message("'cone' needs --material \"steel\", --depth \"500 nm\" \\(or --force\\)", "cone")
        screen, terminal = pty.openpty()
        with subprocess.Popen([sys.executable, SCRIPT, "new", "cone", "--depth", "1 um", "--program", "/nowhere"],
                              cwd=self.folder,
                              stdin=terminal, stdout=terminal, stderr=terminal) as process:
            os.close(terminal)
            os.write(screen, b"steel\n")
            self.assertEqual(process.wait(timeout=60), 0)
        self.assertIn(b"The material, one of --list-materials, such as steel: ", os.read(screen, 4096))
        os.close(screen)
        self.assertIn("low-carbon steel", (self.folder / "cone.prm").read_text(encoding="utf-8"))

    def test_messages(self):
        cone_of = ("cone", "--material", "steel")
        for pattern, *arguments in (
                ("give a KIND: brinell, rockwell-ball",),
                ("argument KIND: there is no 'knoop'; there are brinell", "knoop"),
                ("there is no material 'Stel' in the library. Did you mean 'steel'\\? .*--list-materials", "cone",
                 "--material", "Stel", "--depth", "1 um"),
                ("--depth is '500', but must be a number with a unit, such as '500 nm'. Units of length are pm",
                 *cone_of, "--depth", "500"),
                ("--depth is '0 nm', but must be above 0", *cone_of, "--depth", "0 nm"),
                ("--force is '1 nm', but must be a number with a unit, such as '10 mN'", *cone_of, "--force", "1 nm"),
                ("--depth and --force are given, but only one", *cone_of, "--depth", "1 um", "--force", "1 mN"),
                ("--film has no effect for 'berkovich', which takes --depth, --force, --tip-radius", "berkovich",
                 "--material", "steel", "--depth", "1 um", "--film", "1 um, 3 GPa"),
                ("--film is '1 um', but must be thickness and Young's modulus", "coating", "--material", "steel",
                 "--depth", "1 um", "--film", "1 um"),
                ("there is no material 'gold'", "coating", "--material", "steel", "--depth", "1 um", "--film",
                 "1 um, gold"),
                ("--angle is '95', but must be a number above 20 and below 90", *cone_of, "--depth", "1 um", "--angle",
                 "95"),
                ("--friction, unless it is 'stick', is 'x', but must be a number above 0 and below 2", *cone_of,
                 "--depth", "1 um", "--friction", "x"),
                ("--friction is 'stick', with which no tip is drawn along a surface", "scratch", "--material", "steel",
                 "--tip-radius", "1 um", "--depth", "100 nm", "--friction", "stick"),
                ("--poisson-ratio is '0.5', but must be a number above -1 and below 0.5", *cone_of, "--depth", "1 um",
                 "--poisson-ratio", "0.5"),
                ("--hardening is 'Swift 3', but must be 'none', 'linear 2 GPa', 'power 0.1', 'Ludwik", *cone_of,
                 "--depth", "1 um", "--hardening", "Swift 3"),
                ("--hardening is '-2 GPa', but must be at least 0", *cone_of, "--depth", "1 um", "--hardening",
                 "linear -2 GPa"),
                ("--hardening says how a yield stress grows, and there is none", "cone", "--young-modulus", "3 GPa",
                 "--depth", "1 um", "--hardening", "power 0.1"),
                ("--scale is 'C', but must be one of B, E, F, G, H, K", "rockwell-ball", "--material", "steel",
                 "--scale", "C"),
                ("--cycles is '0', but must be a whole number from 1", "material-test", "--material", "steel",
                 "--cycles", "0"),
                ("'tungsten' has no yield stress, .* give --yield-stress", "limit-load", "--material", "tungsten",
                 "--half-width", "1 mm"),
                ("--depth is too large for this ball", "sphere", "--material", "copper", "--tip-radius", "1 um",
                 "--depth", "2 um"),
                ("--force is too large for this ball", "brinell", "--material", "copper", "--force", "300 kN"),
                ("the force of the scale B is too large for this ball", "rockwell-ball", *SOFT),
                ("the standard force is too large for this ball", "brinell", "--material", "copper", "--film",
                 "1 mm, 10 MPa, 100 kPa"),
                ("no force of ISO 6506-1 leaves an imprint within 0.6 diameters of the ball in your material: the "
                 "least one is 980.665 N, and [0-9]+ N are enough. Give --force", "brinell", *SOFT),
                ("--film is 0.002 mm thick, and the radius of the contact about 2.6. mm: 5[0-9]+ cells would lie over "
                 "it, where at most 400 are allowed. Leave --film out", "brinell", "--material", "steel", "--film",
                 "2 um, 400 GPa"),
                *(("--ball has neither --angle nor --tip-radius", "coating", "--material", "steel", "--film",
                   "2 um, 400 GPa", "--depth", "300 nm", "--ball", "1 mm", *other)
                  for other in (("--angle", "70"), ("--tip-radius", "1 um"))),
                ("'nowhere/cone.prm' cannot be written", *cone_of, "--depth", "1 um", "--output", "nowhere/cone.prm")):
            with self.subTest(pattern):
                status, message = self.ending_of(arguments)
                self.assertRegex(message, f"^new: .*{pattern}")
                self.assertEqual(status, 5 if "written" in pattern else 2)
        self.assertEqual(list(self.folder.iterdir()), [])


if __name__ == "__main__":
    unittest.main()
