# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reports of runs: what they say is what the run has, in words and numbers; what is refused."""

import base64
import pathlib
import re
import shutil
import tempfile
import unittest

from commands import command
from elasto_plastic_contact import UserError, run
from elasto_plastic_contact.reporting.bibliography import bibtex, entries_of_bibliography, key_of_deal_ii, known_entries
from elasto_plastic_contact.reporting.command import write_report
from elasto_plastic_contact.reporting.constants import as_parameter_file
from elasto_plastic_contact.reporting.convergence import (common_ratio, entries_of_mesh, extrapolated, folder_of,
                                                           run_on, table_of)
from elasto_plastic_contact.reporting.document import Document
from elasto_plastic_contact.reporting.energy import balance
from elasto_plastic_contact.reporting.facts import Facts
from elasto_plastic_contact.reporting.key_numbers import UNLOADING, key_numbers
from elasto_plastic_contact.reporting.key_numbers import write as write_key_numbers
from elasto_plastic_contact.reporting.mesh import contact_sizes
from elasto_plastic_contact.reporting.methods import methods
from elasto_plastic_contact.reporting.problem import (boundaries_in_words, loading_in_words, material_table,
                                                       materials_in_words, row_in_words)

CONE = {"Geometry/Initial refinements": 3, "Loading/Number of steps": 24,
        "Loading/History": "1: depth 0.02 | 1.2: force 0", "Output/Fields": "last cycle",
        "Output/Length unit": "mm", "Output/Force unit": "N"}
SECTIONS = ["Results in short", "Problem", "Mesh", "Convergence", "Curves", "Imprint", "Fields", "Energy balance",
            "Constants",
            "Methods", "BibTeX"]


