# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Readers of measured curves: a made-up indent in the formats of instruments, and messages."""

import unittest

import numpy
from measured_files import FilesOfInstruments, rows_of

from elasto_plastic_contact import UserError, read_curve


class Readers(FilesOfInstruments):
    def test_separators(self):
        for separator, decimal in (("\t", "."), (";", "."), (",", "."), (" ", "."), ("\t", ","), (";", ","), (" ", ","),
                                   ("   ", ".")):
            head = separator.join(["Time_s", "Depth_nm", "Load_mN"])
            text = f"Sample 7\n\n{head}\n{rows_of(self.columns, separator, decimal)}"
            self.check(read_curve(self.write(text)))

    def test_headings(self):
        for head in ("Time (s)\tDepth (nm)\tLoad (mN)", "Time [s]\tDisplacement Into Surface [nm]\tLoad On Sample [mN]",
                     "t/s\th/nm\tF/mN", "time in s\tdepth in nm\tforce in mN", "TIME\tDEPTH\tLOAD\ns\tnm\tmN",
                     "Time\tPd\tFn\n(s)\t(nm)\t(mN)", '"Time, s"\t"Depth, nm"\t"Force, mN"',
                     "Zeit [s]\tEindringtiefe [nm]\tKraft [mN]"):
            curve, = self.check(read_curve(self.write(f"{head}\n{rows_of(self.columns)}")))
            self.assertEqual(curve.units, {"time": "s", "depth": "µm", "force": "mN"})
        blanks = "Time (s)  Depth (nm)  Load (mN)\n" + rows_of(self.columns, "  ")
        self.check(read_curve(self.write(blanks)))
        voltages = "Depth (nm)\tLoad (µN)\tTime (s)\tDepth (V)\tLoad (V)\n"
        self.check(read_curve(self.write(voltages + rows_of((self.depth, 1e3 * self.force, self.time, self.time,
                                                             self.time)))))

    def test_encodings(self):
        rows = rows_of((self.time, 1e-3 * self.depth, 1e3 * self.force))
        text = f"Time (s)\tDepth (µm)\tLoad (µN)\n{rows}".replace("\n", "\r\n")
        for encoding in ("utf-8", "utf-8-sig", "latin-1", "utf-16", "utf-16-le", "utf-16-be"):
            self.check(read_curve(self.write(text, encoding=encoding)))
        self.check(read_curve(self.write(text.replace("\r\n", "\r"))))
        self.check(read_curve(self.write(text.replace("\r\n", "\r\r\n"))))
        self.check(read_curve(self.write(text.replace("µ", "μ"))))
        self.check(read_curve(self.write(text.replace("\r\n", "\n\n"))))

    def test_columns_and_units(self):
        for text in (rows_of(self.columns), "a\tb\tc\n" + rows_of(self.columns)):
            path = self.write(text)
            self.check(read_curve(path, {"time": 1, "depth": 2, "force": 3},
                                  {"time": "s", "depth": "nm", "force": "mN"}))
        self.check(read_curve(path, {"depth": "B", "force": "c"}, {"depth": "nm", "force": "mN"}))
        without = "Time\tDepth\tLoad\n" + rows_of(self.columns)
        self.check(read_curve(self.write(without), units={"time": "s", "depth": "nm", "force": "mN"}))
        curve, = self.check(read_curve(self.write(without), units={"depth": "nm", "force": "mN"}))
        self.assertIsNone(curve.time)
        self.assertIn("the unit of time is not known", curve.remarks[-1])
        two = "Time (s)\tDepth (nm)\tDepth (nm)\tLoad (mN)\n" + rows_of((self.time, self.time, self.depth, self.force))
        self.check(read_curve(self.write(two), {"depth": 3}))
        commas = "Time, s\tDepth, nm\tDepth 2, nm\tLoad, mN\n" + rows_of((self.time, self.depth, self.time, self.force))
        self.check(read_curve(self.write(commas), {"depth": "Depth, nm"}))

    def test_several_indents(self):
        one = "Depth (nm)\tLoad (mN)\tTime (s)\n" + rows_of((self.depth, self.force, self.time))
        curves = self.check(read_curve(self.write(f"Test 1\n{one}\nTest 2\n{one}")), 2)
        self.assertEqual([curve.name for curve in curves], ["Test 1", "Test 2"])
        self.check(read_curve(self.write(one + "\n" + rows_of((self.depth, self.force, self.time)))), 2)
        self.check(read_curve(self.write("Depth (nm)\tLoad (mN)\tDepth (nm)\tLoad (mN)\n"
                                         + rows_of((self.depth, self.force, self.depth, self.force)))), 2)
        curves = self.check(read_curve(self.write(one + rows_of((self.depth, self.force, self.time)))), 2)
        self.assertEqual(curves[1].remarks, ("another indent begins where the time begins again",))
        lines = one.splitlines(keepends=True)
        self.check(read_curve(self.write("".join([*lines[:90], "\n", *lines[90:]]))))

    def test_signs_and_gaps(self):
        head = "Time (s)\tDepth (nm)\tLoad (mN)\n"
        for depth, force in ((-self.depth, self.force), (-self.depth, -self.force), (self.depth, -self.force)):
            curve, = self.check(read_curve(self.write(head + rows_of((self.time, depth, force)))))
            self.assertIn("its sign has been turned", " ".join(curve.remarks))
        curve, = read_curve(self.write(head + rows_of((self.time, self.depth - 40., self.force))))
        self.assertEqual(curve.remarks, ())
        broken = head + rows_of(self.columns) + "20.1\t1.#QNAN\t0.1\n20.2\t1.79769E+308\t0.1\n"
        curve, = self.check(read_curve(self.write(broken)))
        self.assertEqual(curve.remarks, ("2 rows without a depth, force or time are left out",))

    def test_hysitron(self):
        rows = rows_of((self.depth, 1e3 * self.force, self.time))
        text = f"Mon Apr 29 10:41:06 2019\n\nNumber of Points = 142\nDepth (nm)\tLoad (µN)\tTime (s)\n{rows}"
        curve, = self.check(read_curve(self.write(text, encoding="latin-1")))
        self.assertEqual(curve.remarks, ())
        curve, = self.check(read_curve(self.write(text.replace("= 142", "= 200"))))
        self.assertEqual(curve.remarks, ("the file announces 200 points, and holds 142",))
        curves = self.check(read_curve(self.write(text + "\n" + text.replace("= 142", "= 150"))), 2)
        self.assertEqual([(curve.name, curve.remarks) for curve in curves],
                         [("1", ()), ("2", ("the file announces 150 points, and holds 142",))])
        joined = text.replace("Time (s)\n", "Time (s)\tForce Voltage(V)").replace("\n", "\t0.1\n")
        joined = joined.replace("= 142\t0.1", "= 142")
        curve, = self.check(read_curve(self.write(joined)))
        self.assertEqual(curve.remarks, ())
        head = ("File Version: Hysitron HighLoad FBControls 6.1 Release\nMachine Comp: 0.5 nm/µN\nTip Usable Depth: 1500 nm\n"
                "Tip C0: 24.5 nm^2/nm^2\nTip C1: 2000 nm^2/nm\nTip C2: 0 nm^2/nm^0.5\nTip C3: 0 nm^2/nm^0.25\n"
                "Tip C4: 0 nm^2/nm^0.125\nTip C5: 0 nm^2/nm^0.0625\nDrift Rate: 0.25 nm/s\n"
                "Sample Approach Data Points: 6\nTime_s\tMotorDisp_mm\tPiezo Extension_nm\n" + rows_of([range(6)] * 3)
                + "Drift Measurement Data Points: 6\nTime_s\tDisp_nm\n" + rows_of([range(6)] * 2)
                + "Test Data Points: 142\nTime_s\tDisp_nm\tForce_µN\tLoadCell_nm\n")
        text = head + rows_of((self.time, self.depth, 1e3 * self.force, self.time))
        curve, = self.check(read_curve(self.write(text, "test.hld", "latin-1")))
        numpy.testing.assert_allclose(curve.notes.area_function, (24.5, 2., 0., 0., 0., 0.))
        self.assertEqual((curve.notes.usable_depth, curve.notes.frame_compliance), (1.5, 0.5))
        self.assertAlmostEqual(curve.notes.drift_rate, 0.25e-3)
        self.refused("without 'Test Data Points': it holds no curve", head.partition("Test Data")[0])
        self.refused("announces 142 points in line [0-9]+, and holds none", head)

    def test_indents_of_hysitron(self):
        """Many, some without rows, each with what its own head says."""
        def indent(n_points=20, head="", mark="."):
            rows = "".join(f"{i}.5\t{i}.25\t{i}.125\n".replace(".", mark) for i in range(n_points))
            return f"{head}Number of Points = {n_points}\nDepth (nm)\tLoad (mN)\tTime (s)\n{rows}\n"

        curves = read_curve(self.write(indent() * 420))
        self.assertEqual([(curve.name, len(curve.depth), curve.remarks) for curve in (curves[0], curves[-1])],
                         [("1", 20, ()), ("420", 20, ())])
        curves = read_curve(self.write(indent() + indent(0) + indent(3) + indent()))
        self.assertEqual([curve.remarks for curve in curves],
                         2 * [("indents that hold no rows of numbers, and are left out: 2, of line 24, 27",)])
        self.refused("announces 0 points in line 1, and holds none", indent(0) + indent(0))
        curves = read_curve(self.write(indent() + indent(head="Drift Rate: 0.25 nm/s\nMachine Comp: 1,500.0 nm/mN\n") + indent()
                                       + indent(head="Drift Rate: 0,125 nm/s\n", mark=",")))
        self.assertEqual([curve.notes.drift_rate for curve in curves], [None, 0.25e-3, None, 0.125e-3])
        self.assertEqual([curve.notes.frame_compliance for curve in curves], [None, 1.5, None, None])

    def test_dynamic_test_of_hysitron(self):
        stiffness = 1. + 0.01 * self.depth
        text = ("nanoDMA Text Export Version 1.00\n\n Test Time (s)\t Indent Disp. (nm)\t Indent Act. Load (µN)\t Indent Load (µN)\t "
                "Storage Stiff. (µN/nm)\t Contact Depth (nm)\t\n")
        rows = rows_of((self.time, self.depth, self.time, 1e3 * self.force, stiffness, self.time)).replace("\n", "\t\n")
        curve, = self.check(read_curve(self.write(text + rows, encoding="latin-1")))
        numpy.testing.assert_allclose(curve.stiffness, stiffness, atol=1e-5)

    def test_fischerscope(self):
        first = "FS1.hap\tName of the application\nF = ESP n 10.000mN/20s\n1\tNumber of block\n"
        one = ("FS1.hap   26.05.2020  15:17:54\nIndenter shape correction: Hardness\nHIT\t[N/mm²]\t   8553.6\n"
               "EIT/(1-vs^2)\t[GPa]\t     83.7\nF\th\tt\n" + rows_of((self.force, 1e-3 * self.depth, self.time),
                                                                     decimal=","))
        curves = read_curve(self.write(first + one + "\n" + one, encoding="latin-1"))
        self.check(curves, 2)
        self.assertEqual([curve.name for curve in curves], ["1", "2"])
        self.assertAlmostEqual(curves[0].notes.hardness, 8.5536)
        self.assertEqual(curves[0].notes.plane_strain_modulus, 83.7)
        self.assertIn("are in mN, µm and s, as FischerScope writes them (the largest F is that of the head",
                      curves[0].remarks[0])
        curves = read_curve(self.write(first.replace("10.000", "500.0") + one))
        self.assertIn("the largest F is 10, and the head says 500 mN", curves[0].remarks[0])
        for date in ("05/26/2020  3:17:54 PM", "2020-05-26 15:17:54", "26-05-2020 15:17:54"):
            text = first + one.replace("26.05.2020  15:17:54", date).replace(",", ".")
            self.check(read_curve(self.write(text)))
        self.refused("with results, but without curves", first + one.partition("F\th")[0])
        lines = one.splitlines(keepends=True)
        self.check(read_curve(self.write("".join([first, *lines[:60], "\n", *lines[60:]]))))
        curves = read_curve(self.write(first + one + one.partition("F\th")[0] + one))
        self.assertEqual(curves[1].remarks[-1], "indents that hold no rows of numbers, and are left out: 1, of line 151")

    def test_numbers_of_fischerscope(self):
        """Those of the head, with marks as they are in some country."""
        def read(force, hardness, decimal):
            head = f"FS1.hap\tName of the application\nF = ESP n {force}mN/20s\nFS1.hap   05/26/2020  3:17:54 PM\n"
            rows = rows_of((self.force, 1e-3 * self.depth, self.time), decimal=decimal)
            curve, = self.check(read_curve(self.write(f"{head}HIT\t[N/mm²]\t{hardness}\nF\th\tt\n{rows}")))
            return curve

        for hardness, decimal, expected in (
                ("8,553", ".", 8.553), ("8,553.6", ".", 8.5536), ("8553.6", ".", 8.5536), ("8553,6", ",", 8.5536),
                ("8.553,6", ",", 8.5536), ("8,553", ",", 8.553e-3), ("8.553", ".", 8.553e-3), ("8553.6", ",", 8.5536)):
            with self.subTest(hardness=hardness, decimal=decimal):
                self.assertAlmostEqual(read("10", hardness, decimal).notes.hardness, expected)
        for force, decimal in (("10.000", ","), ("10.000", "."), ("10,000", ","), ("10", ".")):
            self.assertIn("the largest F is that of the head, 10 mN", read(force, "---", decimal).remarks[0])
        for force in ("10,000", "10,000.000"):
            self.assertIn("the largest F is 10, and the head says 10000 mN", read(force, "---", ".").remarks[0])
        curve = read("10.0.0", "8.5.3", ".")
        self.assertEqual((curve.notes.hardness, *curve.remarks[:2]),
                         (None, "the head says '10.0.0' for the largest F, which is no number",
                          "the head says '8.5.3' for HIT, which is no number"))

    def test_nanosuite(self):
        method = ("Method Name : C:\\Methods\\XP\\G-Series CSM.msm\nOwner : User\nChannels\n\tModulus\n\t\tUnits : GPa\n"
                  "\tContact Area\n\t\tUnits : nm^2\n\tTime\n\t\tUnits : s\n")
        self.refused("is the method 'G-Series CSM.msm' of NanoSuite, with its channels .Modulus, Contact Area, Time and so "
                     "on.*without a curve. Export the samples", method)
        self.refused("is a method of NanoSuite with rows of numbers", method + rows_of(self.columns))
        stiffness = numpy.where(self.depth > 0., 4. * self.depth, numpy.nan)
        rows = [[label, f"{h:.6f}", f"{p:.6f}", f"{t:.6f}", "" if numpy.isnan(s) else f"{s:.3f}"]
                for label, h, p, t, s in zip(["Surface Marker", *[""] * 80, "Hold Segment Type", *[""] * 60], self.depth,
                                             self.force, self.time, stiffness)]
        text = ("Test 1\nSegment\tDisplacement Into Surface\tLoad On Sample\tTime On Sample\tHarmonic Contact Stiffness\n"
                "\tnm\tmN\ts\tN/m\n" + "".join("\t".join(row) + "\n" for row in rows) + "END\n")
        curve, = self.check(read_curve(self.write(text)))
        numpy.testing.assert_allclose(curve.stiffness, 1e-3 * stiffness, atol=1e-5)
        text = text.replace("Displacement Into Surface", "Raw Displacement\tDisplacement Into Surface")
        self.refused("6 columns by its heading in line 2, but 5 values in line 4", text)

    def test_spreadsheets(self):
        try:
            import openpyxl
        except ImportError:
            self.skipTest("python3-openpyxl is not installed")
        book = openpyxl.Workbook()
        book.active.title = "Required Inputs"
        book.active.append(["Poissons Ratio", 0.2])
        for name in ("Test 001", "Test 002"):
            sheet = book.create_sheet(name)
            sheet.append(["Segment", "Displacement Into Surface", "Load On Sample", "Time On Sample"])
            sheet.append([None, "nm", "mN", "s"])
            for row in zip(self.depth, self.force, self.time):
                sheet.append([None, *map(float, row)])
            sheet.append(["END"])
        book.save(self.folder / "tests.xlsx")
        curves = self.check(read_curve(self.folder / "tests.xlsx"), 2)
        self.assertEqual([curve.name for curve in curves], ["Test 001", "Test 002"])
        book = openpyxl.Workbook()
        book.save(self.folder / "empty.xlsx")
        self.refused("has no rows of numbers on any sheet", None, name="empty.xlsx")
        self.refused("is damaged, or no .xlsx", b"PK\x03\x04 xl/ nothing", name="damaged.xlsx")

    def test_old_spreadsheets(self):
        try:
            import xlrd  # noqa: F401 (it reads the file)
        except ImportError:
            self.skipTest("python3-xlrd is not installed")
        self.refused("is damaged, or no .xls", b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1" + bytes(600), name="damaged.xls")
        try:
            import xlwt
        except ImportError:
            self.skipTest("python3-xlwt, which writes such a file, is not installed")
        book = xlwt.Workbook()
        book.add_sheet("Results").write(0, 0, "Modulus")
        for name in ("Test 1", "Test 1 Tagged"):
            sheet = book.add_sheet(name)
            table = [["Segment", "Displacement Into Surface", "Load On Sample", "Time On Sample"], ["", "nm", "mN", "s"],
                     *[["", *map(float, row)] for row in zip(self.depth, self.force, self.time)], ["END", "", "", ""]]
            for i, row in enumerate(table):
                for j, value in enumerate(row):
                    sheet.write(i, j, value)
        book.save(str(self.folder / "tests.xls"))
        self.check(read_curve(self.folder / "tests.xls"))

    def test_hdf5(self):
        try:
            import h5py
        except ImportError:
            self.skipTest("python3-h5py is not installed")
        with h5py.File(self.folder / "tests.hdf5", "w") as file:
            file.attrs["uri"] = "https://example.org/xls2hdf.py"
            for name in ("test_1", "test_2", "test_10"):
                data = file.create_group(f"{name}/data")
                for column, values in (("displacement_into_surface", self.depth), ("load_on_sample", self.force),
                                       ("time_on_sample", self.time)):
                    data[column] = values
        curves = self.check(read_curve(self.folder / "tests.hdf5"), 3)
        self.assertEqual([curve.name for curve in curves], ["test_1", "test_2", "test_10"])
        self.assertIn("nm of depth", curves[0].remarks[-1])
        with h5py.File(self.folder / "units.hdf5", "w") as file:
            data = file.create_group("test_1/data")
            for column, values, unit in (("depth", 1e-9 * self.depth, "m"), ("load", 1e-3 * self.force, "N"),
                                         ("time", self.time, "s")):
                data[column] = values
                data[column].attrs["unit"] = unit
        self.check(read_curve(self.folder / "units.hdf5"))
        self.refused("has no column 'x' in test_1; it has depth, load, time", None, {"depth": "x"}, name="units.hdf5")
        with h5py.File(self.folder / "others.hdf5", "w") as file:
            file.create_group("test_1/data")["a"] = self.depth
        self.refused("has no columns of depth and force in test_1, but a", None, name="others.hdf5")
        with h5py.File(self.folder / "none.hdf5", "w") as file:
            file["a"] = self.depth
        self.refused("an HDF5 file without groups test_1, .*; it has a", None, name="none.hdf5")
        self.refused("is damaged, or no HDF5", b"\x89HDF\r\n\x1a\n" + bytes(100), name="damaged.hdf5")
        with h5py.File(self.folder / "lengths.hdf5", "w") as file:
            data = file.create_group("test_1/data")
            data["depth"], data["load"] = self.depth, self.force[1:]
        self.refused("is damaged, or no HDF5 that is known: ", None, name="lengths.hdf5")

    def test_what_is_not_understood(self):
        rows = rows_of(self.columns)
        head = "Time (s)\tDepth (nm)\tLoad (mN)\n"
        for nothing in (b" \n", b"\xef\xbb\xbf", b"\xff\xfe"):
            self.refused("is empty", nothing)
        self.refused("cannot be read: No such file", None, name="not_there.txt")
        self.refused("is in no format that is known: .xls and .xlsx, HDF5", bytes(range(256)) * 20)
        self.refused("holds no rows of numbers; line 2 is 'some words'", "\nsome words\nand others\n")
        self.refused("does not say what its columns are; line 1 holds 0, 0, 0. Say .*--columns depth=1,force=2", rows)
        self.refused("has no column that is known as depth and force; line 1 names a, b, c. Say", "a\tb\tc\n" + rows)
        self.refused("has no column that is known as depth; line 1 names time, x, load. Say", "time\tx\tload\n" + rows)
        self.refused("does not say the unit of depth .column 'Depth'. nor of force .column 'Load'.: give it, such as "
                     "by --unit depth=nm --unit force=mN", "Time (s)\tDepth\tLoad\n" + rows)
        self.refused("says that its unit of depth is nm .*, and --unit depth=µm says otherwise", head + rows,
                     units={"depth": "um"})
        self.refused("has several columns for depth in line 1: 'Depth \\(nm\\)' \\(2\\), 'Depth \\(nm\\)' \\(3\\). Choose "
                     "by --columns depth=2",
                     "Time (s)\tDepth (nm)\tDepth (nm)\tLoad (mN)\n" + rows_of((self.time, *self.columns)))
        self.refused("no column 'x'; it has Time .s., Depth", head + rows, {"depth": "x", "force": 3})
        self.refused("has 3 columns in line 2, and none with the number 7", head + rows, {"depth": 7, "force": 3})
        self.refused("has 3 columns by its heading in line 1, but 6 values in line 2: decimal commas between commas",
                     head.replace("\t", ",") + rows_of(self.columns, ",", ","))
        lines = (head + rows).splitlines(keepends=True)
        self.refused("has a text in place of a number in line 51: '1.2.3'",
                     "".join([*lines[:50], "3.0\t1.2.3\t4.0\n", *lines[50:]]))
        self.refused("has 2 values in line 51, and 3 in the lines before",
                     "".join([*lines[:50], "3.0\t4.0\n", *lines[50:]]))
        self.refused("has 0 complete rows of depth and force in the indent '1'", head + "1\t\t2\n" * 20)
        self.refused("has the force 0 in all rows of the indent '1', in the column 'Load .mN.': that is no curve",
                     head + "".join(f"{i}\t{i}\t0\n" for i in range(9)))
        self.refused("holds results, one row an indent, and no curve", "C (GPa),hm (um),Wp/Wt\n" + "1,2,3\n" * 6,
                     name="results.csv")
        path = self.write(head + rows)
        for options, message in (({"columns": {"deep": 1}}, "--columns is 'deep=1', but must be like depth=2,force=3"),
                                 ({"units": {"depth": "mN"}}, "--unit is 'depth=mN', but units of depth are pm, Å, nm"),
                                 ({"units": {"deep": "nm"}},
                                  "--unit is 'deep=nm', but must begin with one of time, depth")):
            with self.assertRaisesRegex(UserError, message):
                read_curve(path, **options)


if __name__ == "__main__":
    unittest.main()
