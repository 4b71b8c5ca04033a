# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What exports of instruments and spreadsheets do with numbers, words, times, names of columns and parts of an indent."""

import unittest
import zipfile

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
        rows = "".join(f"{h:,.0f} pm\t{F:,.0f} nN\n" for h, F in zip(1e3 * self.depth, 1e6 * self.force))
        self.check(read_curve(self.write("Depth\tLoad\n" + rows)))
        three_decimals = "".join(f"{h:.3f}\t{F:.3f}\n".replace(".", ",") for h, F in zip(self.depth, self.force))
        curve, = read_curve(self.write("Depth (nm)\tLoad (mN)\n" + three_decimals))
        numpy.testing.assert_allclose(curve.depth, 1e-3 * self.depth, atol=1e-6)
        with_zeros = "".join("\t".join(f"{value:.3f}".replace(".", ",") if value >= 1. else "0" for value in row) + "\n"
                             for row in zip(self.depth, self.force))
        curve, = read_curve(self.write("Depth (nm)\tLoad (mN)\n" + with_zeros))
        self.assertAlmostEqual(curve.depth.max(), 0.306, delta=1e-5)
        self.assertAlmostEqual(curve.force.max(), 10., delta=1e-3)

        rows = "".join(f"{h:,.0f}\t{F:,.0f}\n" for h, F in zip(10. * self.depth, 1e3 * self.force))
        for text in (rows, rows.replace(",", ".")):
            curve, = read_curve(self.write("Depth (Å)\tLoad (µN)\n" + text))
            numpy.testing.assert_allclose(curve.depth, 1e-3 * self.depth, atol=1e-4)
            numpy.testing.assert_allclose(curve.force, self.force, atol=1e-3)

        temperatures = (23, 23.125, 23.25, 23.125, 23.25, 23.125, 23.25, 23.125)
        rows = "".join(f"{i}.125\t{i}.250\t{temperatures[i % 8]:g}\n" for i in range(1, 60))
        for text in (rows, rows.replace(".", ",")):
            curve, = read_curve(self.write("Depth (nm)\tLoad (mN)\tTemperature (°C)\n" + text))
            self.assertAlmostEqual(curve.depth[0], 1.125e-3)
            self.assertEqual(curve.force[-1], 59.25)

    def test_decimals_in_the_first_column_alone(self):
        """Where a text without decimal points might be the name of a segment."""
        rows = "".join(f"{i / 2:g}\t{i}\t{i}\n" for i in range(20))
        for text in (rows, rows.replace(".", ",")):
            curve, = read_curve(self.write(HEAD + text))
            self.assertEqual((list(curve.time), curve.remarks), ([i / 2 for i in range(20)], ()))

    def test_separators_of_other_fonts(self):
        """Of numbers with decimal commas, some or all, and with commas that separate thousands."""
        head = "时间（s）；位移（nm）；载荷（mN）\n"
        for form in ("{:g}", "{:.6f}"):
            rows = "".join("；".join(form.format(round(value, 4)).replace(".", ",") for value in row) + "\n"
                           for row in zip(*self.columns))
            curve, = read_curve(self.write(head + rows))
            numpy.testing.assert_allclose(curve.depth, 1e-3 * self.depth, atol=1e-6)
            self.assertEqual(curve.remarks, ())
        rows = "".join(f"{h:,.0f}，{F:,.0f}\n" for h, F in zip(10. * self.depth, 1e3 * self.force))
        self.refused("has 3 values in line [0-9]+, and 2 in the lines before", "位移（Å），载荷（µN）\n" + rows)

    def test_what_is_left_out(self):
        """Nothing is without a remark."""
        text = HEAD + rows_of(self.columns)
        for more, remark in (("Repeated\n1\t2\t3\n2\t3\t4\n", "lines of numbers that are in no table of 5 rows, and left out: 2, the "
                                                            "first one is line 145"),
                             ("Repeated\n1:2:3\n", "lines of numbers that are in no table of 5 rows, and left out: 1, the first one is "
                                                   "line 145"),
                             ("Sensor\ta\tb\n" + "1\t2\t3\n" * 5, "tables whose columns are not known as depth and force, and left "
                              "out: 1, the first one has 5 rows from line 145 on, and the columns Sensor, a, b"),
                             ("Repeated\n0.5,1.5,2.5\n", "lines of numbers that are in no table of 5 rows, and left out: 1, the first one is "
                                                       "line 145"),
                             ("Repeated on 2026-11-29\n2026-11-29 12:00:00\n29.11.2026\n", None)):
            with self.subTest(more=more):
                curve, = self.check(read_curve(self.write(text + more)))
                self.assertEqual(curve.remarks, (remark,) if remark else ())

    def test_long_heads(self):
        """A few rows below many lines of words, and lines of which every other one is empty."""
        curve, = read_curve(self.write("words\n" * 9000 + HEAD + "".join(f"{i}\t{i}\t{i}\n" for i in range(20))))
        self.assertEqual(len(curve.depth), 20)
        rows = "".join(f"{i}\t{i}\t{i}\n\n" for i in range(4000))
        curve, = read_curve(self.write(f"\n{HEAD}\n{rows}"))
        self.assertEqual(len(curve.depth), 4000)

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
                     "Time t (s)  Depth, h (nm)  Load P (mN)", "Zeit in s  Normalweg in nm  Normalkraft in mN",
                     "Time s  Normal displacement nm  Normal force mN", "Time (s)  Extension (nm)  Load (mN)",
                     "Time (seconds)  Depth (Nanometers)  Force (millinewtons)"):
            with self.subTest(head=head):
                curve, = self.check(read_curve(self.write(f"{head}\n{rows_of(self.columns, '  ')}")))
                self.assertIsNotNone(curve.time)
        self.check(read_curve(self.write("s\tnm\tmN\nTime\tDepth\tLoad\n" + rows_of(self.columns))))
        for head in ("# Time (s), Depth (nm), Load (mN)", "时间（s），位移（nm），载荷（mN）"):
            for separator in ("\t", " ", ";"):
                with self.subTest(head=head, separator=separator):
                    self.check(read_curve(self.write(f"{head}\n{rows_of(self.columns, separator)}")))

    def test_numbers_with_units(self):
        def text(separator, mark):
            return "".join(separator.join(f"{value:.5f} {unit}".replace(".", mark) for value, unit in
                                          zip(row, ("s", "nm", "mN", "%"))) + "\n"
                           for row in zip(*self.columns, self.time))

        for head, separator, mark in (("Time\tDepth\tLoad\tShare\n", "\t", "."), ("Zeit;Tiefe;Kraft;Anteil\n", ";", ","),
                                      ("Time,Depth,Load,Share\n", ",", ".")):
            self.assertIsNotNone(self.check(read_curve(self.write(head + text(separator, mark))))[0].time)
        self.check(read_curve(self.write(head + text(",", ".").replace(" ", "\u00a0"))))
        lines = (head + text(",", ".")).splitlines(keepends=True)
        self.refused("has numbers in 'µm' in line 51, and in 'nm' in line 2: write each column in one unit, behind all its "
                     "numbers or in its heading", "".join([*lines[:50], lines[50].replace("nm", "µm"), *lines[51:]]))

    def test_other_languages(self):
        """Words and encodings of instruments; what else is written is named with what to say."""
        for head, encodings in (
                ("時間[s],押込み深さ[nm],試験力[mN]", ("cp932", "utf-8", "utf-16")), ("時間（ms）,変位（nm）,荷重（mN）", ("cp932",)),
                ("时间(s),位移(nm),载荷(mN)", ("gb18030", "utf-8-sig")), ("时间（s）,压入深度（nm）,压入载荷（mN）", ("gb18030",)),
                ("Zeit [s],Eindringtiefe Pd [nm],Normalkraft Fn [mN]", ("latin-1",)), ("Zeit in s,Weg in nm,Last in mN", ("utf-8",)),
                ("Temps [s],Déplacement [nm],Charge [mN]", ("latin-1", "utf-8")), ("Temps [s],Enfoncement [nm],Effort [mN]", ("utf-8",)),
                ("时间，s,深度，nm,载荷，mN", ("gb18030",)), ("時間（s）,変位（h，nm）,荷重（P，mN）", ("cp932",)),
                ("时间（s），位移（nm），载荷（mN）", ("gb18030",))):
            for encoding in encodings:
                with self.subTest(head=head, encoding=encoding):
                    time = 1e3 * self.time if "ms" in head else self.time
                    text = f"{head}\n{rows_of((time, self.depth, self.force), ',')}"
                    self.assertIsNotNone(self.check(read_curve(self.write(text, encoding=encoding)))[0].time)
        for encoding in ("cp932", "gb18030"):  # (a µ alone)
            text = f"Time[s]\tDepth[μm]\tForce[mN]\n{rows_of((self.time, 1e-3 * self.depth, self.force))}"
            self.check(read_curve(self.write(text, encoding=encoding)))
        self.refused("has no column that is known as depth and force; line 1 names 시간, 깊이, 하중. Say which columns they are, "
                     "by their numbers or names: --columns depth=1,force=2", "시간\t깊이\t하중\n" + rows_of(self.columns))

    def test_texts_of_instruments(self):
        """Made up in the style of Anton Paar, CSM, FemtoTools, Alemnis, Shimadzu, Elionix, Fischer, KLA, UMIS, Micro
        Materials, Optics11."""
        t, h, F = self.columns
        numbers = range(len(t))
        parts = [rows_of((t[part], h[part], F[part])) for part in (slice(81), slice(81, 101), slice(101, None))]
        csm = "".join(f"\n*** {name}\nTime\tPd\tFn\n[s]\t[nm]\t[mN]\n{rows}" for name, rows in
                      zip(("Loading", "Pause", "Unloading"), parts))
        markers = ["Surface Index", *[""] * 80, "Hold Segment Type", *[""] * 59, "END"]
        kla = "".join(f"{marker},{row}\n" for marker, row in zip(markers, rows_of((h, F, t), ",").splitlines()))
        for text in (
                "Indentation 9.0\nMax load\t10.00\tmN\nTime [s]\tPenetration Depth [nm]\tForce Sensor [mN]\n"
                + rows_of(self.columns),
                f"CSM Instruments SA\n\nAcquisition Rate [Hz]: 10.00\n{csm}",
                "Name;Test 1\nPoint;Time [s];Depth [nm];Force (Fn) [mN]\n" + rows_of((numbers, t, h, F), ";"),
                "Sensor: FT-S200000\n\nIndex\tPhase\tTime [s]\tPos Z [um]\tDisplacement [nm]\tForce A [uN]\tForce B [uN]\n"
                + rows_of((numbers, 0. * t, t, 1e-3 * h, h, 1e3 * F, 0. * F)),
                "time_s\tload_mN\tdisplacement_um\traw_disp_um\n" + rows_of((t, F, 1e-3 * h, 1e-3 * h)),
                '"DUH-211S"\n"Loading speed","1.0","(0.7303[mN/sec])"\n"SEQ","Force[mN]","Depth[um]","Time[sec]"\n'
                + rows_of((numbers, F, 1e-3 * h, t), ","),
                "ENT-1100\nStep,500,20 ms\nNo,Displacement(nm),Load(mgf),Time(ms)\n"
                + rows_of((numbers, h, F / 9.80665e-3, 1e3 * t), ","),
                "HM2000\nNr.\tF / mN\th / µm\tt / s\n" + rows_of((numbers, F, 1e-3 * h, t), decimal=","),
                f"Segment,Displacement Into Surface,Load On Sample,Time On Sample\n,nm,mN,s\n{kla}",
                f"Test 1\nSegment,Displacement Into Surface nm,Load On Sample mN,Time On Sample s\n{kla}",
                "Tip radius (um)\t50\n\nTime (s)\tLoad (uN)\tIndentation (nm)\tCantilever (nm)\tPiezo (nm)\tAuxiliary\n"
                + rows_of((t, 1e3 * F, h, h, h, t), decimal=","),
                "UMIS\nPn (mN)\th (µm)\n" + rows_of((F, 1e-3 * h))):
            with self.subTest(text=text[:60]):
                self.check(read_curve(self.write(text)))
        self.check(read_curve(self.write("Indent 1,,Indent 2,\nDepth (nm),Load (mN),Depth (nm),Load (mN)\n"
                                         + rows_of((h, F, h, F), ","))), 2)

    def test_spreadsheets_of_instruments(self):
        """Made up in the style of Zwick and of Nanomechanics."""
        t, h, F = (values.tolist() for values in self.columns)
        zwick = [["Prüfzeit", "Standardweg", "Standardkraft"], ["s", "mm", "N"],
                 *([a, 1e-6 * b, 1e-3 * c] for a, b, c in zip(t, h, F))]
        with_phase = [["TIME / s", "DEPTH / nm", "LOAD / mN", "Test phase"], *([*row, "load"] for row in zip(t, h, F))]
        with_markers = [["MARKERS", "TIME", "DEPTH", "LOAD"], [None, "s", "nm", "mN"],
                        *(["END" if row[0] == t[-1] else None, *row] for row in zip(t, h, F))]
        beside = [["Test 1", None, None, "Test 2", None, None], 2 * ["TIME", "DEPTH", "LOAD"], 2 * ["s", "nm", "mN"],
                  *([*row, *row] for row in zip(t, h, F))]
        for sheets, n_indents in (({"Ergebnisse": [["", "HM"], ["", "N/mm²"], ["Probe 1", 4000.]], "Werte": zwick}, 1),
                                  ({"Inputs": [["Target Load / mN", 10.]], "Test 1": with_phase}, 1),
                                  ({"Test 1": with_markers, "Test 2": with_markers}, 2), ({"Data": beside}, 2)):
            with self.subTest(sheets=sheets.keys()):
                self.check(read_curve(self.spreadsheet(sheets)), n_indents)

    def test_sheets_of_raw_channels(self):
        """Of the same indent: they are no further ones, unless their columns are asked for."""
        t, h, F = (values.tolist() for values in self.columns)
        shown = [["Time (s)", "Depth (nm)", "Load (mN)"], *zip(t, h, F)]
        raw = [["Time (s)", "Raw displacement (nm)", "Raw load (mN)"], *([a, b + 5000., -c] for a, b, c in zip(t, h, F))]
        path = self.spreadsheet({"Test 1": shown, "Channels": raw})
        curve, = self.check(read_curve(path), 1)
        self.assertIn("the sheet 'Channels' is left out: others name depth and force better", curve.remarks)
        self.assertEqual(len(read_curve(path, {"time": 1, "depth": 2, "force": 3})), 2)
        self.check(read_curve(self.spreadsheet({"Channels": [raw[0], *shown[1:]]})), 1)

    def test_archives(self):
        """A file for each indent, with bare numbers as Micro Materials writes them."""
        def archive(files):
            with zipfile.ZipFile(self.folder / "tests.zip", "w") as written:
                for name, text in files.items():
                    written.writestr(name, text)
            return self.folder / "tests.zip"

        bare, headed = rows_of(self.columns), HEAD + rows_of(self.columns)
        curves = self.check(read_curve(archive({"a/Indent 1.txt": headed, "a/Indent 2.txt": headed})), 2)
        self.assertEqual([curve.name for curve in curves], ["Indent 1", "Indent 2"])
        curves = self.check(read_curve(archive({"a/1.txt": headed, "b/1.txt": headed, "b/2.txt": headed})), 3)
        self.assertEqual([curve.name for curve in curves], ["a/1.txt", "b/1.txt", "2"])
        self.check(read_curve(archive({"1.txt": bare, "2.txt": bare}), {"time": 1, "depth": 2, "force": 3},
                              {"time": "s", "depth": "nm", "force": "mN"}), 2)
        for files, message in (({"1.txt": bare}, "tests.zip/1.txt' does not say what its columns are"), ({"a/": ""}, "without files"),
                               ({"r.csv": "C (GPa),hm (um),Wp/Wt\n" + "1,2,3\n" * 6}, "take it out of the archive")):
            archive(files)
            self.refused(message, None, name="tests.zip")
        self.refused("is damaged, or no .zip", b"PK\x03\x04 nothing", name="damaged.zip")
        with zipfile.ZipFile(self.folder / "lzma.zip", "w", zipfile.ZIP_LZMA) as written:
            written.writestr("1.txt", headed)
        data = bytearray((self.folder / "lzma.zip").read_bytes())
        data[60:400:5] = bytes(68)
        self.refused("is damaged, or no .zip", bytes(data), name="damaged.zip")

    def spreadsheet(self, sheets):
        """The path of a spreadsheet with these rows on each sheet."""
        try:
            import openpyxl
        except ImportError:
            self.skipTest("python3-openpyxl is not installed")
        book = openpyxl.Workbook()
        book.remove(book.active)
        for name, rows in sheets.items():
            sheet = book.create_sheet(name)
            for row in rows:
                sheet.append(row)
        book.save(self.folder / "sheets.xlsx")
        return self.folder / "sheets.xlsx"

    def test_spreadsheet_of_texts(self):
        rows = [[*(f"{value:.6f}".replace(".", ",") for value in row), "load"] for row in zip(*self.columns)]
        self.check(read_curve(self.spreadsheet({"Messung": [["Zeit [s]", "Eindringtiefe [nm]", "Kraft [mN]", "Phase"], *rows]})))


if __name__ == "__main__":
    unittest.main()
