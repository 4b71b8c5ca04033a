# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What pictures are made of: continuous fields, outer faces, outlines, cycles, and the files."""

import contextlib
import io
import math
import pathlib
import re
import shutil
import tempfile
import types
import unittest
import unittest.mock
import warnings

import numpy

from elasto_plastic_contact import Results, run
from elasto_plastic_contact.__main__ import main
from elasto_plastic_contact.pictures import indenter, skin
from elasto_plastic_contact.pictures.contact import contact_at
from elasto_plastic_contact.pictures.joined import Joined
from elasto_plastic_contact.plots import curves, experiment, figures, friction, study
from elasto_plastic_contact.plots.cycles import turning_points
from elasto_plastic_contact.plots.quantities import scales_of

CORNERS = numpy.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], float)
CUBE = numpy.concatenate([CORNERS, CORNERS + [0, 0, 1]])


def written_one_by_one(cell, places):
    """Points and cells, as the program writes them: cells (corner and size) that share no points."""
    points = numpy.concatenate([size * cell + place for place, size in places])
    return points, numpy.arange(len(points)).reshape(-1, len(cell))


class ContinuousFields(unittest.TestCase):
    """A square of size 1, and two of size 1/2 beside it."""
    points, cells = written_one_by_one(CORNERS, [([0, 0, 0], 1.), ([1, 0, 0], .5), ([1, .5, 0], .5)])

    def at(self, values, x, y):
        there = numpy.flatnonzero((self.points[:, :2] == (x, y)).all(axis=1))
        return values[there]

    def test_hanging_node(self):
        values = Joined(self.points, self.cells)(numpy.repeat([1., 2., 6.], 4))
        numpy.testing.assert_allclose(self.at(values, 1, 0), 1.5)
        numpy.testing.assert_allclose(self.at(values, 1, 1), 3.5)
        numpy.testing.assert_allclose(self.at(values, 1, .5), 2.5)  # between these, not (2 + 6) / 2
        numpy.testing.assert_allclose(self.at(values, 1.5, .5), 4.)

    def test_materials_keep_apart(self):
        values = Joined(self.points, self.cells, numpy.repeat([0., 1., 1.], 4))(numpy.repeat([1., 2., 6.], 4))
        numpy.testing.assert_allclose(sorted(self.at(values, 1, 0)), [1, 2])
        numpy.testing.assert_allclose(self.at(values, 1, .5), 4.)


class OuterFaces(unittest.TestCase):
    def test_large_beside_small(self):
        """No face inside is left, and none outside is missing: a cube of size 1 and eight of size 1/2."""
        small = [([1 + .5 * i, .5 * j, .5 * k], .5) for i in (0, 1) for j in (0, 1) for k in (0, 1)]
        points, cells = written_one_by_one(CUBE, [([0, 0, 0], 1.), *small])
        faces = points[skin.outer_faces(points, cells)]
        areas = 0.5 * numpy.cross(faces[:, 2] - faces[:, 0], faces[:, 3] - faces[:, 1])
        self.assertAlmostEqual(numpy.linalg.norm(areas, axis=1).sum(), 10.)
        numpy.testing.assert_allclose(areas.sum(axis=0), 0., atol=1e-14)
        self.assertEqual(len(faces), 5 + 5 * 4)

    def test_cut(self):
        points, cells = written_one_by_one(CUBE, [([0, 0, 0], 1.), ([0, 1, 0], 1.)])
        self.assertEqual(skin.cut_away(points, cells, "y", [0, 1, 0]).tolist(), [list(range(8, 16))])


class Distances(unittest.TestCase):
    def test_curved_boundary(self):
        """Along a plane body's boundary that rises, x alone counts; in space, both horizontal directions."""
        points = numpy.array([[0., 0., 0.], [3., 4., 0.]])
        self.assertEqual(curves.distance_from_axis(points, [1., 0.], 2).tolist(), [-1., 2.])
        self.assertEqual(curves.distance_from_axis(points, [0., 0.], 3).tolist(), [0., 5.])


