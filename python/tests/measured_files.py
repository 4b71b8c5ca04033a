# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A made-up indent, for tests that write it as instruments do and read it again."""

import pathlib
import tempfile
import unittest

import numpy

from elasto_plastic_contact import UserError, read_curve


def indent():
    """Time in s, depth in nm and force in mN: load to 10 mN and 300 nm, hold, unload."""
    time = numpy.append(numpy.linspace(0., 10., 81),
                        numpy.append(numpy.linspace(10.2, 14.8, 20), numpy.linspace(15., 20., 41)))
    depth = numpy.interp(time, [0., 10., 15.], [0., 300., 306.])
    force = 10. * (numpy.minimum(depth, 300.) / 300.) ** 2
    unload = time > 15.
    force[unload] = 10. * (20. - time[unload]) / 5.
    depth[unload] = 246. + 60. * (force[unload] / 10.) ** (1. / 1.5)
    return time, depth, force


def rows_of(columns, separator="\t", decimal="."):
    return "".join(separator.join(f"{value:.6f}".replace(".", decimal) for value in row) + "\n"
                   for row in zip(*columns))


class FilesOfInstruments(unittest.TestCase):
    """Writes files to a folder of its own, and compares what is read with the indent."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.time, cls.depth, cls.force = indent()
        cls.columns = (cls.time, cls.depth, cls.force)

    def write(self, text, name="curve.txt", encoding="utf-8"):
        path = self.folder / name
        path.write_bytes(text if isinstance(text, bytes) else text.encode(encoding))
        return path

    def check(self, curves, n_indents=1):
        self.assertEqual(len(curves), n_indents)
        for curve in curves:
            numpy.testing.assert_allclose(curve.depth, 1e-3 * self.depth, atol=1e-6)
            numpy.testing.assert_allclose(curve.force, self.force, atol=1e-5)
            if curve.time is not None:
                numpy.testing.assert_allclose(curve.time, self.time, atol=1e-5)
        return curves

    def refused(self, pattern, text, *arguments, name="wrong.txt", **options):
        with self.assertRaisesRegex(UserError, pattern) as caught:
            read_curve(self.write(text, name) if text is not None else self.folder / name, *arguments, **options)
        self.assertIn(name, str(caught.exception))
