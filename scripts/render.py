#!/usr/bin/python3
# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw the deformed body of a run, with its plastic zone and, in three
dimensions, the contact pressure seen from above: one picture, or one for each
load step of a history.

Needs ParaView with its Python modules (Debian packages paraview and
python3-paraview). Draws into a virtual display if there is xvfb-run, so that
it needs no screen.
"""

import argparse
import os
import shutil
import sys

INSIDE_VIRTUAL_DISPLAY = "ELASTO_PLASTIC_CONTACT_VIRTUAL_DISPLAY"

PLASTIC = [0.93, 0.16, 0.22]


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
    parser.add_argument("--zoom", type=float, default=1.,
                        help="magnification about the contact; after it, about where it was last")
    parser.add_argument("--step", type=int,
                        help="which entry of the .pvd file, counted from 0 (default: the last)")
    parser.add_argument("--no-pressure", action="store_true", help="leave out the panel with the contact pressure")
    parser.add_argument("--no-edges", action="store_true", help="leave out the mesh")
    parser.add_argument("--title", default="", help="text above the picture")
    parser.add_argument("--size", default="", help="width x height in pixels, such as 1600x900")
    parser.add_argument("--output", default="", help="the picture (default: DIRECTORY/picture.png)")
    parser.add_argument("--animation", default="", metavar="FOLDER",
                        help="draw all entries of the .pvd file, with the same colours and camera: "
                             "FOLDER/frame_0000.png and so on and, if there is Pillow (Debian package "
                             "python3-pil), FOLDER/animation.gif")
    arguments = parser.parse_args()
    if arguments.animation and (arguments.output or arguments.step is not None):
        parser.error("--animation draws all entries into its folder: it goes neither with --output nor with --step")
    return arguments


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
        sys.exit("render.py: there is neither a screen nor xvfb-run (Debian packages xvfb and xauth)")


def import_modules():
    global picture, pv, scene, RenderError
    try:
        from paraview import simple as pv
        import picture
        import scene
    except ImportError as error:
        sys.exit(f"render.py: ParaView's Python modules are missing ({error}): Debian package python3-paraview")
    RenderError = scene.RenderError
    pv._DisableFirstRenderCameraReset()


def parse_size(text, default):
    if not text:
        return default
    try:
        width, height = (int(part) for part in text.lower().split("x"))
    except ValueError:
        raise RenderError(f"--size is '{text}', but must look like 1600x900") from None
    return [width, height]


def displacement_scale(text, body, times, zoom):
    if text != "auto":
        try:
            return float(text)
        except ValueError:
            raise RenderError(f"--scale is '{text}', but must be a number or 'auto'") from None
    largest = scene.field_range(body, "displacement", times)[1]
    return max(1., picture.round_down(0.06 * scene.extent(body)[2] / zoom / largest)) if largest > 0. else 1.


def choose_cut(text, body, contact):
    if contact is None or scene.is_flat(body):
        return "none"
    if text != "auto":
        return text
    lower, upper, _ = scene.extent(body)
    position = (contact.centre[1] - lower[1]) / (upper[1] - lower[1])
    return "y" if 0.25 < position < 0.75 else "none"


def cut_away(body, axis, contact):
    """Keep whole cells behind the plane through the contact."""
    if axis == "none":
        return body
    length = scene.extent(body)[2]
    normal = {"x": [1, 0, 0], "y": [0, 1, 0]}[axis]
    # A plane of mesh faces must not count as touching the cells in front.
    origin = [c + 1e-6 * length * n for c, n in zip(contact.centre, normal)]
    plane = pv.Clip(Input=body, ClipType="Plane", Crinkleclip=1, Invert=0)
    plane.ClipType.Origin = origin
    plane.ClipType.Normal = normal
    return plane


def show_plastic_zone(view, body, names, times):
    """A line around the plastic zone on what is seen of the body."""
    field, value = ("plastic_fraction", 0.5) if "plastic_fraction" in names else ("equivalent_plastic_strain", 1e-12)
    if field not in names:
        return False
    lowest, highest = scene.field_range(body, field, times)
    if not lowest <= value < highest:
        return False
    skin = body if scene.is_flat(body) else pv.ExtractSurface(Input=body)
    line = pv.Contour(Input=skin, ContourBy=["POINTS", field], Isosurfaces=[value])
    picture.show_line(view, line, PLASTIC)
    return True


def draw_body(arguments, body, contact, times, size):
    """The panel with the body, and the text that stands in its corner."""
    names = scene.field_names(body)
    if arguments.field not in names:
        raise RenderError(f"there is no field '{arguments.field}'; there are: {', '.join(sorted(names))}")
    scale = displacement_scale(arguments.scale, body, times, arguments.zoom)
    cut = choose_cut(arguments.cut, body, contact)
    seen = cut_away(body, cut, contact)
    warped = pv.WarpByVector(Input=seen, Vectors=["POINTS", "displacement"], ScaleFactor=scale)
    box = scene.extent_over_time(warped, times)

    view = picture.new_view(size)
    display = picture.show(view, warped, not arguments.no_edges)
    picture.colour_by(view, display, arguments.field, *scene.field_range(warped, arguments.field, times))
    notes = []
    if show_plastic_zone(view, warped, names, times):
        notes.append("red line: plastic zone")
    if scale != 1.:
        notes.append(f"displacement x {scale:g}")
    picture.write_text(view, arguments.title, "Upper Center", 22, "Center")

    direction, up = picture.FROM_THE_FRONT if scene.is_flat(body) else picture.OBLIQUELY[cut]
    centre = (box[0] + box[1]) / 2.
    if arguments.zoom != 1.:
        centre = contact.centre if contact else scene.most_plastic_point(body)
    picture.aim(view, box, direction, up, centre, arguments.zoom)
    return view, notes


def around(surface, contact):
    """Those cells of the surface that are near the contact."""
    width = 2.6 * contact.radius
    # (Without joining the cells first, ParaView 5.11 crashes now and then.)
    joined = pv.CleantoGrid(Input=surface)
    near = pv.Clip(Input=joined, ClipType="Box", Crinkleclip=1, Invert=1)
    near.ClipType.Position = [c - 0.5 * width for c in contact.centre]
    near.ClipType.Length = [width] * 3
    return near


def draw_pressure(arguments, surface, contact, times, size):
    view = picture.new_view(size)
    near = around(surface, contact)
    box = scene.extent_over_time(near, times)
    display = picture.show(view, near, not arguments.no_edges)
    picture.colour_by(view, display, "contact_pressure", *scene.field_range(near, "contact_pressure", times))
    picture.write_text(view, "from above", "Upper Center", 15, "Center")
    picture.aim(view, box, *picture.FROM_THE_FRONT, (box[0] + box[1]) / 2., 1.)
    return view


class Panels:
    """The arrangement of one or two views, and its pictures at the times."""

    def __init__(self, arguments):
        series = scene.TimeSeries(arguments.directory, "solution.pvd")
        self.times = series.times
        if not arguments.animation:
            self.times = [series.time(-1 if arguments.step is None else arguments.step)]
        surface, contact, presses = self.find_contact(arguments, series.times)
        series.show(self.times[-1])
        body = scene.smooth(series.source)
        body.UpdatePipeline(self.times[-1])

        two_panels = presses and not scene.is_flat(body) and not arguments.no_pressure
        width, height = self.size = parse_size(arguments.size, [1700, 900] if two_panels else [1200, 900])
        self.layout = pv.CreateLayout("picture")
        body_width = round(0.58 * width) if two_panels else width
        view, self.notes = draw_body(arguments, body, contact, self.times, [body_width, height])
        self.text = picture.write_text(view, "", "Upper Left Corner", 15, "Left")
        pv.AssignViewToLayout(view, self.layout, 0)
        if two_panels:
            self.layout.SplitHorizontal(0, body_width / width)
            view = draw_pressure(arguments, surface.source, contact, self.times, [width - body_width, height])
            pv.AssignViewToLayout(view, self.layout, 2)
        self.layout.SetSize(width, height)

    def find_contact(self, arguments, all_times):
        """The surface, the contact to look at, and whether it presses at any of the times."""
        if not os.path.isfile(os.path.join(arguments.directory, "surface.pvd")):
            return None, None, False
        surface = scene.TimeSeries(arguments.directory, "surface.pvd")
        if surface.times != all_times:
            raise RenderError(f"'{surface.path}' and 'solution.pvd' have different times: is the run complete?")
        if arguments.animation:
            contact = scene.largest_contact(surface)
            return surface, contact, contact is not None
        return surface, scene.last_contact(surface, self.times[-1]), bool(scene.contact_at(surface, self.times[-1]))

    def save(self, time, heading, path):
        pv.GetAnimationScene().AnimationTime = time
        self.text.Text = "\n".join(heading + self.notes)
        pv.SaveScreenshot(path, self.layout, ImageResolution=self.size, SeparatorWidth=0)
        if not os.path.isfile(path):
            raise RenderError(f"the picture '{path}' could not be written")
        print(path)


def draw_picture(arguments):
    output = arguments.output or os.path.join(arguments.directory, "picture.png")
    if not os.path.isdir(folder := os.path.dirname(os.path.abspath(output))):
        raise RenderError(f"the folder '{folder}' for the picture does not exist")
    panels = Panels(arguments)
    panels.save(panels.times[-1], [], output)


def draw_animation(arguments):
    try:
        os.makedirs(arguments.animation, exist_ok=True)
    except OSError as error:
        raise RenderError(f"the folder '{arguments.animation}' cannot be created: {error.strerror}") from None
    panels = Panels(arguments)
    frames = [os.path.join(arguments.animation, f"frame_{i:04d}.png") for i in range(len(panels.times))]
    for time, frame in zip(panels.times, frames):
        panels.save(time, [f"t = {time:.3f}"], frame)
    join(frames, os.path.join(arguments.animation, "animation.gif"))


def join(frames, path):
    """Make one moving picture of all frames, if there is Pillow."""
    try:
        from PIL import Image
    except ImportError:
        return
    images = [Image.open(frame).convert("P", palette=Image.ADAPTIVE) for frame in frames]
    images[0].save(path, save_all=True, append_images=images[1:], duration=100, loop=0)
    print(path)


def main():
    arguments = parse_arguments()
    restart_in_virtual_display()
    import_modules()
    try:
        (draw_animation if arguments.animation else draw_picture)(arguments)
    except RenderError as error:
        sys.exit(f"render.py: {error}")


if __name__ == "__main__":
    main()