class Outlines(unittest.TestCase):
    def profile(self, shape, distance, **entries):
        entries = {name.replace("_", " "): value for name, value in entries.items()}
        results = types.SimpleNamespace(
            parameters={"Indenter/Type": shape},
            number=lambda path: entries[path.removeprefix("Indenter/")],
            numbers=lambda path: entries.get(path.removeprefix("Indenter/"), []))
        return numpy.interp(distance, *indenter.profile(results))

    def test_shapes(self):
        self.assertAlmostEqual(self.profile("sphere", 0.6, Radius=1.), 0.2, places=5)
        self.assertAlmostEqual(self.profile("cylinder", -0.6, Radius=1.), 0.2, places=5)
        self.assertAlmostEqual(self.profile("paraboloid", 0.5, Radius=2.), 0.0625, places=5)
        self.assertAlmostEqual(self.profile("wedge", 0.5, **{"Semi-apex angle": 45.}), 0.5)
        spheroconical = {"Radius": 1., "Semi-apex angle": 53.13010235415598}  # its sine is 0.8
        self.assertAlmostEqual(self.profile("spheroconical tip", -0.28, **spheroconical), 0.04, places=5)
        self.assertAlmostEqual(self.profile("spheroconical tip", 0.6 + 0.8, **spheroconical), 0.2 + 0.6)
        self.assertAlmostEqual(self.profile("area function", 0.6, Area_coefficients=[math.pi]), 0.6, places=5)
        self.assertEqual(self.profile("strip punch", 0.9, Half_width=1.), 0.)
        self.assertGreater(self.profile("circular punch", 1.1, Radius=1.), 100.)
        self.assertIsNone(indenter.profile(types.SimpleNamespace(parameters={"Indenter/Type": "image"})))


class Cycles(unittest.TestCase):
    def test_turning_points(self):
        peaks, valleys = turning_points(numpy.array([5., 20., 10., 1., 9., 20., 1., 12.]))
        self.assertEqual((list(peaks), list(valleys)), ([1, 5, 7], [3, 6]))
        peaks, valleys = turning_points(numpy.array([20., 1., 20., 1.]))
        self.assertEqual((list(peaks), list(valleys)), ([0, 2], [1, 3]))


