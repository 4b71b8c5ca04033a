# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panels of a picture: the body, and the contact pressure from above. Each knows its colours
and its window, which are those of all steps that are shown, and draws one step."""

import math

import numpy
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from . import draw, skin
from .contact import most_plastic_point
from .indenter import outline
from .joined import Joined
from ..errors import UserError

# A body so much larger than the radius of its contact is shown as a window of that size, unless told otherwise.
LARGE_BODY, WINDOW = 25., 12.


def round_down(value):
    """The next 1, 2 or 5 times a power of ten below."""
    power = 10. ** math.floor(math.log10(value))
    return max(digit for digit in (1., 2., 5.) if digit * power <= value * (1. + 1e-12)) * power


def is_flat(points):
    return numpy.ptp(points[:, 2]) < 1e-10 * numpy.ptp(points)


def magnitude(values):
    """A number for each point, of a vector or tensor its norm."""
    return values if values.ndim == 1 else numpy.linalg.norm(values, axis=1)


def no_field(results, name, fields):
    """The error that a name is none of the fields in the body."""
    text = f"there is no field '{name}'; there are: {', '.join(sorted(set(fields) - {'points', 'cells'}))}"
    if results.has("surface.pvd") and name in set(results.fields("surface")) - set(fields):
        text += f". '{name}' is one of the surface: ParaView shows it, in surface.pvd"
    return UserError(text)


class Panel:
    """Colours from zero up to the largest value of all views, or over their range if there are
    negative ones; a window (left, right, bottom, top) around all of them."""

    def __init__(self, views, name, cmap):
        self.name = name
        lowest, highest = 0., -math.inf
        boxes = []
        for view in views:
            seen, values = self.look(view)
            used = seen.positions[numpy.unique(seen.quads)]
            boxes.append((used.min(axis=0), used.max(axis=0)))
            lowest, highest = min(lowest, values.min()), max(highest, values.max())
        self.colours = ScalarMappable(Normalize(lowest, highest if highest > lowest else lowest + 1.), cmap)
        (left, bottom), (right, top) = numpy.min([box[0] for box in boxes], axis=0), \
            numpy.max([box[1] for box in boxes], axis=0)
        self.window = (left, right, bottom, top)

    def label(self):
        return self.name.replace("_", " ").replace("mises", "Mises")

    def aspect(self):
        left, right, bottom, top = self.window
        return (top - bottom) / (right - left)

    def draw_cells(self, axes, seen, values, nodes, edges):
        left, right, bottom, top = self.window
        axes.set(xlim=(left, right), ylim=(bottom, top), aspect="equal")
        axes.set_axis_off()
        draw.draw_field(axes, seen, values, self.colours)
        if edges:
            inches = min(axes.figure.get_size_inches())
            draw.draw_mesh(axes, seen, nodes, 72. * inches / (right - left))


class BodyPanel(Panel):
    """The deformed body with its plastic zone; a plane one with the indenter."""

    def __init__(self, arguments, views, contact):
        self.arguments, self.contact = arguments, contact
        for view in views:
            fields = view.fields("solution")
            for name in (arguments.field, "displacement", "material_id"):
                if name not in fields or name in ("points", "cells"):
                    raise no_field(view.results, name, fields)
        self.is_norm = fields[arguments.field].ndim > 1
        self.flat = is_flat(fields["points"])
        self.cut = self.choose_cut(fields["points"])
        self.zoom = arguments.zoom or self.choose_zoom(fields["points"])
        self.scale = self.choose_scale(views, fields["points"])
        super().__init__(views, arguments.field, "viridis")
        if self.zoom != 1.:
            self.magnify(contact.centre if contact else most_plastic_point(fields))
        if self.flat:  # room for the indenter
            left, right, bottom, top = self.window
            self.window = (left, right, bottom, top + 0.1 * (top - bottom))

    def label(self):
        return f"norm of {super().label()}" if self.is_norm else super().label()

    def choose_cut(self, points):
        if self.contact is None or self.flat:
            if self.arguments.cut in ("x", "y"):
                raise UserError(f"--cut {self.arguments.cut} takes a body in space with a contact, in front of which it is cut")
            return "none"
        if self.arguments.cut != "auto":
            return self.arguments.cut
        lower, upper = points.min(axis=0), points.max(axis=0)
        position = (self.contact.centre[1] - lower[1]) / (upper[1] - lower[1])
        return "y" if 0.25 < position < 0.75 else "none"

    def choose_zoom(self, points):
        size = numpy.ptp(points, axis=0).max() / self.contact.radius if self.contact else 0.
        return size / WINDOW if size > LARGE_BODY else 1.

    def choose_scale(self, views, points):
        """Finite displacements can be seen as they are, and the indenter fits them only so."""
        if self.arguments.scale != "auto":
            return self.arguments.scale
        if any(view.results.parameters.get("Strain") == "logarithmic" for view in views):
            return 1.
        largest = max(magnitude(view.fields("solution")["displacement"]).max() for view in views)
        length = (points.max(axis=0) - points.min(axis=0)).max()
        return max(1., round_down(0.06 * length / self.zoom / largest)) if largest > 0. else 1.

    def magnify(self, centre):
        """About the centre or, close to the edge, as far from it that the body fills the window."""
        if not self.flat:
            centre = numpy.array(centre) @ numpy.column_stack(skin.axes_of_view(*skin.OBLIQUELY[self.cut])[:2])
        left, right, bottom, top = self.window
        window = []
        for lowest, highest, middle in ((left, right, centre[0]), (bottom, top, centre[1])):
            half = 0.5 * (highest - lowest) / self.zoom
            middle = min(max(middle, lowest + half), highest - half)
            window += [middle - half, middle + half]
        self.window = tuple(window)

    def read(self, view):
        """Fields, points of the deformed body, and what makes the fields of each material continuous."""
        fields = view.fields("solution")
        points, cells = fields["points"], fields["cells"]
        everywhere = Joined(points, cells)
        materials = fields["material_id"]
        within = everywhere if numpy.ptp(materials) == 0. else Joined(points, cells, materials)
        return fields, points + self.scale * everywhere(fields["displacement"]), everywhere, within

    def look(self, view):
        fields, points, everywhere, within = self.read(view)
        return self.see(fields, points), within(magnitude(fields[self.arguments.field]))

    def see(self, fields, points):
        if self.flat:
            return skin.look_at_plane(points, fields["cells"])
        cells = skin.cut_away(fields["points"], fields["cells"], self.cut, getattr(self.contact, "centre", None))
        return skin.look(points, skin.outer_faces(fields["points"], cells), skin.OBLIQUELY[self.cut])

    def draw(self, axes, view):
        """Returns what the legend says of the lines."""
        fields, points, everywhere, within = self.read(view)
        seen, values = self.see(fields, points), within(magnitude(fields[self.arguments.field]))
        handles = []
        if self.flat and self.draw_indenter(axes, fields["points"], view):
            handles.append(Patch(facecolor=draw.INDENTER, edgecolor=draw.DARK, label="indenter"))
        self.draw_cells(axes, seen, values, within.nodes, not self.arguments.no_edges)
        if self.draw_plastic_zone(axes, seen, fields, everywhere):
            handles.append(Line2D([], [], color=draw.PLASTIC, linewidth=1.8, label="plastic zone"))
        if self.scale != 1.:
            axes.text(1., 1.01, f"displacement × {self.scale:g}", transform=axes.transAxes, ha="right", va="bottom",
                      fontsize=9)
        return handles

    @staticmethod
    def draw_plastic_zone(axes, seen, fields, everywhere):
        field, level = (("plastic_fraction", 0.5) if "plastic_fraction" in fields
                        else ("equivalent_plastic_strain", 1e-12))
        return field in fields and draw.draw_contour(axes, seen, everywhere.nodes, everywhere(fields[field]), level)

    def draw_indenter(self, axes, points, view):
        found = outline(view.results, points[:, 1].max(), view.time, self.scale)
        if found is None or self.arguments.no_indenter:
            return False
        x, y = found
        axes.fill_between(x, y, max(self.window[3], y.max()), facecolor=draw.INDENTER, zorder=0)
        axes.plot(x, y, color=draw.DARK, linewidth=0.9, zorder=4)
        return True


class PressurePanel(Panel):
    """Those cells of the surface that are near the contact, from above."""
    flat = True

    def __init__(self, arguments, views, contact):
        self.arguments, self.contact = arguments, contact
        super().__init__(views, "contact_pressure", draw.PRESSURE)

    def look(self, view):
        surface = view.fields("surface")
        points, quads = surface["points"], surface["cells"]
        corners = points[quads] - self.contact.centre
        near = (numpy.abs(corners[:, :, :2]).min(axis=1) <= 1.3 * self.contact.radius).all(axis=1)
        if not near.any():
            raise UserError(f"the surface of '{view.results.directory}' ends far from the contact of the other runs")
        seen = skin.look_at_plane(points, quads[near])
        return seen, Joined(points, quads)(surface["contact_pressure"])

    def draw(self, axes, view):
        seen, values = self.look(view)
        surface = view.fields("surface")
        self.draw_cells(axes, seen, values, Joined(surface["points"], surface["cells"]).nodes,
                        not self.arguments.no_edges)
        return []
