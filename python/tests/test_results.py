# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables, fields and parameters of a run that Python has started; messages where there are none."""

import pathlib
import re
import tempfile
import unittest

from elasto_plastic_contact import Results, UserError, run
from elasto_plastic_contact.fields import read_record
from elasto_plastic_contact.program import RunError, as_text
from elasto_plastic_contact.tables import read_table

CASE = "verification/uniaxial_stress.prm"


class ResultsOfARun(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.results = run(CASE, f"{cls.folder.name}/bar", {
            "Loading/Number of steps": 4, "Material/Yield stress": [300]})

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_tables(self):
        self.assertEqual(list(self.results.history["step"]), [1, 2, 3, 4])
        self.assertAlmostEqual(self.results.reactions[-1]["top_z"], (300 + 2000 * 0.02) / 1.01, places=6)
        self.assertGreater(self.results.statistics["newton_iterations"].max(), 0)

    def test_fields(self):
        fields = self.results.fields("solution")
        self.assertEqual(fields["stress"].shape, (len(fields["points"]), 9))
        self.assertAlmostEqual(fields["stress"][:, 8].max(), (300 + 2000 * 0.02) / 1.01, places=3)
        self.assertAlmostEqual(fields["displacement"][:, 2].max(), 0.02)
        with self.assertRaisesRegex(UserError, "there is no step 9 in .*solution.pvd': it has 5"):
            self.results.fields("solution", 9)

    def test_fields_in_pieces(self):
        """A large file has several pieces."""
        with tempfile.TemporaryDirectory() as folder:
            file = next(pathlib.Path(self.results.directory).glob("solution-*.vtu"))
            piece = re.search(b"<Piece.*</Piece>", file.read_bytes(), re.DOTALL).group()
            (pathlib.Path(folder) / "two.vtu").write_bytes(file.read_bytes().replace(piece, 2 * piece))
            one, two = read_record(self.results.directory, file.name), read_record(folder, "two.vtu")
            self.assertEqual(two["displacement"], 2 * one["displacement"])
            first_of_second = two["cells"][len(one["cells"])]
            self.assertEqual(first_of_second, [len(one["points"]) + point for point in one["cells"][0]])

    def test_parameters(self):
        self.assertEqual(self.results.number("Material/Yield stress"), 300)
        with self.assertRaisesRegex(UserError, "no number for 'Material/Yield'"):
            self.results.number("Material/Yield")

    def test_wrong_arguments(self):
        for arguments, message in ((((3, "x"), {}), "'case' is 3, but must be a path"),
                                   (((CASE, None), {}), "'directory' is None, but must be a path"),
                                   (((CASE, "x", [1]), {}), r"'entries' is \[1\], but must be a dictionary"),
                                   (((CASE, "x"), {"ranks": "2"}), "'ranks' is '2', but must be an integer")):
            with self.assertRaisesRegex(UserError, message):
                run(*arguments[0], **arguments[1])

    def test_what_is_there_is_not_replaced(self):
        with self.assertRaisesRegex(RunError, "holds results already") as caught:
            run(CASE, self.results.directory)
        self.assertEqual(caught.exception.status, 2)
        self.assertEqual(len(Results(self.results.directory).history), 4)
        self.assertEqual(len(run(CASE, self.results.directory, overwrite=True).history), 1)
        run(CASE, self.results.directory, {"Loading/Number of steps": 4, "Material/Yield stress": 300}, overwrite=True)


class Messages(unittest.TestCase):
    def test_wrong_input(self):
        with tempfile.TemporaryDirectory() as folder:
            with self.assertRaisesRegex(RunError, "Poisson's ratio.*0.7"):
                run(CASE, folder, {"Material/Poisson's ratio": 0.7})
            with self.assertRaisesRegex(UserError, "no parameter file 'nothing.prm'"):
                run("nothing.prm", folder)
            with self.assertRaisesRegex(UserError, "no program '/nowhere/program'"):
                run(CASE, folder, program="/nowhere/program")
            with self.assertRaisesRegex(UserError, "history.csv' cannot be read: No such file"):
                Results(folder).history.size

    def test_damaged_tables(self):
        with tempfile.TemporaryDirectory() as folder:
            table = pathlib.Path(folder) / "history.csv"
            for text in ("1", "1,x", "1,2,3", "1;2"):
                table.write_text(f"a,b\n1,2\n{text}\n")
                with self.assertRaisesRegex(UserError, "history.csv' is damaged in line 3: .* '.' is the decimal"):
                    read_table(table)
            for text in ("h\tP\n1.5\t2\n", "h\tP, mN\tt\n1,5\t2,5\t3\n"):
                table.write_text(text)
                with self.assertRaisesRegex(UserError, "history.csv' separates columns by tabs. .* Either ',' separates"):
                    read_table(table)
            for code in ("utf-16", "utf-16-le", "utf-16-be"):
                table.write_bytes("h,P\n1.5,2\n".encode(code))
                with self.assertRaisesRegex(UserError, "history.csv' is in UTF-16, .* Save it as plain text, or as UTF-8"):
                    read_table(table)
            table.write_text("h,P\n\"1,5\",2\n")
            with self.assertRaisesRegex(UserError, "in line 2: the value of 'h' is '1,5'. .* ';' separates columns"):
                read_table(table)
            table.write_text("a,b\n")
            self.assertEqual(read_table(table), [])
            with self.assertRaisesRegex(UserError, "history.csv' holds no results yet"):
                Results(folder).history.size

    def test_decimal_comma(self):
        with tempfile.TemporaryDirectory() as folder:
            table = pathlib.Path(folder) / "curve.csv"
            table.write_bytes("Weg/µm;Kraft\r\n1,5;-2e-3\r\n".encode("cp1252"))
            self.assertEqual([list(row.values()) for row in read_table(table)], [[1.5, -0.002]])
            table.write_text("h;P\n1,5;2\n1.250;2\n")
            with self.assertRaisesRegex(UserError, "in line 3: .* ';' separates columns and ',' is the decimal comma"):
                read_table(table)

    def test_decimal_commas_that_separate(self):
        """Of one column, or of two: each would be read as two."""
        with tempfile.TemporaryDirectory() as folder:
            table = pathlib.Path(folder) / "curve.csv"
            for text in ("depth, mm\n0,12\n1,25\n", "depth, mm,force, N\n0,12,3,40\n1,25,6,81\n", "h,mm\n0,12\n0,05\n",
                         "h\n0,05\n", "h,P\n0,05,0,12\n"):
                table.write_text(text)
                with self.assertRaisesRegex(UserError, "curve.csv' seems to have decimal commas.* ';' separates columns"):
                    read_table(table)
            table.write_text("h\n0,12\n")
            with self.assertRaisesRegex(UserError, "in line 2: columns: 1, values: 2.* ',' is the decimal comma"):
                read_table(table)
            table.write_text("depth, mm;force, N\n0,12;3,4\n")
            self.assertEqual(read_table(table), [{"depth, mm": 0.12, "force, N": 3.4}])
            for text in ("h,P\n1,20\n0,10\n", "h, P\n1, 20\n", "h, P\n1.5,20\n"):
                table.write_text(text)
                self.assertEqual(list(read_table(table)[0]), ["h", "P"])
            for text, words in (("0,0\n1,2\n", "numbers in place of the names"), ("h,P,h\n1,2,3\n", "two columns are called 'h'")):
                table.write_text(text)
                with self.assertRaisesRegex(UserError, f"damaged in line 1: .*{words}"):
                    read_table(table)

    def test_limit_load(self):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "limit_load.csv").write_text("cycle,cells\n0,100\n")
            self.assertEqual(Results(folder).table("limit_load")["cells"], 100)
            with self.assertRaisesRegex(UserError, "no history.csv in .*: these are the results of a limit load. "
                                                   "Draw them by 'epc plot /"):
                Results(folder).history.size

    def test_values(self):
        self.assertEqual([as_text(value) for value in (0.1, 3, True, "a", [1, 2.5], ("x", False))],
                         ["0.1", "3", "true", "a", "1, 2.5", "x, false"])


if __name__ == "__main__":
    unittest.main()