class Files(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.cone = cls.folder / "cone"
        run("indentation/cone_axisymmetric.prm", cls.cone, {
            "Geometry/Local refinements": 4, "Geometry/Local radius": 4, "Refinement/Elements over contact radius": 0,
            "Loading/History": "1: depth 0.05 | 2: force 0 | 3: depth 0.05 | 4: force 0",
            "Loading/Number of steps": 12})

    def draw(self, *arguments):
        with contextlib.redirect_stdout(io.StringIO()) as paths:
            status = main([str(argument) for argument in arguments])
        self.assertIsNone(status)
        return [pathlib.Path(path) for path in paths.getvalue().splitlines()]

    def message(self, *arguments):
        with contextlib.redirect_stderr(io.StringIO()) as text:
            self.assertEqual(main([str(argument) for argument in arguments]), 2)
        return text.getvalue()

    def texts_of(self, *arguments):
        """What stands in a picture, a text a line (matplotlib notes each as a comment)."""
        path, = self.draw(*arguments)
        return "\n".join(re.findall(r"<!-- (.*) -->", path.read_text(encoding="utf-8")))

    def test_history_side_by_side(self):
        texts = self.texts_of("render", self.cone, "--steps", 0, 2, 6, "--zoom", 8, "--scale", 1,
                             "--length-unit", "mm", "--force-unit", "N", "--output", self.folder / "history.svg")
        for words in ("(a)", "(b)", "(c)", "indenter", "plastic zone", "0.2 mm", "von Mises stress in MPa",
                      "t = 0.666667"):
            self.assertIn(words, texts)

    def test_picture(self):
        path, = self.draw("render", self.cone, "--zoom", 4)
        self.assertTrue(path.read_bytes().startswith(b"\x89PNG"))
        self.assertIn("no field 'temperature'; there are: displacement, ",
                      self.message("render", self.cone, "--field", "temperature"))
        self.assertIn("'contact_pressure' is one of the surface: ParaView shows it, in surface.pvd",
                      self.message("render", self.cone, "--field", "contact_pressure"))
        self.assertIn("solution.pvd': it has 13, counted from 0, or from -1 backwards",
                      self.message("render", self.cone, "--steps", 13))
        self.assertIn("surface.pvd': it has 13, counted from 0, or from -1 backwards",
                      self.message("plot", "energies", self.cone, "--step", 13))
        with contextlib.redirect_stderr(io.StringIO()) as text, self.assertRaisesRegex(SystemExit, "^2$"):
            main(["render", str(self.cone), "--output", "picture.mesh"])
        self.assertIn("must end with .png, .svg or .pdf", text.getvalue())
        self.assertIn("--cut x takes a body in space with a contact", self.message("render", self.cone, "--cut", "x"))

    def test_runs_side_by_side(self):
        sphere = self.folder / "sphere"
        run("sphere_3d.prm", sphere, {"Refinement/Number of cycles": 1, "Geometry/Initial refinements": 2})
        other = self.folder / "other"
        shutil.copytree(sphere, other)
        texts = self.texts_of("render", sphere, other, "--panels", "pressure", "--output", self.folder / "both.svg")
        for words in ("(a)", "(b)", "sphere", "other", "contact pressure"):
            self.assertIn(words, texts)
        self.assertNotIn("von Mises", texts)
        self.assertAlmostEqual(Results(sphere).modelled_part, 0.25)
        self.assertIn("--hertz cylinder is for a body in plane strain", self.message(
            "plot", "pressure", sphere, "--hertz", "cylinder"))
        self.assertIn("bodies in the plane and in space do not go side by side",
                      self.message("render", self.cone, sphere))
        self.assertIn("no contact pressure to be seen from above",
                      self.message("render", self.cone, "--panels", "pressure"))

    def test_forces_of_the_whole(self):
        """Of a quarter of a sphere, four times those of the run, or what is asked for."""
        quarter = run("sphere_3d.prm", self.folder / "quarter", {
            "Refinement/Number of cycles": 1, "Geometry/Initial refinements": 2, "Loading/Number of steps": 2,
            "Output/Fields": "never"})
        for parts, factor in ((None, 4.), (1., 1.)):
            options = types.SimpleNamespace(parts=parts, normalised=False, length_unit=None, force_unit=None)
            _, axes = figures.new_diagram()
            curves.force_depth(quarter, options, scales_of(quarter, options), axes)
            numpy.testing.assert_allclose(axes.get_lines()[0].get_ydata(), factor * quarter.history["force"])

    def test_names_of_imprints(self):
        profile = {"step": [1., 2.]}
        for later, name in (((0.5, 0.), "after unloading"), ((0.9, 3.), "unloaded in part"),
                            ((1., 3.), "after relaxation")):
            history = numpy.array([(1., 1., 8.), (2., *later)], [("step", float), ("depth", float), ("force", float)])
            steps = curves.steps_of_imprint(types.SimpleNamespace(history=history), profile)
            self.assertEqual(steps, {"at the largest depth": 1., name: 2.})

    def test_contact_of_one_node(self):
        points = numpy.array([[0.3, 0.3, 0.], [0.5, 0.3, 0.], [0.3, 0.7, 0.]])
        for pressure, radius in (([7., 0., 0.], 0.2), ([7., 7., 0.], 0.1)):
            view = types.SimpleNamespace(fields=lambda _: {"points": points, "contact_pressure": numpy.array(pressure)})
            self.assertAlmostEqual(contact_at(view).radius, radius)

    def test_logarithmic_without_positive_values(self):
        wanted = types.SimpleNamespace(logarithmic=["x", "y"])
        _, axes = figures.new_diagram()
        self.addCleanup(figures.plt.close, axes.figure)
        with contextlib.redirect_stderr(io.StringIO()) as text:
            study.set_logarithmic(axes, wanted, [{"a": "word", "b": 0.}, {"a": "other", "b": None}], {"x": "a", "y": "b"})
            self.assertEqual((axes.get_xscale(), axes.get_yscale()), ("linear", "linear"))
            self.assertEqual(text.getvalue().count("stays linear, as no value is a number above 0"), 2)
            study.set_logarithmic(axes, wanted, [{"a": 1, "b": 2.}], {"x": "a", "y": "b"})
        self.assertEqual((axes.get_xscale(), axes.get_yscale()), ("log", "log"))

    def test_zoom_on_a_small_contact(self):
        units = ("--length-unit", "mm", "--output", self.folder / "window.svg")
        self.assertRegex(self.texts_of("render", self.cone, "--step", 3, *units), "(?m)^0.2 mm$")
        self.assertRegex(self.texts_of("render", self.cone, "--step", 3, "--zoom", 1, *units), "(?m)^2 mm$")

    def test_norms(self):
        for field, label in (("stress", "norm of stress"), ("displacement", "norm of displacement"),
                             ("plastic_fraction", "plastic fraction")):
            self.assertRegex(self.texts_of("render", self.cone, "--field", field, "--output", self.folder / "norm.svg"),
                             f"(?m)^{label}$")

    def test_limit_load(self):
        limit = self.folder / "limit"
        run("limit_load/strip_punch.prm", limit, {"Refinement/Number of cycles": 1})
        self.assertEqual(self.draw("plot", limit), [limit / "equilibrium.png"])
        self.assertEqual(self.draw("plot", "equilibrium", limit), [limit / "equilibrium.png"])
        self.assertEqual(self.draw("plot", limit, "--format", "pdf", "--output-directory", self.folder),
                         [self.folder / "equilibrium.pdf"])
        for arguments in (("plot", "energies"), ("render",)):
            self.assertIn(f"of a limit load. Draw them by 'epc plot {limit}'", self.message(*arguments, limit))
        for name in ("cost", "bounds", "friction"):
            self.assertIn("of a limit load. Draw them by", self.message("plot", name, limit))
        self.assertIn("--normalised has no meaning for the fields of a limit load",
                      self.message("plot", limit, "--normalised"))

    def test_limit_load_that_is_not_drawn(self):
        limit = self.folder / "space"
        limit.mkdir()
        (limit / "limit_load.csv").touch()
        (limit / "parameters.prm").write_text("set Dimension = 3\n")
        for words in ("without its fields", "'.*/limit_load.pvd' is of a body in space: ParaView shows it"):
            with contextlib.redirect_stderr(io.StringIO()) as text:
                self.assertEqual(self.draw("plot", limit), [])
            self.assertRegex(text.getvalue(), f"^plot: .*{words}")
            (limit / "limit_load.pvd").touch()

    def test_friction(self):
        cylinder = self.folder / "cylinder"
        run("friction/mindlin_cylinder.prm", cylinder, {
            "Geometry/Local refinements": 2, "Refinement/Elements over contact radius": 0,
            "Loading/Number of steps": 4, "Output/Fields": "never"})
        self.assertEqual(self.draw("plot", "friction", cylinder), [cylinder / "friction.png"])
        parameters = cylinder / "parameters.prm"
        sticking, n = re.subn("(?m)(set Friction coefficient *=) [0-9.]+", r"\1 stick", parameters.read_text())
        self.assertEqual(n, 1)
        parameters.write_text(sticking)
        texts = self.texts_of("plot", "friction", cylinder, "--output", self.folder / "stick.svg")
        self.assertIn("$Q/P$", texts)
        self.assertNotIn("part that sticks", texts)

    def lines_of(self, draw, table, limit):
        figure, axes = figures.new_diagram()
        self.addCleanup(figures.plt.close, figure)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            draw(axes, table, limit)
        return [numpy.array(line.get_data()).tolist() for line in axes.get_lines()]

    def test_friction_limit(self):
        rows = (1, 1., -1., 0., 9.), (1, 1., 0., 2., 0.5), (2, 2., 0., 0., 9.), (3, 3., 0., 1., -0.2)
        profile = numpy.array(list(rows), [
            (name, float) for name in ("step", "time", "x", "contact_pressure", "contact_shear_x")])
        heights = [y for _, (y,) in self.lines_of(friction.draw_tractions, profile, 0.3)]
        self.assertEqual(heights, [0.5, 0.6, -0.6, -0.2, 0.3, -0.3])
        heights = [y for _, (y,) in self.lines_of(friction.draw_tractions, profile, None)]
        self.assertEqual(heights, [0.5, -0.2])
        with self.assertNoLogs():
            self.assertEqual(self.lines_of(friction.draw_tractions, profile[2:3], 0.3), [])

    def test_friction_without_contact(self):
        history = numpy.array([(1., 2., 1., 4., 2.), (2., 0., 0., 0., 0.)], [
            (name, float) for name in ("time", "force", "tangential_force_x", "contact_area", "stick_area")])
        forces, sticking, *limits = self.lines_of(friction.draw_forces, history, 0.3)
        numpy.testing.assert_equal((forces[1], sticking[1]), [[0.5, numpy.nan]] * 2)
        self.assertEqual([values for _, values in limits], [[0.3, 0.3], [-0.3, -0.3]])
        self.assertEqual(len(self.lines_of(friction.draw_forces, history, None)), 1)

    def test_measured_above_computed(self):
        curve = numpy.array([0., 1.]), numpy.array([0., 1.])
        with unittest.mock.patch.object(experiment, "save") as save:
            experiment.draw({"measured": curve, "computed": curve}, {"measured": [], "computed": []}, "both.png")
        axes, = save.call_args[0][0].axes
        height = {line.get_label(): line.get_zorder() for line in axes.get_lines()}
        self.assertGreater(height["measured"], height["computed"])

    def test_panels_and_units(self):
        texts = self.texts_of("plot", "force_depth", "contact_radius", self.cone, "--panels", self.folder / "both.svg",
                             "--length-unit", "µm", "--force-unit", "mN")
        for words in ("(a)", "(b)", "force in mN", "contact radius in µm"):
            self.assertIn(words, texts)
        self.assertIn("--panels needs the names", self.message("plot", self.cone, "--panels", self.folder / "all.svg"))

    def test_format(self):
        path, = self.draw("plot", "energies", self.cone, "--format", "pdf")
        self.assertEqual(path.name, "energies.pdf")
        self.assertTrue(path.read_bytes().startswith(b"%PDF"))

    def test_normalised(self):
        texts = self.texts_of("plot", "force_depth", self.cone, "--normalised", "--format", "svg")
        self.assertIn(r"force $F\,/\,(Y\, A_{\max})$", texts)
        self.assertIn(r"depth $\delta\,/\,a_{\max}$", texts)

    def test_cycles(self):
        texts = self.texts_of("plot", "cycles", f"{self.cone}=cone", "--length-unit", "mm",
                              "--output", self.folder / "cycles.svg")
        self.assertIn("at the smallest force", texts)
        self.assertIn(r"depth $\delta$ in mm", texts)
        bar = self.folder / "bar"
        run("verification/uniaxial_stress.prm", bar, {"Output/Fields": "never"})
        self.assertIn("the force turns back less than twice", self.message("plot", "cycles", bar))


if __name__ == "__main__":
    unittest.main()
