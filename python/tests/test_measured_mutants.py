# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files of instruments that are cut off or changed somewhere give the rows that are left, or one message."""

import random
import re
import unittest

import numpy
from measured_files import FilesOfInstruments, rows_of

from elasto_plastic_contact import UserError, read_curve

N_MUTANTS = 200

# Of the points of the indent.
STEP = 4

OTHER_MARKS = str.maketrans(".,", ",.")


def texts(time, depth, force):
    """Of an indent in s, nm and mN, as instruments and spreadsheets write it."""
    numbers = (time, depth, force)
    thousands = "".join("\t".join(f"{value:,.3f}" for value in row) + "\n" for row in zip(time, 10. * depth, 1e3 * force))
    with_units = "".join(f"{t:.5f} s\t{h:.5f} nm\t{F:.5f} mN\n" for t, h, F in zip(*numbers))
    return (
        f"Number of Points = {len(time)}\nTime (s)\tDepth (nm)\tLoad (mN)\n{rows_of(numbers)}",
        "FS1.hap\tName of the application\nF = ESP n 10.000mN/20s\nFS1.hap   26.05.2020  15:17:54\nHIT\t[N/mm²]\t8553.6\n"
        f"t\th\tF\n{rows_of((time, 1e-3 * depth, force), decimal=',')}",
        f"Time (s),Depth (nm),Load (mN)\n{rows_of(numbers, ',')}",
        f"Zeit (s);Tiefe (nm);Kraft (mN)\n{rows_of(numbers, ';', ',')}",
        f"Time (s)  Depth (nm)  Load (mN)\n{rows_of(numbers, '  ')}",
        f"时间（s）；位移（nm）；载荷（mN）\n{rows_of(numbers, '；', ',')}",
        f"Time (s)\tDepth (Å)\tLoad (µN)\n{thousands}",
        f"Time\tDepth\tLoad\n{with_units}")


def cut_off(text, place):
    return text[:place]


def without_a_part(text, place):
    return text[:place] + text[place + 70:]


def with_other_marks(text, place):
    """In all lines of numbers."""
    del place
    return "".join(line.translate(OTHER_MARKS) if line[0].isdigit() else line for line in text.splitlines(keepends=True))


def with_other_marks_behind(text, place):
    return text[:place] + text[place:].translate(OTHER_MARKS)


def with_other_marks_in_a_line(text, place):
    begin, end = text.rfind("\n", 0, place) + 1, text.find("\n", place)
    return text[:begin] + text[begin:end].translate(OTHER_MARKS) + text[end:]


SHORTER = cut_off, without_a_part


class Mutants(FilesOfInstruments):
    def agrees(self, curve, n_wrong):
        """All its rows but so many are rows of the indent."""
        distances = numpy.hypot((curve.depth[:, None] - 1e-3 * self.depth) / 0.3, (curve.force[:, None] - self.force) / 10.)
        self.assertLessEqual(numpy.count_nonzero(distances.min(axis=1) > 1e-3), n_wrong)

    def test_mutants(self):
        rng = random.Random(1)
        originals = texts(*(values[::STEP] for values in self.columns))
        mutations = *SHORTER, with_other_marks, with_other_marks_behind, with_other_marks_in_a_line
        n_read = 0
        for i in range(N_MUTANTS):
            original, mutate = originals[i % len(originals)], mutations[i % len(mutations)]
            with self.subTest(original=original[:30], mutation=mutate.__name__, i=i):
                path = self.write(mutate(original, rng.randrange(len(original))))
                try:
                    curves = read_curve(path)
                except UserError as error:
                    self.assertTrue(re.match(r"'.*curve.txt' \w", str(error)) and "\n" not in str(error), str(error))
                    continue
                n_read += 1
                for curve in curves:  # (where a number has been cut, there may be another one)
                    self.agrees(curve, n_wrong=int(mutate in SHORTER))
                n_rows = sum(len(curve.depth) for curve in curves)
                if mutate not in SHORTER:
                    self.assertTrue(n_rows == len(self.time[::STEP]) or any(curve.remarks for curve in curves))
        self.assertGreater(n_read, N_MUTANTS // 4)


if __name__ == "__main__":
    unittest.main()
