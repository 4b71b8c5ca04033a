# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw the deformed body of a run, with its plastic zone and the indenter and, in three
dimensions, the contact pressure seen from above: one picture, the steps of a history or several
runs side by side, or one picture for each step.

    epc render output/cone_axisymmetric --steps 5 20 39 --zoom 25 --output history.pdf
    epc render output/coarse output/fine --panels pressure --output pressures.png
"""

import argparse
import os

from .contact import contact_at, contact_to_look_at
from .panels import BodyPanel, PressurePanel, is_flat
from .sheet import draw_sheet
from ..arguments import CommandParser, number, picture
from ..errors import UserError
from .view import View
from ..fields import check_step, times
from ..plots.figures import add_units, save, units_of
from ..results import Results

PANELS = ["body", "pressure"]

# The options that only the panel of the body knows.
OF_BODY = ("field", "scale", "cut", "zoom", "no_indenter")


def scale(text):
    return text if text == "auto" else number()(text)


def parse_arguments(arguments):
    parser = CommandParser("render", __doc__)
    parser.add_argument("directories", nargs="+", metavar="directory",
                        help="output directory of a run; of several, side by side with the same colours and window")
    parser.add_argument("--panels", nargs="+", choices=PANELS, default=PANELS,
                        help="the body, and the contact pressure from above (default: both)")
    parser.add_argument("--field", default="von_mises_stress",
                        help="what the colour shows, of vectors and tensors the root of the sum of the squares of "
                             "their components (default: %(default)s)")
    parser.add_argument("--scale", type=scale, default="auto",
                        help="factor on the displacement: a number, or 'auto' for a dent that can be seen (1 with finite "
                             "strains)")
    parser.add_argument("--cut", default="auto", choices=["auto", "none", "x", "y"],
                        help="remove the part of a three-dimensional body in front of the contact, "
                             "at right angles to this axis (auto: if the contact is in the middle)")
    parser.add_argument("--zoom", type=number(least=1, most=1e6),
                        help="magnification about the contact; after it, about where it was last (default: 1, or so "
                             "much that the contact can be seen)")
    parser.add_argument("--steps", "--step", type=int, nargs="+", default=[-1], metavar="STEP",
                        help="which entries of the .pvd file, counted from 0 (default: the last), side by side "
                             "with the same colours and window")
    parser.add_argument("--no-edges", action="store_true", help="leave out the mesh")
    parser.add_argument("--no-indenter", action="store_true", help="leave out the outline of the indenter")
    parser.add_argument("--title", default="", help="text above the picture")
    parser.add_argument("--size", default="", help="width x height in pixels, such as 1600x900")
    add_units(parser)
    parser.add_argument("--output", type=picture,
                        help="the picture, .png, .svg or .pdf (default: DIRECTORY/picture.png)")
    parser.add_argument("--animation", default="", metavar="FOLDER",
                        help="draw all entries of the .pvd file, with the same colours and window: "
                             "FOLDER/frame_0000.png and so on and, if there is Pillow (Debian package "
                             "python3-pil), FOLDER/animation.gif")
    arguments = parser.parse_args(arguments)
    if arguments.animation and (arguments.output or arguments.steps != [-1]):
        parser.error("--animation draws all entries into its folder: it goes neither with --output nor with --steps")
    if arguments.animation and len(arguments.directories) > 1:
        parser.error("--animation is for one directory")
    if arguments.animation and arguments.title:
        parser.error("--animation writes the time above each picture: it goes not with --title")
    for name in OF_BODY if "body" not in arguments.panels else ():
        if getattr(arguments, name) != parser.get_default(name):
            parser.error(f"--{name.replace('_', '-')} is of the body, which --panels leaves out")
    return arguments


pixels = number(int, least=100, most=20000)


def parse_size(text):
    """Width and height in pixels; None for a size that fits."""
    if not text:
        return None
    try:
        width, height = map(pixels, text.lower().split("x"))
    except (argparse.ArgumentTypeError, ValueError):
        raise UserError(f"--size is '{text}', but must look like 1600x900, with 100 to 20000 pixels each") from None
    return width, height


def choose_views(arguments, results):
    """Those of one run."""
    results.expect("solution.pvd")
    all_times = times(results.directory, "solution")
    if results.has("surface.pvd") and times(results.directory, "surface") != all_times:
        raise UserError(f"'{results.path('surface.pvd')}' and 'solution.pvd' have different times: "
                        "is the run complete?")
    if arguments.animation:
        return [View(results, step) for step in range(len(all_times))]
    for step in arguments.steps:
        check_step(step, results.path("solution.pvd"), len(all_times))
    return [View(results, step % len(all_times)) for step in arguments.steps]


def title(arguments, view):
    """What tells a view from the others."""
    parts = ([view.run] if len(arguments.directories) > 1 else []) + (
        [f"t = {view.time:g}"] if len(arguments.steps) > 1 else [])
    return ", ".join(parts) or arguments.title


def make_panels(arguments, views):
    if len({is_flat(view.fields("solution")["points"]) for view in views}) > 1:
        raise UserError("bodies in the plane and in space do not go side by side")
    contact = contact_to_look_at(views)
    panels = [BodyPanel(arguments, views, contact)] if "body" in arguments.panels else []
    if "pressure" in arguments.panels and contact and not is_flat(views[0].fields("solution")["points"]) and any(
            map(contact_at, views)):
        panels.append(PressurePanel(arguments, views, contact))
    if not panels:
        raise UserError("there is no contact pressure to be seen from above: the bodies are plane, nothing touches, or "
                        "the runs have not written surface.pvd")
    return panels


def draw_animation(arguments, panels, views, units):
    try:
        os.makedirs(arguments.animation, exist_ok=True)
    except OSError as error:
        raise UserError(f"the folder '{arguments.animation}' cannot be created: {error.strerror}") from None
    frames = [os.path.join(arguments.animation, f"frame_{i:04d}.png") for i in range(len(views))]
    for view, frame in zip(views, frames):
        save(draw_sheet(panels, [view], [f"t = {view.time:.3f}"], units, parse_size(arguments.size)), frame)
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


def main(arguments):
    arguments = parse_arguments(arguments)
    size = parse_size(arguments.size)
    runs = [Results(directory) for directory in arguments.directories]
    views = [view for results in runs for view in choose_views(arguments, results)]
    panels = make_panels(arguments, views)
    units = units_of(runs[0], arguments)
    if arguments.animation:
        draw_animation(arguments, panels, views, units)
        return
    figure = draw_sheet(panels, views, [title(arguments, view) for view in views], units, size)
    if len(views) > 1:
        figure.suptitle(arguments.title)
    save(figure, arguments.output or runs[0].path("picture.png"))
