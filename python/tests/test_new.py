# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""epc new: a file of each kind that the program accepts, the same when made again; materials, units, expected
contacts."""

import math
import pathlib
import re
import tempfile
import unittest
import unittest.mock
from dataclasses import replace

from elasto_plastic_contact import UserError
from elasto_plastic_contact.new_case.contact import Tip, cone, depth_at, expected_radius, force_at
from elasto_plastic_contact.new_case.duration import check_file, expected_seconds, unknowns_and_steps
from elasto_plastic_contact.new_case.hardening import TABULATED, Ludwik, Perfect, PowerLaw, read_hardening
from elasto_plastic_contact.new_case.kinds import KINDS, make_case, read_given
from elasto_plastic_contact.new_case.materials import Material, chosen_material, library
from elasto_plastic_contact.new_case.revolution import brinell_force, newtons
from elasto_plastic_contact.new_case.units import MICROMETRES, MILLIMETRES, NANOMETRES, quantity, units_for
from elasto_plastic_contact.program import find_program

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


class Kinds(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_all_have_an_example(self):
        self.assertEqual(set(EXAMPLES), set(KINDS))

    def test_the_program_accepts_each_without_a_warning(self):
        """Finer meshes have more unknowns; of a limit load, meshes follow one another, and a bar has no finer one."""
        for kind in EXAMPLES:
            unknowns = []
            for mesh in ("coarse", "usual"):
                case = case_of(kind, mesh)
                path = self.folder / "case.prm"
                path.write_text(case.text().replace("{stem}", "case"), encoding="utf-8")
                for name, text in case.files.items():
                    (self.folder / name.format(stem="case")).write_text(text, encoding="utf-8")
                report, warnings = check_file(find_program(), str(path))
                self.assertEqual(warnings, "", f"{kind}, {mesh}")
                self.assertGreater(expected_seconds(case.kind_of_time, report, 1.), 0., kind)
                if kind not in ("limit-load", "material-test"):
                    unknowns.append(unknowns_and_steps(report)[0])
            if unknowns:
                self.assertGreater(unknowns[1], 1.8 * unknowns[0], kind)

    def test_the_same_file_again(self):
        for kind in EXAMPLES:
            self.assertEqual((case_of(kind).text(), case_of(kind).files), (case_of(kind).text(), case_of(kind).files))

    def test_head_of_the_file(self):
        for kind in EXAMPLES:
            lines = case_of(kind).text().splitlines()
            self.assertRegex(lines[0], r"^# [^\n]+[^.]\.$")
            self.assertIn(f"# Units: {case_of(kind).units}.", lines)

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

    def test_unloading_of_pyramids(self):
        """Eight steps at least, with fields at its end, all of second order."""
        for mesh, end, steps in (("coarse", "1.4", 28), ("usual", "1.2", 48), ("fine", "1.2", 96)):
            text = case_of("berkovich", mesh).text()
            self.assertIn(f"{end}: force 0", text)
            self.assertRegex(text, rf"Field times *= 1, {end}\n")
            self.assertRegex(text, rf"Number of steps *= {steps}\b")
            self.assertRegex(text, r"Integration *= BDF2\b")

    def test_law_of_film(self):
        for film, is_elastic in (("2 um, 400 GPa", True), ("2 um, 400 GPa, 20 GPa", False)):
            text = case_of("coating", film=film).text()
            self.assertEqual("film: linear elastic, as --film names no yield stress" in text, is_elastic)

    def test_elastic_metal(self):
        """The library knows no yield stress of tungsten, which is said."""
        for changes, is_said in (({"material": "tungsten"}, True), ({"material": "tungsten", "yield_stress": "1 GPa"}, False),
                                 ({}, False)):
            self.assertEqual("plasticity" in case_of("cone", **changes).chosen, is_said)

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

    def test_deep_corner(self):
        """What is said of the corner of a cube that goes deep into a soft body, by depth or by force."""
        def said(**changes):
            return case_of("cube-corner", **changes).chosen.get("difficult", "")

        self.assertRegex(said(material="aluminium"), "^10 radii of the tip.*may take several times as long as estimated, or end "
                                                     "before. Choose a --depth of 0.075 µm at most, a larger")
        self.assertIn("radii of the tip", said(material="aluminium", depth=None, force="1 mN"))
        self.assertIn("radii of the tip", said(material="polycarbonate"))
        for changes in ({}, {"material": "aluminium", "depth": "75 nm"}, {"material": "tungsten"},
                        {"material": "aluminium", "depth": None, "force": "1 uN"}):
            self.assertEqual(said(**changes), "")

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
        self.assertEqual(chosen_material("Al6061", None, None, None, None), library()["aluminium-6061"])


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


if __name__ == "__main__":
    unittest.main()