class Reports(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.cone = run("indentation/cone_finite_strain.prm", cls.folder / "cone", CONE)
        cls.bar = run("material/voce.prm", cls.folder / "bar", {"Loading/Number of steps": 6})
        cls.punch = run("limit_load/strip_punch.prm", cls.folder / "punch", {"Refinement/Number of cycles": 1})

    def page_of(self, results, **options):
        path = self.folder / "page.html"
        write_report(results.directory, path, overwrite=True, say=lambda text: None, **options)
        return path.read_text(encoding="utf-8").replace(" class=number", "")

    def expect(self, words, page, *, there=True):
        """(Pages are too long for the messages of assertIn.)"""
        for text in words:
            self.assertEqual(text in page, there, text)

    def expect_message(self, pattern, *arguments):
        process = command("report", *arguments)
        self.assertNotIn("Traceback", process.stderr)
        self.assertRegex(process.stderr.splitlines()[-1], f"^report: .*{pattern}")
        self.assertEqual(process.returncode, 2)

    def test_page(self):
        """All sections; pictures are in it and are such; nothing is asked from elsewhere."""
        page = self.page_of(self.cone)
        self.assertEqual(re.findall("<h2[^>]*>([^<]*)<", page), SECTIONS)
        pictures = re.findall(r'src="data:image/([^;]*);base64,([^"]*)"', page)
        self.assertEqual([kind for kind, _ in pictures], 4 * ["svg+xml"] + 2 * ["png"])
        for kind, text in pictures:
            self.assertIn(b"<svg" if kind == "svg+xml" else b"\x89PNG\r\n", base64.b64decode(text)[:600])
        self.assertEqual(page.count("src="), len(pictures))
        self.expect(['href="http'], page, there=False)
        largest = self.cone.history["force"].max()
        self.expect([f"<td>largest force</td><td>{largest:.5g} N</td>", "cone, semi-apex angle 70 degrees",
                     "depth 0.02 at t = 1; force 0 at t = 1.2", "library</td><td>deal.II ",
                     "The run has not been repeated on another mesh"], page)

    def test_contact_sizes(self):
        """Elements of one size, 8 / 2^(3 + 6), under the contact."""
        sizes = contact_sizes(Facts(self.cone.directory))
        self.assertAlmostEqual(sizes.smallest, 8. / 2 ** 9)
        self.assertAlmostEqual(sizes.largest, 8. / 2 ** 9)
        self.assertAlmostEqual(sizes.elements, self.cone.history["contact_radius"].max() / sizes.smallest, delta=0.3)

    def test_energy(self):
        """The parts make up the work, but for the rule of trapezoids."""
        top = self.cone.history[int(self.cone.history["force"].argmax())]
        work, *parts, difference = balance(top)
        self.assertAlmostEqual(work, sum(parts) + difference, places=12)
        self.assertLess(abs(difference), 0.02 * work)
        self.assertGreater(parts[2], 0.5 * work)

    def test_methods(self):
        """Of what the run has used, and no more; every key has its entry."""
        facts = Facts(self.cone.directory)

        def text_with(**entries):
            facts.run.parameters = dict(original) | {name.replace("__", "/").replace("_", " "): value
                                                     for name, value in entries.items()}
            for cached in ("history_rows", "kind"):
                facts.__dict__.pop(cached, None)
            text, keys = methods(facts, [])
            self.assertEqual(set(keys) | {"elasto_plastic_contact"},
                             set(re.findall(r"\w+_\w*\d{4}|elasto_plastic_contact", text)))
            self.assertFalse(set(keys) - set(known_entries()))
            return text

        original = facts.run.parameters
        text = text_with()
        for words in ("an axisymmetric body with finite, logarithmic strains", "bilinear quadrilaterals",
                      "[hughes_1980]",
                      "integrated by two-step backward differentiation (BDF2), beginning with an implicit Euler step "
                      "where the load turns: radial return",
                      "yield stress σ_0 (", "without friction", "in 24 load steps of equal length",
                      "geometric multigrid without a matrix", "[munch_heister_2022]",
                      "below 1e-10 of all nodal forces", "revision"):
            self.assertIn(words, text)
        for words in ("swift", "Coulomb", "Hencky", "voce", "oliver"):
            self.assertNotIn(words, text)
        text = text_with(Material__Law="nonlinear hardening", Material__Power_law_exponent="0.2", Strain="small",
                         Material__Isotropic_hardening_modulus="0", Contact__Friction_coefficient="0.1",
                         Loading__Step_control="adaptive", Discretization__Volumetric_treatment="standard",
                         Contact__Edge="at nodes", Linear_solver__Type="direct")
        for words in ("σ_0 + σ_0 ((1 + α / ε_0)^N - 1)", "[swift_1952]", "Coulomb's friction, coefficient 0.1",
                      "[ramm_1981]",
                      "(Johnson's gap)", "the contact ends at nodes", "a sparse factorisation"):
            self.assertIn(words, text)
        for words in ("hughes_1980", "munch_heister_2022", "logarithmic", "H α", "Q ("):
            self.assertNotIn(words, text)
        self.assertIn("integrated by the implicit Euler method: radial return",
                      text_with(Loading__Integration="backward Euler"))
        text = text_with(Material__Yield_criterion="Hill", Material__Hill_ratios="1 | 1.1 | 1 | 1 | 1 | 1",
                         Material__Axes="30")
        for words in ("Hill's orthotropic yield condition", "[hill_1948]",
                      "Hill ratios 1 | 1.1 | 1 | 1 | 1 | 1, Axes 30", "return to the yield surface with"):
            self.assertIn(words, text)
        self.assertNotIn("radial return", text)
        text = text_with(Loading__History="", Loading__Number_of_steps="1", Contact__Friction_coefficient="stick",
                         Material__Law="nonlinear hardening", Material__Back_stress_moduli="2000",
                         Material__Recovery_rates="40",
                         Material__Rate_law="Perzyna")
        for words in ("Hencky's deformation theory in a single step [johnson_1978]", "complete adhesion",
                      "[armstrong_frederick_1966, chaboche_1986, perzyna_1966]"):
            self.assertIn(words, text)
        in_forces = "Newton's iterations, with a line search in the norm of the forces on free unknowns, end when"
        self.assertIn(in_forces, text)
        self.assertIn(in_forces, text_with(Contact__Friction_coefficient="0.1"))
        self.assertIn("a line search in the energy, end when", text_with(Contact__Friction_coefficient="stick"))
        for law, rate_law, words in (("linear elastic", "Norton", "in the energy"),
                                     ("perfectly plastic", "Norton", in_forces),
                                     ("perfectly plastic", "Perzyna", "in the energy"),
                                     ("perfectly plastic", "Cowper-Symonds", in_forces)):
            self.assertIn(words, text_with(Material__Law=law, Material__Rate_law=rate_law))

    def test_other_kinds(self):
        self.expect(["Kind of run: body without indenter", "σ_0 + Q (1 - exp(-b α))", "The run does not name its units",
                     "This run has no deformed contact surface.",
                     f"force of the support top_z at the end</td><td>{self.bar.reactions['top_z'][-1]:.5g}"],
                    self.page_of(self.bar))
        page = self.page_of(self.punch)
        row = self.punch.table("limit_load")[-1]
        self.expect([f"lower bound of the limit load</td><td>{row['lower_bound']:.5g}</td>", "[johnson_mercier_1978]",
                     "The two bounds enclose the exact limit load on any mesh."], page)
        self.expect(["Young&#x27;s modulus</td>"], page, there=False)

    def test_soil(self):
        """Its strength instead of a yield stress."""
        facts = Facts(self.punch.directory)
        facts.run.parameters = dict(facts.run.parameters) | {
            "Material/Yield criterion": "Mohr-Coulomb, von Mises", "Material/Cohesion": "20, 1",
            "Material/Friction angle": "30", "Material/Yield stress": "5"}
        head, rows = material_table(facts)
        table = {row[0]: row[1:-1] for row in rows}
        self.assertEqual(head[2:-1], ["material 0", "material 1"])
        self.assertEqual(table["Cohesion"], ["c", "20", "-"])
        self.assertEqual(table["Friction angle"], ["φ", "30", "-"])
        self.assertEqual(table["Yield stress"], ["σ_0", "-", "5"])
        text, = materials_in_words(facts)
        self.assertIn("Mohr and Coulomb's yield condition", text)
        self.assertIn("or with von Mises' yield condition", text)
        facts.run.parameters["Material/Yield criterion"] = "Drucker-Prager"
        facts.run.parameters["Material/Cohesion"] = "20"
        self.assertEqual([row[0] for row in material_table(facts)[1]][1:3], ["Cohesion", "Friction angle"])
        self.assertIn("Drucker and Prager's yield condition", materials_in_words(facts)[0])

    def test_parts_of_boundaries(self):
        """Named where there are any."""
        facts = Facts(self.punch.directory)
        self.assertNotIn("Parts of boundaries", boundaries_in_words(facts))
        facts.run.parameters = dict(facts.run.parameters) | {"Geometry/Boundary parts": "strip: top; x > 1"}
        self.assertIn("Parts of boundaries with names of their own, where the expression is not 0: strip: top; x > 1.",
                      boundaries_in_words(facts))

    def test_meshes(self):
        """A coarser mesh: the differences; the second time it is there; a changed run makes it anew."""
        said = []
        folder = self.folder / "pair"
        shutil.copytree(self.cone.directory, folder)

        def coarser():
            facts = Facts(folder)
            other = run_on(facts, entries_of_mesh(facts, ["coarser"]), 1, None, said.append)
            return facts, other

        facts, other = coarser()
        coarser()
        place = folder_of(facts, {"Geometry/Initial refinements": "2"})
        self.assertEqual([text.partition(" ")[0] for text in said], ["running", f"{place}:"])
        self.assertNotEqual(place, folder_of(facts, {"Geometry/Initial refinements": "4"}))
        self.assertEqual(other.text("Geometry/Initial refinements"), "2")
        force, coarse = (mesh.run.history["force"].max() for mesh in (facts, other))
        rows, ratio = table_of([facts, other])
        self.assertEqual(rows[0], ["largest force", f"{force:.5g} N", f"{coarse:.5g} N",
                                   f"{100. * (coarse / force - 1.):+.2f} %"])
        self.assertIsNone(ratio)
        self.assertRegex(methods(facts, [other])[0], "With 2 meshes, the largest force on the two finest ones differs "
                                                     "by")
        page = self.page_of(facts.run, meshes=[["coarser"]])
        self.expect(["Force over depth on all meshes", f"<td>{coarse:.5g} N</td>", "From two meshes nothing is "
                                                                                   "extrapolated"], page)
        parameters = folder / "parameters.prm"
        parameters.write_text(parameters.read_text().replace("= 600", "= 610"))
        coarser()
        self.assertIn("holds another run, or one that has not finished, and is made anew", said[-2])

    def test_elastic_body(self):
        """The methods compare meshes by the first number that is not zero."""
        elastic = run("material/voce.prm", self.folder / "elastic",
                      {"Loading/Number of steps": 2, "Material/Law": "linear elastic"})
        facts = Facts(elastic.directory)
        self.assertIn("the work of the loads at the end on the two finest ones differs by 0 %.",
                      methods(facts, [Facts(elastic.directory)])[0])

    def test_extrapolation(self):
        """Of what has the order 2, exactly; none of what swings or has an order that no elements have."""
        value, order, index = extrapolated(*(3. + 0.1 * size ** 2 for size in (1., 2., 4.)), 2., 1.)
        self.assertAlmostEqual(value, 3.)
        self.assertAlmostEqual(order, 2.)
        self.assertAlmostEqual(index, 1.25 * 0.1 / 3.1)
        self.assertIsNone(extrapolated(1., 1.1, 1.05, 2., 1.))
        self.assertIsNone(extrapolated(1., 1.1, 2.9, 2., 1.))  # (order 4.2)
        self.assertIsNotNone(extrapolated(1., 1.1, 2.9, 2., 2.))
        self.assertIsNone(extrapolated(1., 1., 1.1, 2., 1.))
        self.assertIsNone(extrapolated(0., 0.1, 0.5, 2., 1.))
        self.assertAlmostEqual(common_ratio([1., 2., 4.04]), 2.01, places=2)
        self.assertIsNone(common_ratio([1., 2., 3.]))
        self.assertIsNone(common_ratio([1., 2.]))

    def test_bibliography(self):
        self.assertEqual(entries_of_bibliography(), known_entries())
        self.assertEqual(key_of_deal_ii("9.4.1"), "arndt_2022")
        self.assertEqual(key_of_deal_ii("9.99.0"), "arndt_2021")
        self.assertEqual(key_of_deal_ii(None), "arndt_2021")
        text = bibtex({"version": "0.3.0", "revision": "abc"}, ["hertz_1882", "hertz_1882"])
        self.assertIn("version = {0.3.0}", text)
        self.assertEqual(text.count("@article{hertz_1882"), 1)

    def test_texts(self):
        """What is markup stays a text; the input that differs from the defaults can be run again."""
        document = Document("a < b")
        document.table(["x"], [["<i>"]])
        self.assertIn("<title>a &lt; b</title>", document.html())
        self.assertIn("<td>&lt;i&gt;</td>", document.html())
        facts = Facts(self.bar.directory)
        again = self.folder / "again.prm"
        again.write_text(as_parameter_file(facts.changed))
        repeated = run(again, self.folder / "again")
        self.assertEqual(list(repeated.reactions["top_z"]), list(self.bar.reactions["top_z"]))
        self.assertEqual(loading_in_words(facts), "The boundary conditions act up to the time t = 2.")

    def test_rate_sensitivity(self):
        """A row of a hold is none of an unloading."""
        folder = self.folder / "hold"
        shutil.copytree(self.cone.directory, folder)
        columns = ("modelled_part", "stiffness", *(column for column, _, _ in UNLOADING[1:]), "hold_rate_sensitivity",
                   "jump_rate_sensitivity")
        hold, unloading = "1,nan,700,0,0,0,0.19,nan", "1,9000,800,210000,820,220000,nan,nan"

        def facts_with(*rows):
            (folder / "indentation.csv").write_text("\n".join([",".join(columns), *rows, ""]))
            return Facts(folder)

        def numbers_of(facts):
            return {number.name: number.value for number in key_numbers(facts)}

        facts = facts_with(hold, unloading)
        self.assertEqual(numbers_of(facts)["hardness, with the contact area"], 800.)
        self.assertEqual(numbers_of(facts)["rate sensitivity of the hardness, by the first hold"], 0.19)
        self.assertLessEqual({"oliver_pharr_1992", "lucas_oliver_1999"}, set(methods(facts, [])[1]))
        facts = facts_with(hold)
        self.assertNotIn("hardness, with the contact area", numbers_of(facts))
        self.assertNotIn("Oliver", methods(facts, [])[0])
        self.assertNotIn("lucas_oliver_1999", methods(facts_with(unloading), [])[1])

    def test_modelled_part(self):
        """What the numbers are of is said where it is not the whole indenter."""
        facts, words = Facts(self.cone.directory), "those of the part of the indenter that stands on the body"
        for areas, is_said in ((1., False), (0.25, True)):
            history = facts.run.history.copy()
            history["contact_area"] *= areas
            facts.run.table = {"history": history}.__getitem__
            document = Document("")
            write_key_numbers(facts, document)
            self.assertEqual(f"{words}, 0.25 of the whole" in document.html(), is_said)

    def test_history_in_words(self):
        """Values are reached at a time, rates and holds last until then."""
        self.assertEqual([row_in_words(*row) for row in ((1., "depth 0.05"), (20., "strain rate 0.05"), (30., "force rate 2"),
                                                         (40., "hold"))],
                         ["depth 0.05 at t = 1", "strain rate (dh/dt) / h = 0.05 until t = 20",
                          "force rate 2 until t = 30", "held until t = 40"])

    def test_command(self):
        path = self.folder / "command.html"
        process = command("report", self.bar.directory, "--output", path)
        self.assertEqual((process.returncode, process.stdout, process.stderr), (0, f"{path}\n", ""))
        self.expect_message("command.html' is there already: choose another --output, or add --overwrite",
                            self.bar.directory,
                            "--output", path)
        self.expect_message("argument --output: it is 'a.pdf', but must end with .html", self.cone.directory,
                            "--output", "a.pdf")

    def test_no_run(self):
        self.expect_message("there is no folder '/nowhere': give the output directory of a run", "/nowhere")
        self.expect_message("is no output directory of a run: it has no parameters.prm", self.folder)
        fit = self.folder / "fit"
        fit.mkdir()
        (fit / "fit.json").write_text("{}")
        self.expect_message("'fit.json' is of another command; each of its runs has a folder of its own", fit)

    def test_unfinished(self):
        folder = self.folder / "unfinished"
        folder.mkdir()
        shutil.copy(self.cone.path("parameters.prm"), folder)
        self.expect_message("has not finished: it has no history.csv yet", folder)
        lines = pathlib.Path(self.cone.path("history.csv")).read_text().splitlines(keepends=True)
        (folder / "history.csv").write_text("".join(lines[:11]))
        self.expect_message("has not finished: it has come to the time 0.5 of 1.2. Let it end, or let it go on with "
                            "--resume",
                            folder)

    def test_older_run(self):
        """Without the lines on versions, the report says that it does not know them."""
        folder = self.folder / "older"
        shutil.copytree(self.bar.directory, folder)
        parameters = folder / "parameters.prm"
        parameters.write_text(parameters.read_text().partition("MPI rank(s)\n")[2])
        self.assertIsNone(Facts(folder).program)
        page = self.folder / "older.html"
        write_report(folder, page, say=lambda text: None)
        self.assertIn("parameters.prm does not say which version", page.read_text(encoding="utf-8"))

    def test_wrong_meshes(self):
        facts = Facts(self.cone.directory)
        self.assertEqual(entries_of_mesh(facts, ["finer", "2"]), {"Geometry/Initial refinements": "5"})
        for words, message in ((["middle"], "--mesh-pair has 'middle', but must be coarser or finer, or entries"),
                               (["coarser", "0"], "--mesh-pair coarser: it is '0', but must be an integer >= 1"),
                               (["coarser", "1", "2"], "takes the number of halvings behind it, and nothing else"),
                               (["coarser", "4"], "of the run is 3, and cannot be less by 4: take finer"),
                               (["Geometry/Initial=2"], "--mesh-pair: there is no entry 'Geometry/Initial'. Did you "
                                                        "mean")):
            with self.assertRaisesRegex(UserError, message):
                entries_of_mesh(facts, words)
        facts.run.parameters = facts.run.parameters | {"Refinement/Elements over contact radius": "10"}
        self.assertEqual(entries_of_mesh(facts, ["coarser"])["Refinement/Elements over contact radius"], "5")


if __name__ == "__main__":
    unittest.main()
