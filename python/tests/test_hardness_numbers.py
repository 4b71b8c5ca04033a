# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hardness numbers: rows of the tables of the standards, and those of a folder of results."""

import csv
import io
import contextlib
import math
import pathlib
import tempfile
import unittest

from elasto_plastic_contact import UserError, run
from elasto_plastic_contact.evaluate import main
from elasto_plastic_contact.hardness_numbers import brinell, martens, vickers
from elasto_plastic_contact.new_case.kinds import make_case, read_given

KGF = 9.80665
VICKERS = {"Type": "pyramid", "Number of faces": 4, "Face angle": 68, "Rotation": 45, "Rounding radius": 0, "Truncation": 0,
           "Position": "0, 0", "Initial gap": 0}


def write_table(path, rows):
    with open(path, "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, rows[0])
        writer.writeheader()
        writer.writerows(rows)


def write_run(folder, indenter, units=True, force_at_end=0., inside=0.):
    """A quarter of an indenter: the force 7.3549875 (30 kgf / 40) at the depth 0.06, contact area 0.02. inside: the gap
    of the last point that touches."""
    entries = "".join(f" set {name} = {value}\n" for name, value in indenter.items())
    output = " set Length unit = mm\n set Force unit = N\n" if units else ""
    (folder / "parameters.prm").write_text(f"set Dimension = 3\nsubsection Indenter\n{entries}end\nsubsection Output\n{output}end\n",
                                           encoding="utf-8")
    # (The force has been held for a step, in which it has been larger by rounding.)
    write_table(folder / "history.csv",
                [{"step": step, "time": step, "depth": depth, "force": force, "contact_area": area,
                  "contact_radius": math.sqrt(4. * area / math.pi)}
                 for step, depth, force, area in ((0, 0.055, 0.75 * (1. + 1e-12) * KGF, 0.018), (1, 0.06, 0.75 * KGF, 0.02),
                                                  (2, 0.05, force_at_end, 0.))])
    write_table(folder / "surface_profile.csv",
                [{"step": step, "time": step, "x": x, "y": y, "displacement_x": 0.001 * step, "displacement_y": 0.,
                  "contact_pressure": pressure if step == 1 else 0., "gap": gap}
                 for step in (1, 2) for x, y, pressure, gap in ((0.1, 0., 5., 0.), (0.2, 0., 3., inside),
                                                                (0.3, 0., 0., 0.003), (0.25, 0.25, 4., 0.))])


def evaluated(*arguments):
    """Values by name that 'epc evaluate' prints."""
    with contextlib.redirect_stdout(io.StringIO()) as output:
        main(list(map(str, arguments)))
    return {row["quantity"]: float(row["value"]) for row in csv.DictReader(output.getvalue().splitlines())}


class HardnessNumbers(unittest.TestCase):
    def test_tables_of_standards(self):
        """Rows of ISO 6506-4 and 6507-4, with the digits that stand there."""
        self.assertEqual([round(brinell(3000. * KGF, 10., d)) for d in (3., 4., 5.)], [415, 229, 143])
        self.assertEqual(round(vickers(30. * KGF, 0.4)), 348)
        self.assertAlmostEqual(martens(26.43, 1., 4, 68.), 1., places=3)
        with self.assertRaisesRegex(UserError, "imprint's diameter is 11, but must be above 0 and at most that of the ball, 10"):
            brinell(1., 10., 11.)

    def test_run(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            write_run(folder, VICKERS)
            found = evaluated(folder)
            self.assertAlmostEqual(found["force"], 3. * KGF, places=3)
            self.assertAlmostEqual(found["diagonal_of_area"], 0.4)  # (of the area 0.08)
            self.assertAlmostEqual(found["HV_of_area"], vickers(3. * KGF, 0.4), places=3)
            self.assertAlmostEqual(found["residual_diagonal"], 2. * 0.202)  # (not the point below a face, nor one outside)
            self.assertAlmostEqual(found["HV"], vickers(3. * KGF, 0.404), places=3)
            self.assertAlmostEqual(found["HM"], martens(3. * KGF, 0.06, 4, 68.), places=1)
            write_run(folder, VICKERS, inside=-0.001)  # a quarter of the way to the next point
            self.assertAlmostEqual(evaluated(folder)["residual_diagonal"], 2. * 0.227)
            write_run(folder, VICKERS, force_at_end=1.)
            self.assertNotIn("HV", evaluated(folder))
            write_run(folder, {"Type": "sphere", "Radius": 2.5})
            self.assertAlmostEqual(evaluated(folder)["HBW"], brinell(3. * KGF, 5., 2. * math.sqrt(0.08 / math.pi)), places=3)

    def test_computed_pyramids(self):
        """Runs of 'epc new', with two to four elements over the contact: the definitions, and a Vickers hardness within
        what an element more or less in the contact makes of the 302 of this steel (ASTM E140)."""
        for kind, factor in (("vickers", 26.43), ("berkovich", 26.97)):
            case = make_case(kind, read_given(kind, {"material": "steel-4340", "force": "1 N"}, "coarse"))
            with self.subTest(kind), tempfile.TemporaryDirectory() as name:
                path, folder = pathlib.Path(name, "case.prm"), pathlib.Path(name, "output")
                path.write_text(case.text().replace("{stem}", "case"), encoding="utf-8")
                results = run(path, folder, {"Geometry/Initial refinements": 1, "Loading/Number of steps": 22,
                                             "Output/Fields": "never"})
                found = evaluated(folder)
                row = results.history[int(results.history["force"].argmax())]
                self.assertAlmostEqual(found["force"], 1., places=6)
                self.assertAlmostEqual(found["HM"] * factor * (1e-3 * row["depth"]) ** 2, 1., delta=1e-3)
                if kind == "vickers":
                    pressure = 1e3 * row["force"] / row["contact_area"]  # in N/mm²
                    self.assertAlmostEqual(found["HV_of_area"] * KGF / pressure, math.sin(math.radians(68.)), places=3)
                    self.assertAlmostEqual(found["residual_diagonal"] / found["diagonal_of_area"], 1., delta=0.2)
                    for number in ("HV", "HV_of_area"):
                        self.assertAlmostEqual(found[number] / 302., 1., delta=0.3, msg=number)

    def test_what_is_refused(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            write_run(folder, {"Type": "cone", "Semi-apex angle": 70.3})
            with self.assertRaisesRegex(UserError, "'cone', has no hardness number: .*are in its indentation.csv"):
                evaluated(folder)
            write_run(folder, VICKERS, units=False)
            with self.assertRaisesRegex(UserError, "unit of length '', which is none of .*: give it by --length-unit"):
                evaluated(folder)
            self.assertIn("HV", evaluated(folder, "--length-unit", "mm", "--force-unit", "N"))
            write_run(folder, VICKERS)
            with self.assertRaisesRegex(UserError, "says that its unit of force is N, and --force-unit mN says otherwise: leave that"):
                evaluated(folder, "--length-unit", "mm", "--force-unit", "mN")
            for options in (("--json", "found.json"), ("--vickers",), ("--beta", "1.05")):
                with self.assertRaisesRegex(UserError, f"{options[0]} is for curves, and '.*' is a folder: leave it out, or"):
                    evaluated(folder, *options)


if __name__ == "__main__":
    unittest.main()
