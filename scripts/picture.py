# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Camera, colours and text of a picture. Needs ParaView's Python modules."""

import itertools
import math

import numpy
from paraview import simple as pv

from scene import is_flat

DARK, EDGES = [0.12, 0.14, 0.18], [0.20, 0.22, 0.26]

# From no pressure to the highest: white, yellow, red, black.
PRESSURE_COLOURS = [(0., [1., 1., 1.]), (0.15, [1., 0.93, 0.62]), (0.4, [0.99, 0.68, 0.32]),
                    (0.65, [0.88, 0.32, 0.19]), (0.85, [0.60, 0.10, 0.24]), (1., [0.24, 0.03, 0.22])]

# The lower and upper part of each panel that are kept free for text.
BAR_SHARE, TITLE_SHARE = 0.13, 0.04

# Where the camera stands, and which way is up: for flat data, and for bodies
# cut at right angles to an axis.
FROM_THE_FRONT = ([0., 0., 1.], [0., 1., 0.])
OBLIQUELY = {
    "none": ([-0.55, -0.70, 0.46], [0., 0., 1.]),
    "x": ([-0.78, -0.42, 0.46], [0., 0., 1.]),
    "y": ([-0.42, -0.78, 0.46], [0., 0., 1.]),
}


def round_down(value):
    """The next 1, 2 or 5 times a power of ten below."""
    power = 10. ** math.floor(math.log10(value))
    return max(digit for digit in (1., 2., 5.) if digit * power <= value * (1. + 1e-12)) * power


def new_view(size):
    view = pv.CreateView("RenderView")
    view.ViewSize = size
    view.UseColorPaletteForBackground = 0
    view.Background = [1., 1., 1.]
    view.OrientationAxesVisibility = 0
    view.CameraParallelProjection = 1
    return view


def show(view, source, edges):
    """Add a source, with or without its mesh."""
    display = pv.Show(source, view)
    pv.Render(view)  # colour maps abort before the first image
    if edges:
        display.SetRepresentationType("Surface With Edges")
        display.EdgeColor, display.LineWidth = EDGES, 0.8
    display.Specular = 0.
    display.Ambient, display.Diffuse = (1., 0.) if is_flat(source) else (0.6, 0.45)
    return display


def show_line(view, source, colour):
    display = pv.Show(source, view)
    pv.ColorBy(display, None)
    display.AmbientColor = display.DiffuseColor = colour
    display.Ambient, display.Diffuse, display.LineWidth = 1., 0., 4.


def colour_by(view, display, field, lowest, highest):
    """Colour by a field from zero up to its largest value, or over its range
    if it has negative values; with a scalar bar."""
    pv.ColorBy(display, ("POINTS", field))
    low = min(lowest, 0.)
    high = highest if highest > low else low + 1.
    colours = pv.GetColorTransferFunction(field)
    colours.AutomaticRescaleRangeMode = "Never"
    if field == "contact_pressure":
        colours.RGBPoints = [value for position, colour in PRESSURE_COLOURS
                             for value in [low + position * (high - low)] + colour]
    else:
        colours.ApplyPreset("Viridis (matplotlib)", True)
        colours.RescaleTransferFunction(low, high)
    display.SetScalarBarVisibility(view, True)
    arrange_scalar_bar(view, colours, field, low, high)


def arrange_scalar_bar(view, colours, field, low, high):
    bar = pv.GetScalarBar(colours, view)
    bar.Title, bar.ComponentTitle = field.replace("_", " ").replace("mises", "Mises"), ""
    bar.TitleColor = bar.LabelColor = DARK
    bar.TitleFontSize, bar.LabelFontSize = 20, 18
    bar.TitleFontFamily = bar.LabelFontFamily = "Arial"
    bar.Orientation = "Horizontal"
    bar.WindowLocation = "Any Location"
    bar.Position, bar.ScalarBarLength, bar.ScalarBarThickness = [0.25, 0.03], 0.5, 18
    bar.DrawBackground, bar.BackgroundColor, bar.BackgroundPadding = 1, [1., 1., 1., 0.8], 6.
    bar.AutomaticLabelFormat, bar.LabelFormat, bar.RangeLabelFormat = 0, "%.4g", "%.4g"
    tick = round_down((high - low) / 2.5)
    inner_ticks = (tick * i for i in range(math.ceil(low / tick), math.ceil(high / tick)))
    bar.UseCustomLabels = 1
    bar.CustomLabels = [t for t in inner_ticks if 0.1 < (t - low) / (high - low) < 0.9]


def write_text(view, text, location, size, justification):
    """Add a text; what is returned can change it later."""
    source = pv.Text(Text=text)
    display = pv.Show(source, view)
    display.Color, display.FontSize, display.FontFamily = DARK, size, "Arial"
    display.WindowLocation, display.Justification = location, justification
    return source


def aim(view, box, direction, up, centre, zoom):
    """Look from a direction so that the whole of a box fits between title and
    scalar bar, magnified about the centre or, close to the edge of the box, as far
    from it that the box still fills the picture."""
    lower, upper = box
    away = numpy.array(direction) / numpy.linalg.norm(direction)
    right = numpy.cross(up, away)
    right /= numpy.linalg.norm(right)
    upwards = numpy.cross(away, right)
    corners = numpy.array(list(itertools.product(*zip(lower, upper))))
    half_width, half_height = (0.5 * numpy.ptp(corners @ axis) for axis in (right, upwards))

    width, height = view.ViewSize
    free_height = 1. - BAR_SHARE - TITLE_SHARE
    scale = 1.06 * max(half_height / free_height, half_width * height / width) / zoom
    centre = numpy.array(centre)
    focus = centre - (BAR_SHARE - TITLE_SHARE) * scale * upwards
    for axis, half_window in ((right, scale * width / height), (upwards, scale * free_height)):
        lowest, highest = (corners @ axis).min() + half_window, (corners @ axis).max() - half_window
        if lowest < highest:
            focus += (numpy.clip(centre @ axis, lowest, highest) - centre @ axis) * axis
    view.CameraFocalPoint = list(focus)
    view.CameraPosition = list(focus + 4. * max(numpy.subtract(upper, lower)) * away)
    view.CameraViewUp = up
    view.CameraParallelScale = scale
    pv.Render(view)
