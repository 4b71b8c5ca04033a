# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""epc new: a file of each kind that the program accepts, the same when made again; materials, units, expected
contacts; messages."""

import contextlib
import io
import math
import os
import pathlib
import pty
import re
import subprocess
import sys
import tempfile
import unittest
import unittest.mock
from dataclasses import replace

from elasto_plastic_contact import UserError
from elasto_plastic_contact.__main__ import main
from elasto_plastic_contact.inputs.height_maps import write_pgm
from elasto_plastic_contact.new_case.contact import Tip, cone, depth_at, expected_radius, force_at
from elasto_plastic_contact.new_case.duration import check_file, expected_seconds, unknowns_and_steps
from elasto_plastic_contact.new_case.hardening import TABULATED, Ludwik, Perfect, PowerLaw, read_hardening
from elasto_plastic_contact.new_case.kinds import KINDS, make_case, read_given
from elasto_plastic_contact.new_case.materials import Material, chosen_material, library
from elasto_plastic_contact.new_case.revolution import brinell_force, newtons
from elasto_plastic_contact.new_case.units import MICROMETRES, MILLIMETRES, NANOMETRES, quantity, units_for
from elasto_plastic_contact.program import PROGRAM_VARIABLE, find_program

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "scripts/command.py"

SOFT = ("--young-modulus", "1 GPa", "--yield-stress", "6 MPa")

# What makes a case of each kind.
EXAMPLES = {
    "brinell": {"material": "steel-4340"},
    "rockwell-ball": {"material": "steel", "scale": "F"},
    "sphere": {"material": "copper", "tip_radius": "10 um", "depth": "100 nm"},
    "berkovich": {"material": "aluminium-6061", "depth": "500 nm", "tip_radius": "50 nm"},
    "vickers": {"material": "brass", "force": "1 kgf"},
    "cube-corner": {"material": "fused-silica", "depth": "500 nm", "tip_radius": "50 nm"},
    "cone": {"material": "aluminium-7075", "depth": "10 um", "angle": "70"},
    "scratch": {"material": "polycarbonate", "tip_radius": "100 um", "depth": "5 um", "friction": "0.1"},
    "coating": {"material": "steel", "film": "2 um, 400 GPa", "depth": "300 nm"},
    "rough": {"material": "iron", "rms": "100 nm", "size": "20 um"},
    "material-test": {"young_modulus": "210 GPa", "yield_stress": "400 MPa", "hardening": "Voce 250 MPa, 15",
                      "cycles": "2"},
    "limit-load": {"material": "titanium", "half_width": "1 mm"},
}


def case_of(kind, mesh="usual", **changes):
    return make_case(kind, read_given(kind, EXAMPLES[kind] | changes, mesh))


def command(folder, *arguments):
    return subprocess.run([sys.executable, SCRIPT, "new", *map(str, arguments)], cwd=folder, capture_output=True,
                          text=True,
                          stdin=subprocess.DEVNULL, check=False)


class Kinds(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_all_have_an_example(self):
        self.assertEqual(set(EXAMPLES), set(KINDS))

    def test_the_program_accepts_each_without_a_warning(self):
        for kind in EXAMPLES:
            for mesh in ("coarse", "usual"):
                case = case_of(kind, mesh)
                path = self.folder / "case.prm"
                path.write_text(case.text().replace("{stem}", "case"), encoding="utf-8")
                for name, text in case.files.items():
                    (self.folder / name.format(stem="case")).write_text(text, encoding="utf-8")
                report, warnings = check_file(find_program(), str(path))
                self.assertEqual(warnings, "", f"{kind}, {mesh}")
                self.assertGreater(expected_seconds(case.kind_of_time, report, 1.), 0., kind)

    def test_the_same_file_again(self):
        for kind in EXAMPLES:
            self.assertEqual((case_of(kind).text(), case_of(kind).files), (case_of(kind).text(), case_of(kind).files))

    def test_head_of_the_file(self):
        for kind in EXAMPLES:
            lines = case_of(kind).text().splitlines()
            self.assertRegex(lines[0], r"^# [^\n]+[^.]\.$")
            self.assertIn(f"# Units: {case_of(kind).units}.", lines)

    def test_finer_meshes_have_more_cells(self):
        """One kind of each sort of mesh; of a limit load, meshes follow one another."""
        for kind in ("cone", "berkovich", "scratch", "rough"):
            unknowns = []
            for mesh in ("coarse", "usual"):
                case = case_of(kind, mesh)
                path = self.folder / "case.prm"
                path.write_text(case.text().replace("{stem}", "case"), encoding="utf-8")
                for name, text in case.files.items():
                    (self.folder / name.format(stem="case")).write_text(text, encoding="utf-8")
                unknowns.append(unknowns_and_steps(check_file(find_program(), str(path))[0])[0])
            self.assertGreater(unknowns[1], 1.8 * unknowns[0], kind)

    def test_film_ends_at_a_line_of_the_mesh(self):
        for film, depth in (("2 um", "300 nm"), ("100 nm", "300 nm"), ("37.3 nm", "1 um"), ("5 um", "50 nm")):
            entries = {name: value for rows in case_of("coating", film=f"{film}, 400 GPa",
                                                       depth=depth).sections.values()
                       for name, value, _ in rows}
            width = float(entries["Upper corner"].partition(",")[0])
            cell = width / 2 ** (int(entries["Initial refinements"]) + int(entries["Local refinements"]))
            thickness = float(re.search(r"y > -([0-9.e-]+)", entries["Material id"])[1])
            self.assertAlmostEqual(thickness / cell / 4., round(thickness / cell / 4.), 2)
            self.assertGreater(thickness / cell, 3.99)

    def test_symmetric_sector(self):
        for kind, angle, force in (("vickers", "45", 1. / 8), ("berkovich", "60", 1. / 6)):
            case = make_case(kind, read_given(kind, {"material": "steel", "force": "10 mN"}, "usual"))
            self.assertIn(("Sector angle", angle, ""), case.sections["Geometry"])
            history = dict((name, value) for name, value, _ in case.sections["Loading"])["History"]
            part = float(re.search("1: force ([0-9.]+)", history)[1])
            self.assertAlmostEqual(part / case.units.force(10. * force), 1., 5)

    def test_friction(self):
        """The corner of a cube sticks unless told, other tips are smooth."""
        for kind, told, found in (("cube-corner", None, "stick"), ("cube-corner", "0.2", "0.2"), ("cone", None, None),
                                  ("berkovich", "stick", "stick")):
            rows = {name: value for name, value, _ in case_of(kind, friction=told).sections.get("Contact", [])}
            self.assertEqual(rows.get("Friction coefficient"), found)

    def test_solver(self):
        """The default one: multigrid takes half of the time of a factorisation."""
        for kind in EXAMPLES:
            self.assertNotIn("Linear solver", case_of(kind).sections)

    def test_strain(self):
        """Small strains under a shallow sphere, finite ones under a deep one."""
        self.assertNotIn("logarithmic", case_of("sphere", depth="20 nm", tip_radius="10 um").text())
        self.assertIn("logarithmic", case_of("sphere", depth="1 um", tip_radius="10 um").text())


class Estimates(unittest.TestCase):
    elastic = Material("elastic", "", 200., 0.3)

    def test_sphere_is_that_of_hertz(self):
        tip = Tip(1000.)
        radius = expected_radius(tip, [self.elastic], depth=0.1)
        self.assertAlmostEqual(radius, math.sqrt(1000. * 0.1), 3)
        self.assertAlmostEqual(force_at(tip, self.elastic,
                                        radius) / (4. / 3. * 200. / 0.91 * math.sqrt(1000.) * 0.1 ** 1.5), 1., 3)

    def test_cone_is_that_of_sneddon(self):
        tip = cone(70.3)
        self.assertAlmostEqual(expected_radius(tip, [self.elastic], depth=1.),
                               2. / math.pi * math.tan(math.radians(70.3)), 6)

    def test_cap_passes_into_the_cone(self):
        tip = Tip(1., cone(60.).slope)
        end = tip.end_of_cap
        self.assertAlmostEqual(tip.slope_at(end - 1e-9), tip.slope_at(end), 6)
        self.assertAlmostEqual(tip.height(end + 1e-9), tip.height(end), 6)
        self.assertAlmostEqual(end, math.cos(math.radians(60.)), 12)

    def test_depth_grows_with_the_radius(self):
        depths = [depth_at(Tip(50.), library()["copper"], 0.5 * step) for step in range(1, 80)]
        self.assertEqual(depths, sorted(depths))

    def test_hardness_of_a_perfectly_plastic_body(self):
        soft = Material("soft", "", 200., 0.3, 0.01)
        self.assertAlmostEqual(force_at(cone(70.3), soft, 1.) / math.pi, 0.028, 6)

    def test_standard_force_of_brinell(self):
        """The largest ratio whose imprint is not too large."""
        for name, ratio in (("hardened-steel", 30.), ("steel-4340", 30.), ("copper", 15.)):
            self.assertAlmostEqual(brinell_force(Tip(5000.), library()[name]), newtons(100. * ratio), 3)


class Materials(unittest.TestCase):
    def test_each_number_has_a_source(self):
        self.assertGreaterEqual(len(library()), 10)
        for material in library().values():
            self.assertRegex(material.elastic_source, "[A-Z].+[12][0-9]{3}|table")
            self.assertTrue(material.is_elastic or re.search("[12][0-9]{3}|table", material.plastic_source),
                            material.name)

    def test_laws(self):
        steel = library()["steel-4340"]
        self.assertEqual(steel.hardening, Ludwik(0.51, 0.26))
        self.assertAlmostEqual(steel.stress(0.08), 0.792 + 0.51 * 0.08 ** 0.26, 12)
        aluminium = library()["aluminium-6061"]
        self.assertAlmostEqual(aluminium.stress(0.033), 0.338, 2)  # (that of Lu et al. 2020)
        self.assertEqual(read_hardening("power 0.1"), PowerLaw(0.1))

    def test_table_of_ludwik_is_fine_enough(self):
        """Linear between its points and from the yield stress on, as the program takes it: the stress to half a per
        cent, below the first point to two."""
        strains = [1e-10 * 10. ** (0.01 * i) for i in range(1031)]
        for material in (material for material in library().values() if isinstance(material.hardening, Ludwik)):
            entry = material.hardening.entries(material, MILLIMETRES)["Hardening table"]
            points = [(0., 1e3 * material.yield_stress),
                      *(tuple(map(float, row.split(":"))) for row in entry.split("|"))]
            self.assertEqual(len(points), len(TABULATED) + 1)
            for strain in strains:
                (left, low), (right, high) = next(pair for pair in zip(points, points[1:])
                                                  if strain <= pair[1][0] or pair[1] is points[-1])
                stress = low + (high - low) * (strain - left) / (right - left)
                error = abs(stress / (1e3 * material.stress(strain)) - 1.)
                self.assertLess(error, 0.005 if strain > TABULATED[0] else 0.02, (material.name, strain))

    def test_numbers_change_a_material(self):
        changed = chosen_material("steel", "200 GPa", None, "500 MPa", None)
        self.assertEqual((changed.young_modulus, changed.yield_stress, changed.hardening), (200., 0.5, Perfect()))
        self.assertEqual((changed.elastic_source, changed.plastic_source), ("given", "given"))
        self.assertTrue(chosen_material(None, "70 GPa", None, None, None).is_elastic)


    def test_strain_rate(self):
        """Johnson and Cook's rate term, for all stresses of the curve; of numbers that are given nobody knows it."""
        slow, measured = chosen_material("steel", None, None, None, None, "0.001"), library()["steel"]
        for strain in (0., 0.01, 0.3):
            self.assertAlmostEqual(slow.stress(strain) / measured.stress(strain), 1. - 0.022 * math.log(1000.), 12)
        self.assertRegex(slow.plastic_source,
                         r"at the strain rate 1/s; brought to 0.001/s by its rate term, 1 \+ 0.022 ln\(rate\) = 0.848$")
        self.assertEqual(chosen_material("copper", None, None, None, None, "1"),
                         replace(library()["copper"], plastic_source=unittest.mock.ANY))
        for message, *arguments in (
                ("--strain-rate takes a curve of the library .* of steel, steel-4340,", "aluminium-6061", None, None,
                 None, None, "0.1"),
                ("--strain-rate takes a curve", "steel", None, None, "400 MPa", None, "0.1"),
                ("--strain-rate takes a curve", None, "210 GPa", None, None, None, "0.1"),
                ("--strain-rate is 'slow', but must be a number above 1e-06", "steel", None, None, None, None, "slow")):
            with self.assertRaisesRegex(UserError, message):
                chosen_material(*arguments)


class Units(unittest.TestCase):
    def test_consistent(self):
        newton, metre = 1e3, 1e6
        for system in (MILLIMETRES, MICROMETRES, NANOMETRES):
            # 1 N/m² in the units of the file
            self.assertAlmostEqual(system.stress(1e-9) / (system.force(newton) / system.length(metre) ** 2), 1., 12)

    def test_by_the_length(self):
        self.assertEqual([units_for(length) for length in (500., 0.5, 0.02)], [MILLIMETRES, MICROMETRES, NANOMETRES])

    def test_spellings(self):
        for text in ("500 nm", "0.5 um", "0.5 µm", "5e-4 mm"):
            self.assertAlmostEqual(quantity(text, "length", "500 nm", "--depth"), 0.5, 12)


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
                ("there is no material 'stel' in the library. Did you mean 'steel'\\? .*--list-materials", "cone",
                 "--material", "stel", "--depth", "1 um"),
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
