# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw what the equilibrium method has found: the last mesh of limit_load.pvd (yield
ratio of the stresses, plastic work of the mechanism of collapse with the lines along which it flows and, green,
those on which it slips, multipliers u_h of equilibrium) or of equilibrium.pvd (yield ratio, displacement u_h, parts of the error bound), thirds of
triangles as they are.

    epc plot equilibrium output/limit_load_strip_punch --window 3 --output prandtl.png
"""

import os
import pathlib

import numpy
from matplotlib.collections import LineCollection
from matplotlib.tri import LinearTriInterpolator, Triangulation

from .figures import letter, make_parser_of_one_run, plt, save
from ..arguments import number
from ..errors import UserError
from ..fields import read_fields
from ..pictures.joined import same_points

PANEL = 4.8  # inches


def arrays(fields):
    return {name: numpy.array(values) for name, values in fields.items()}


def last_slip_lines(directory):
    """Where the mechanism of the last mesh slips, if there is one."""
    if not (pathlib.Path(directory) / "slip_lines.pvd").exists():
        return None
    return arrays(list(read_fields(directory, "slip_lines"))[-1])


def last_fields(directory):
    for kind in ("limit_load", "equilibrium"):
        if (pathlib.Path(directory) / f"{kind}.pvd").exists():
            fields = arrays(list(read_fields(directory, kind))[-1])
            if fields["cells"].shape[1] != 3:
                raise UserError(f"{kind}.pvd in {directory} is of a body in space: ParaView shows it.")
            return fields
    raise UserError(f"there is neither limit_load.pvd nor equilibrium.pvd in {directory}. "
                    "Run a case with 'Analysis = limit load' or 'contact with error bound', and not with "
                    "'Output/Fields = never'.")


class Picture:
    """The panels of the fields inside a window (left, right, bottom, top)."""

    def __init__(self, fields, window):
        self.fields = fields
        x, y = fields["points"][:, :2].T
        self.triangles = Triangulation(x, y, fields["cells"])
        self.window = (x.min(), x.max(), y.min(), y.max())
        if window:
            if window < 1e-6 * numpy.ptp(x):
                raise UserError(f"--window is {window:g}, but must be at least a millionth of the body's width, "
                                f"{numpy.ptp(x):g}")
            self.window = (max(-window, x.min()), min(window, x.max()), max(y.max() - window, y.min()), y.max())
        left, right, bottom, top = self.window
        height = PANEL * (top - bottom) / (right - left)
        self.figure, self.panels = plt.subplots(1, 3, figsize=(3 * (PANEL + 0.9), height + 0.8))

    def draw(self, i, title, values, **options):
        """Colours of one panel, the values at points or of cells."""
        axes = self.panels[i]
        left, right, bottom, top = self.window
        axes.grid(False)
        axes.set(title=title, aspect="equal", xlim=(left, right), ylim=(bottom, top))
        letter(axes, i)
        image = axes.tripcolor(self.triangles, values, rasterized=True, **options)
        self.figure.colorbar(image, ax=axes, shrink=0.85)
        return axes

    def draw_mesh(self, axes):
        """Thinner where the triangles are smaller, so that the lines do not hide the field."""
        lines = self.fields["points"][self.triangles.edges][:, :, :2]
        left, right, _, _ = self.window
        lengths = 72. * PANEL / (right - left) * numpy.linalg.norm(lines[:, 1] - lines[:, 0], axis=1)
        widths = (0.02 * lengths).clip(0.01, 0.25)
        axes.add_collection(LineCollection(lines, colors="black", alpha=0.4, linewidths=widths, rasterized=True))

    def draw_magnitude(self, i, name, title):
        """Its colours leave out what only a hundredth of the points reach, as at the edge of a punch."""
        magnitude = numpy.linalg.norm(self.fields[name], axis=1)
        return self.draw(i, title, magnitude, shading="gouraud", cmap="magma", vmax=numpy.quantile(magnitude, 0.99))

    def joined(self, name):
        """Points, triangles and values of a field, with one point, and the mean value, where several triangles meet."""
        points = self.fields["points"][:, :2]
        _, first, nodes, numbers = numpy.unique(same_points(points, 1e-6 * numpy.ptp(points)), return_index=True,
                                                return_inverse=True, return_counts=True)
        values = [numpy.bincount(nodes, weights=part) / numbers for part in self.fields[name].T]
        return points[first], nodes[self.triangles.triangles], numpy.transpose(values)

    def draw_flow(self, axes):
        """The lines along which the mechanism moves, where it does."""
        left, right, bottom, top = self.window
        x, y = numpy.linspace(left, right, 300), numpy.linspace(bottom, top, 300)
        grid = numpy.meshgrid(x, y)
        points, triangles, velocities = self.joined("velocity")
        velocity = [LinearTriInterpolator(Triangulation(*points.T, triangles), part)(*grid)
                    for part in velocities.T[:2]]
        speed = numpy.hypot(*velocity)
        for part in velocity:
            part[speed < 0.03 * numpy.nanquantile(speed.filled(0.), 0.99)] = numpy.ma.masked
        axes.streamplot(x, y, *velocity, color="#3fb8d4", linewidth=0.9, arrowsize=0.8, density=1.4)

    def draw_slip_lines(self, axes, slip_lines):
        """Lines on which the mechanism slips, as wide as it does."""
        if not len(slip_lines["cells"]):
            return
        lines = slip_lines["points"][slip_lines["cells"]][:, :, :2]
        slip = numpy.linalg.norm(slip_lines["slip"], axis=1)[slip_lines["cells"]].mean(axis=1)
        axes.add_collection(LineCollection(lines, colors="#7dff5c", linewidths=3. * numpy.sqrt(slip / slip.max()), rasterized=True))


def plot(fields, slip_lines, window):
    picture = Picture(fields, window)
    if fields["yield_ratio"].max() > 0:
        axes = picture.draw(0, "stress over yield stress", fields["yield_ratio"], shading="gouraud", vmin=0, vmax=1)
    else:
        axes = picture.draw(0, "von Mises stress", fields["von_mises_stress"], shading="gouraud")
    picture.draw_mesh(axes)
    if "velocity" in fields:
        # (the same at all corners)
        work = numpy.log10(fields["plastic_work"][fields["cells"][:, 0]].clip(min=1e-30))
        largest = numpy.quantile(work, 0.99)
        axes = picture.draw(1, "plastic work per volume (power of 10), slip", work, cmap="magma", vmin=largest - 3,
                            vmax=largest)
        picture.draw_flow(axes)
        if slip_lines:
            picture.draw_slip_lines(axes, slip_lines)
        picture.draw_magnitude(2, "discontinuous_velocity", "speed $u_h$ of the multipliers")
    else:
        picture.draw_magnitude(1, "discontinuous_displacement", "displacement $u_h$")
        # (an indicator is the same number at all corners)
        error = numpy.log10(fields["error_indicator"][fields["cells"][:, 0]].clip(min=1e-30))
        picture.draw(2, "error bound of a triangle (power of 10)", error, cmap="magma", vmin=error.max() - 6)
    return picture.figure


def draw(directory, path, window=None):
    save(plot(last_fields(directory), last_slip_lines(directory), window), path)


def main(arguments):
    parser = make_parser_of_one_run(__doc__, "equilibrium")
    parser.add_argument("--window", type=number(above=0), help="show only so much to both sides of the axis, and below")
    chosen = parser.parse_args(arguments)
    draw(chosen.directory, chosen.output or os.path.join(chosen.directory, "equilibrium.png"), chosen.window)
