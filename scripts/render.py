#!/usr/bin/python3
# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw the deformed body of a run, with its plastic zone and, in three
dimensions, the contact pressure seen from above.

Needs ParaView with its Python modules (Debian packages paraview and
python3-paraview). Draws into a virtual display if there is xvfb-run, so that
it needs no screen.
"""

import argparse
import itertools
import math
import os
import shutil
import sys
from dataclasses import dataclass

INSIDE_VIRTUAL_DISPLAY = "ELASTO_PLASTIC_CONTACT_VIRTUAL_DISPLAY"

DARK, EDGES, PLASTIC = [0.12, 0.14, 0.18], [0.20, 0.22, 0.26], [0.93, 0.16, 0.22]

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


class RenderError(Exception):
    """Something the user can mend; the message says how."""


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("directory", help="output directory of a run")
    parser.add_argument("--field", default="von_mises_stress",
                        help="what the colour shows (default: %(default)s)")
    parser.add_argument("--scale", default="auto",
                        help="factor on the displacement: a number, or 'auto' for a dent that can be seen")
    parser.add_argument("--cut", default="auto", choices=["auto", "none", "x", "y"],
                        help="remove the part of a three-dimensional body in front of the contact, "
                             "at right angles to this axis (auto: if the contact is in the middle)")
    parser.add_argument("--zoom", type=float, default=1., help="magnification about the contact")
    parser.add_argument("--step", type=int, default=-1,
                        help="which entry of the .pvd file, counted from 0 (default: the last)")
    parser.add_argument("--no-pressure", action="store_true", help="leave out the panel with the contact pressure")
    parser.add_argument("--no-edges", action="store_true", help="leave out the mesh")
    parser.add_argument("--title", default="", help="text above the picture")
    parser.add_argument("--size", default="", help="width x height in pixels, such as 1600x900")
    parser.add_argument("--output", default="", help="the picture (default: DIRECTORY/picture.png)")
    return parser.parse_args()


def parse_size(text, default):
    if not text:
        return default
    try:
        width, height = (int(part) for part in text.lower().split("x"))
    except ValueError:
        raise RenderError(f"--size is '{text}', but must look like 1600x900") from None
    return [width, height]


def restart_in_virtual_display():
    """Start this script again under xvfb-run, unless that has happened."""
    if INSIDE_VIRTUAL_DISPLAY in os.environ:
        return
    xvfb_run = shutil.which("xvfb-run")
    if xvfb_run:
        os.environ[INSIDE_VIRTUAL_DISPLAY] = "1"
        # (-noreset: else the server restarts after each client, and may miss the next one)
        os.execv(xvfb_run, [xvfb_run, "-a", "-s", "-screen 0 2560x1600x24 -noreset", sys.executable] + sys.argv)
    if "DISPLAY" not in os.environ:
        raise RenderError("there is neither a screen nor xvfb-run (Debian packages xvfb and xauth)")


def import_paraview():
    global numpy, pv, servermanager, vtk_to_numpy
    try:
        import numpy
        from paraview import simple, servermanager as manager
        from vtkmodules.util.numpy_support import vtk_to_numpy as convert
    except ImportError as error:
        raise RenderError(f"ParaView's Python modules are missing ({error}): Debian package python3-paraview") from None
    pv, servermanager, vtk_to_numpy = simple, manager, convert
    pv._DisableFirstRenderCameraReset()


@dataclass
class Contact:
    """Where the pressure is: its centre of gravity and the radius around it."""
    centre: list
    radius: float


def read(directory, name, step):
    """The data of one entry of a .pvd file, or None without that file."""
    path = os.path.join(directory, name)
    if not os.path.isfile(path):
        return None
    reader = pv.PVDReader(FileName=path)
    reader.UpdatePipelineInformation()
    times = list(reader.TimestepValues) or [0.]
    if not -len(times) <= step < len(times):
        raise RenderError(f"--step is {step}, but '{path}' has {len(times)} entries")
    pv.GetAnimationScene().AnimationTime = times[step]
    reader.UpdatePipeline(times[step])
    if reader.GetDataInformation().GetNumberOfPoints() == 0:
        raise RenderError(f"'{path}' holds no points: is the run complete?")
    return reader


def field_names(source):
    return set(source.PointData.keys())


def smooth(source):
    """Join the cells, which are written one by one, and make fields that are
    constant on each of them continuous."""
    cell_values = pv.PointDatatoCellData(Input=source, PassPointData=1)
    joined = pv.CleantoGrid(Input=cell_values)
    smoothed = pv.CellDatatoPointData(Input=joined)
    smoothed.UpdatePipeline()
    return smoothed


def find_contact(surface):
    data = servermanager.Fetch(surface)
    pressure = data.GetPointData().GetArray("contact_pressure")
    if pressure is None:
        raise RenderError("the surface data hold no 'contact_pressure'")
    pressure = vtk_to_numpy(pressure).clip(min=0.)
    points = vtk_to_numpy(data.GetPoints().GetData())
    if pressure.sum() == 0.:
        return None
    centre = (points * pressure[:, None]).sum(axis=0) / pressure.sum()
    loaded = points[pressure > 1e-3 * pressure.max()]
    radius = math.sqrt(((loaded - centre) ** 2).sum(axis=1).max())
    return Contact(list(centre), radius)


def extent(source):
    """Lower corner, upper corner, and the longest side of the bounding box."""
    bounds = source.GetDataInformation().GetBounds()
    lower, upper = list(bounds[0::2]), list(bounds[1::2])
    return lower, upper, max(b - a for a, b in zip(lower, upper))


def middle(source):
    lower, upper, _ = extent(source)
    return [0.5 * (a + b) for a, b in zip(lower, upper)]


def is_flat(source):
    lower, upper, length = extent(source)
    return upper[2] - lower[2] < 1e-10 * length


def round_down(value):
    """The next 1, 2 or 5 times a power of ten below."""
    power = 10. ** math.floor(math.log10(value))
    return max(digit for digit in (1., 2., 5.) if digit * power <= value * (1. + 1e-12)) * power


def displacement_scale(text, source):
    if text != "auto":
        try:
            return float(text)
        except ValueError:
            raise RenderError(f"--scale is '{text}', but must be a number or 'auto'") from None
    largest = source.PointData["displacement"].GetRange(-1)[1]
    if largest == 0.:
        return 1.
    return max(1., round_down(0.06 * extent(source)[2] / largest))


def choose_cut(text, source, contact):
    if contact is None or is_flat(source):
        return "none"
    if text != "auto":
        return text
    lower, upper, _ = extent(source)
    position = (contact.centre[1] - lower[1]) / (upper[1] - lower[1])
    return "y" if 0.25 < position < 0.75 else "none"


def cut_away(source, axis, contact):
    """Keep whole cells behind the plane through the contact."""
    if axis == "none":
        return source
    length = extent(source)[2]
    normal = {"x": [1, 0, 0], "y": [0, 1, 0]}[axis]
    # A plane of mesh faces must not count as touching the cells in front.
    origin = [c + 1e-6 * length * n for c, n in zip(contact.centre, normal)]
    plane = pv.Clip(Input=source, ClipType="Plane", Crinkleclip=1, Invert=0)
    plane.ClipType.Origin = origin
    plane.ClipType.Normal = normal
    return plane


def colour_by(view, display, field):
    """Colour by a field from zero up to its largest value, or over its range
    if it has negative values; with a scalar bar."""
    pv.ColorBy(display, ("POINTS", field))
    values = display.Input.PointData[field]
    lowest, highest = values.GetRange(0 if values.GetNumberOfComponents() == 1 else -1)
    low = min(lowest, 0.)
    high = highest if highest > low else low + 1.
    colours = pv.GetColorTransferFunction(field)
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
    bar.AutomaticLabelFormat, bar.LabelFormat, bar.RangeLabelFormat = 0, "%.4g", "%.4g"
    tick = round_down((high - low) / 2.5)
    inner_ticks = (tick * i for i in range(math.ceil(low / tick), math.ceil(high / tick)))
    bar.UseCustomLabels = 1
    bar.CustomLabels = [t for t in inner_ticks if 0.1 < (t - low) / (high - low) < 0.9]


def show_mesh(view, display, edges):
    if edges:
        display.SetRepresentationType("Surface With Edges")
        display.EdgeColor, display.LineWidth = EDGES, 0.8
    display.Specular = 0.
    display.Ambient, display.Diffuse = (1., 0.) if is_flat(display.Input) else (0.6, 0.45)


def new_view(size):
    view = pv.CreateView("RenderView")
    view.ViewSize = size
    view.UseColorPaletteForBackground = 0
    view.Background = [1., 1., 1.]
    view.OrientationAxesVisibility = 0
    view.CameraParallelProjection = 1
    return view


def write_text(view, text, location, size, justification):
    if text:
        display = pv.Show(pv.Text(Text=text), view)
        display.Color, display.FontSize, display.FontFamily = DARK, size, "Arial"
        display.WindowLocation, display.Justification = location, justification


def show_plastic_zone(view, body, names):
    """A line around the plastic zone on what is seen of the body."""
    field, value = ("plastic_fraction", 0.5) if "plastic_fraction" in names else ("equivalent_plastic_strain", 1e-12)
    if field not in names:
        return False
    lowest, highest = body.PointData[field].GetRange(0)
    if not lowest <= value < highest:
        return False
    skin = body if is_flat(body) else pv.ExtractSurface(Input=body)
    line = pv.Contour(Input=skin, ContourBy=["POINTS", field], Isosurfaces=[value])
    display = pv.Show(line, view)
    pv.ColorBy(display, None)
    display.AmbientColor = display.DiffuseColor = PLASTIC
    display.Ambient, display.Diffuse, display.LineWidth = 1., 0., 4.
    return True


def aim(view, source, direction, up, centre, zoom):
    """Look from a direction so that the whole of source fits between title and
    scalar bar, magnified about the centre."""
    away = numpy.array(direction) / numpy.linalg.norm(direction)
    right = numpy.cross(up, away)
    right /= numpy.linalg.norm(right)
    upwards = numpy.cross(away, right)
    lower, upper, length = extent(source)
    corners = numpy.array(list(itertools.product(*zip(lower, upper))))
    half_width, half_height = (0.5 * numpy.ptp(corners @ axis) for axis in (right, upwards))

    width, height = view.ViewSize
    scale = 1.06 * max(half_height / (1. - BAR_SHARE - TITLE_SHARE), half_width * height / width) / zoom
    focus = numpy.array(centre) - (BAR_SHARE - TITLE_SHARE) * scale * upwards
    view.CameraFocalPoint = list(focus)
    view.CameraPosition = list(focus + 4. * length * away)
    view.CameraViewUp = up
    view.CameraParallelScale = scale
    pv.Render(view)


def draw_body(arguments, body, contact, size):
    names = field_names(body)
    if arguments.field not in names:
        raise RenderError(f"there is no field '{arguments.field}'; there are: {', '.join(sorted(names))}")
    scale = displacement_scale(arguments.scale, body)
    cut = choose_cut(arguments.cut, body, contact)
    seen = cut_away(body, cut, contact)
    warped = pv.WarpByVector(Input=seen, Vectors=["POINTS", "displacement"], ScaleFactor=scale)
    warped.UpdatePipeline()

    view = new_view(size)
    display = pv.Show(warped, view)
    pv.Render(view)  # colour maps abort before the first image
    show_mesh(view, display, not arguments.no_edges)
    colour_by(view, display, arguments.field)
    notes = []
    if show_plastic_zone(view, warped, names):
        notes.append("red line: plastic zone")
    if scale != 1.:
        notes.append(f"displacement x {scale:g}")
    write_text(view, "\n".join(notes), "Upper Left Corner", 15, "Left")
    write_text(view, arguments.title, "Upper Center", 22, "Center")

    direction, up = FROM_THE_FRONT if is_flat(body) else OBLIQUELY[cut]
    centre = contact.centre if contact and arguments.zoom != 1. else middle(warped)
    aim(view, warped, direction, up, centre, arguments.zoom)
    return view


def around(surface, contact):
    """Those cells of the surface that are near the contact."""
    width = 2.6 * contact.radius
    near = pv.Clip(Input=surface, ClipType="Box", Crinkleclip=1, Invert=1)
    near.ClipType.Position = [c - 0.5 * width for c in contact.centre]
    near.ClipType.Length = [width] * 3
    near.UpdatePipeline()
    return near


def draw_pressure(arguments, surface, contact, size):
    view = new_view(size)
    near = around(surface, contact)
    display = pv.Show(near, view)
    pv.Render(view)  # colour maps abort before the first image
    show_mesh(view, display, not arguments.no_edges)
    colour_by(view, display, "contact_pressure")
    write_text(view, "from above", "Upper Center", 15, "Center")
    aim(view, near, *FROM_THE_FRONT, middle(near), 1.)
    return view


def draw(arguments):
    body = read(arguments.directory, "solution.pvd", arguments.step)
    if body is None:
        raise RenderError(f"there is no 'solution.pvd' in '{arguments.directory}'")
    surface = read(arguments.directory, "surface.pvd", arguments.step)
    contact = find_contact(surface) if surface else None
    body = smooth(body)

    two_panels = contact is not None and not is_flat(body) and not arguments.no_pressure
    width, height = parse_size(arguments.size, [1700, 900] if two_panels else [1200, 900])
    layout = pv.CreateLayout("picture")
    body_width = round(0.58 * width) if two_panels else width
    pv.AssignViewToLayout(draw_body(arguments, body, contact, [body_width, height]), layout, 0)
    if two_panels:
        layout.SplitHorizontal(0, body_width / width)
        pv.AssignViewToLayout(draw_pressure(arguments, surface, contact, [width - body_width, height]), layout, 2)
    layout.SetSize(width, height)

    output = arguments.output or os.path.join(arguments.directory, "picture.png")
    if not os.path.isdir(folder := os.path.dirname(os.path.abspath(output))):
        raise RenderError(f"the folder '{folder}' for the picture does not exist")
    pv.SaveScreenshot(output, layout, ImageResolution=[width, height], SeparatorWidth=0)
    if not os.path.isfile(output):
        raise RenderError(f"the picture '{output}' could not be written")
    return output


def main():
    arguments = parse_arguments()
    try:
        restart_in_virtual_display()
        import_paraview()
        print(draw(arguments))
    except RenderError as error:
        sys.exit(f"render.py: {error}")


if __name__ == "__main__":
    main()
