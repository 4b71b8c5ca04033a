# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What exports of instruments and spreadsheets do with numbers, words, times, names of columns and parts of an indent."""

import unittest

import numpy
from measured_files import FilesOfInstruments, rows_of

from elasto_plastic_contact import read_curve

HEAD = "Time (s)\tDepth (nm)\tLoad (mN)\n"


def clock(seconds, mark="."):
    """A time of the day from 23:59:55 on."""
    second = (86395. + seconds) % 86400.
    return f"{int(second // 3600):02}:{int(second % 3600 // 60):02}:{second % 60.:09.6f}".replace(".", mark)


class Exports(FilesOfInstruments):
    def rows(self, text, separator):
        """text: of a time in s, a depth in Å and a force in µN."""
        return "".join(separator.join(map(text, row)) + "\n"
                       for row in zip(self.time, 10. * self.depth, 1e3 * self.force))

    def test_thousands(self):
        for head, mark, decimal in (('"Time (s)","Depth (Å)","Load (µN)"', ",", "."), ("t/s;h/Å;F/µN", ".", ","),
                                    ("t/s;h/Å;F/µN", "\u00a0", ","), ("t/s;h/Å;F/µN", "\u202f", "."),
                                    ("t/s;h/Å;F/µN", "'", "."), ("t/s;h/Å;F/µN", "’", ".")):
            is_quoted = head.startswith('"')

            def text(value, marks=str.maketrans({",": mark, ".": decimal}), quote='"' * is_quoted):
                return quote + f"{value:,.6f}".translate(marks) + quote

            with self.subTest(mark=mark, decimal=decimal):
                self.check(read_curve(self.write(f"{head}\n{self.rows(text, ',' if is_quoted else ';')}")))

    def test_thousands_without_decimals(self):
        rows = "".join(f"{h:,.0f}\t{F:,.0f}\n" for h, F in zip(1e3 * self.depth, 1e6 * self.force))
        self.check(read_curve(self.write("Depth (pm)\tLoad (nN)\n" + rows)))
        three_decimals = "".join(f"{h:.3f}\t{F:.3f}\n".replace(".", ",") for h, F in zip(self.depth, self.force))
        curve, = read_curve(self.write("Depth (nm)\tLoad (mN)\n" + three_decimals))
        numpy.testing.assert_allclose(curve.depth, 1e-3 * self.depth, atol=1e-6)
        with_zeros = "".join("\t".join(f"{value:.3f}".replace(".", ",") if value >= 1. else "0" for value in row) + "\n"
                             for row in zip(self.depth, self.force))
        curve, = read_curve(self.write("Depth (nm)\tLoad (mN)\n" + with_zeros))
        self.assertAlmostEqual(curve.depth.max(), 0.306, delta=1e-5)
        self.assertAlmostEqual(curve.force.max(), 10., delta=1e-3)

    def test_other_numbers(self):
        self.check(read_curve(self.write(HEAD + rows_of((self.time, -self.depth, self.force)).replace("-", "\u2212"))))
        powers = "".join(f"{t:.8e}  {h:.8e}  {F:.8e}\n".replace("e", "D") for t, h, F in zip(self.time, self.depth,
                                                                                             self.force))
        self.check(read_curve(self.write(HEAD.replace("\t", "  ") + powers)))
        quoted = "".join(",".join(f'"{value:.6f}"'.replace(".", ",") for value in row) + "\n"
                         for row in zip(*self.columns))
        self.check(read_curve(self.write('"Time (s)","Depth (nm)","Load (mN)"\n' + quoted)))

    def test_numbers_in_two_ways(self):
        rows = rows_of(self.columns, ";", ",").splitlines(keepends=True)
        self.refused("has a text in place of a number in line 143: '20.1', where other lines have decimal commas. Write all "
                     "numbers alike and without thousands separators, or remove that line",
                     "".join([HEAD.replace("\t", ";"), *rows[:141], "20.1;246.0;0.1\n20.2;246.0;0.1\n"]))

    def test_words(self):
        words = ["Loading"] * 81 + ["Hold"] * 20 + ["Unloading"] * 41
        rows = rows_of(self.columns).splitlines()
        self.check(read_curve(self.write(HEAD.replace("\n", "\tSegment\n") + "".join(
            f"{row}\t{word}\n" for row, word in zip(rows, words)))))
        self.check(read_curve(self.write("Index\tPhase\t" + HEAD + "".join(
            f"{i}\t{word}\t{row}\n" for i, (row, word) in enumerate(zip(rows, words))))))

    def test_times_of_the_day(self):
        rows = rows_of((self.depth, self.force), ";").splitlines()
        for before, mark in (("", "."), ("2021-03-04 ", "."), ("04.03.2021 ", ","), ("2021-03-04T", ".")):
            text = "Time;Depth (nm);Load (mN)\n" + "".join(f"{before}{clock(t, mark)};{row}\n"
                                                           for t, row in zip(self.time, rows))
            curve, = self.check(read_curve(self.write(text)))
            self.assertEqual(curve.remarks, ("the time is that of the day in the column 'Time'",))
        text = "No;Clock;Time (s);Depth (nm);Load (mN)\n" + "".join(f"{i};{clock(t)};{t};{row}\n" for i, (t, row) in
                                                                    enumerate(zip(self.time, rows)))
        self.assertEqual(self.check(read_curve(self.write(text)))[0].remarks, ())
        curve, = self.check(read_curve(self.write("Time;Depth (nm);Load (mN)\n" + "".join(f"a;{row}\n" for row in rows))))
        self.assertEqual((curve.time, curve.remarks[0]),
                         (None, "the column 'Time' holds no numbers, so that there are no rates"))

    def test_parts_of_an_indent(self):
        rows = rows_of(self.columns).splitlines(keepends=True)
        load, hold, unload = "".join(rows[:81]), "".join(rows[81:101]), "".join(rows[101:])
        self.check(read_curve(self.write(f"Loading data\n{HEAD}{load}\nDwell at maximum load\n{HEAD}{hold}\nUnloading "
                                         f"data\n{HEAD}{unload}")))
        self.check(read_curve(self.write(f"{HEAD}Segment 1\n{load}Segment 2\n{hold}{unload}")))
        self.check(read_curve(self.write(f"{HEAD}{load}# at the largest force\n{hold}{unload}")))
        twice = f"{HEAD}Loading\n{load}{hold}Unloading\n{unload}" * 2
        self.check(read_curve(self.write(twice)), 2)
        without_time = twice.replace("Time (s)", "No.")
        self.check(read_curve(self.write(without_time)), 2)

    def test_indents_below_each_other(self):
        rows = rows_of((self.depth, self.force)).splitlines()
        numbered = "Indent No.\tDepth (nm)\tLoad (mN)\n" + "".join(f"{i}\t{row}\n" for i in (1, 2, 3) for row in rows)
        curves = self.check(read_curve(self.write(numbered)), 3)
        self.assertEqual([curve.name for curve in curves], ["Indent No. 1", "Indent No. 2", "Indent No. 3"])
        curves = self.check(read_curve(self.write("Depth (nm)\tLoad (mN)\n" + 2 * rows_of((self.depth, self.force)))), 2)
        self.assertEqual(curves[1].remarks, ("another indent begins where the depth begins again",))

    def test_headings(self):
        for head in ("# time(s) depth(nm) load(mN)", "Prüfzeit [s] Eindringtiefe [nm] Standardkraft [mN]",
                     "Temps [s]  Profondeur de pénétration [nm]  Force normale [mN]",
                     "Elapsed Time (s)  Corrected Depth (nm)  Corrected Load (mN)",
                     "Time t (s)  Depth, h (nm)  Load P (mN)", "Time (seconds)  Depth (Nanometers)  Force (millinewtons)"):
            with self.subTest(head=head):
                curve, = self.check(read_curve(self.write(f"{head}\n{rows_of(self.columns, '  ')}")))
                self.assertIsNotNone(curve.time)
        self.check(read_curve(self.write("s\tnm\tmN\nTime\tDepth\tLoad\n" + rows_of(self.columns))))

    def test_numbers_with_units(self):
        rows = "".join(f"{t:.4f} s\t{h:.4f} nm\t{F:.4f} mN\n" for t, h, F in zip(*self.columns))
        self.refused("has 0 complete rows of depth and force in the indent '1', of the columns 'Depth' and 'Load': that is "
                     "no curve. Are these the right columns, and numbers alone in them", "Time\tDepth\tLoad\n" + rows)

    def test_spreadsheet_of_texts(self):
        try:
            import openpyxl
        except ImportError:
            self.skipTest("python3-openpyxl is not installed")
        book = openpyxl.Workbook()
        book.active.append(["Zeit [s]", "Eindringtiefe [nm]", "Kraft [mN]", "Phase"])
        for row in zip(*self.columns):
            book.active.append([*(f"{value:.6f}".replace(".", ",") for value in row), "load"])
        book.save(self.folder / "texts.xlsx")
        self.check(read_curve(self.folder / "texts.xlsx"))


if __name__ == "__main__":
    unittest.main()
