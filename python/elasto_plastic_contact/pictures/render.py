# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw the deformed body of a run, with its plastic zone and the indenter and, in three
dimensions, the contact pressure seen from above: one picture, the steps of a history side by side,
or one picture for each step.

    scripts/render.py output/cone_axisymmetric --steps 5 20 39 --zoom 25 --output history.pdf
"""

import argparse
import os



from .contact import contact_at, contact_to_look_at
from .panels import BodyPanel, PressurePanel
from .sheet import draw_sheet
from ..errors import UserError
from ..fields import times
from ..plots.figures import add_units, save, units_of
from ..results import Results


def parse_arguments(arguments):
    parser = argparse.ArgumentParser(prog="render", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("directory", help="output directory of a run")
    parser.add_argument("--field", default="von_mises_stress",
                        help="what the colour shows, of vectors and tensors the root of the sum of the squares of "
                             "their components (default: %(default)s)")
    parser.add_argument("--scale", default="auto",
                        help="factor on the displacement: a number, or 'auto' for a dent that can be seen")
    parser.add_argument("--cut", default="auto", choices=["auto", "none", "x", "y"],
                        help="remove the part of a three-dimensional body in front of the contact, "
                             "at right angles to this axis (auto: if the contact is in the middle)")
    parser.add_argument("--zoom", type=float,
                        help="magnification about the contact; after it, about where it was last (default: 1, or so "
                             "much that the contact can be seen)")
    parser.add_argument("--steps", "--step", type=int, nargs="+", default=[-1], metavar="STEP",
                        help="which entries of the .pvd file, counted from 0 (default: the last), side by side "
                             "with the same colours and window")
    parser.add_argument("--no-pressure", action="store_true", help="leave out the panel with the contact pressure")
    parser.add_argument("--no-edges", action="store_true", help="leave out the mesh")
    parser.add_argument("--no-indenter", action="store_true", help="leave out the outline of the indenter")
    parser.add_argument("--title", default="", help="text above the picture")
    parser.add_argument("--size", default="", help="width x height in pixels, such as 1600x900")
    add_units(parser)
    parser.add_argument("--output", default="",
                        help="the picture, .png, .svg or .pdf (default: DIRECTORY/picture.png)")
    parser.add_argument("--animation", default="", metavar="FOLDER",
                        help="draw all entries of the .pvd file, with the same colours and window: "
                             "FOLDER/frame_0000.png and so on and, if there is Pillow (Debian package "
                             "python3-pil), FOLDER/animation.gif")
    arguments = parser.parse_args(arguments)
    if arguments.zoom is not None and arguments.zoom < 1.:
        parser.error(f"--zoom is {arguments.zoom:g}, but must be at least 1")
    if arguments.animation and (arguments.output or arguments.steps != [-1]):
        parser.error("--animation draws all entries into its folder: it goes neither with --output nor with --steps")
    return arguments


def parse_size(text):
    """Width and height in pixels; None for a size that fits."""
    if not text:
        return None
    try:
        width, height = (int(part) for part in text.lower().split("x"))
    except ValueError:
        raise UserError(f"--size is '{text}', but must look like 1600x900") from None
    return width, height


def choose_steps(arguments, all_times):
    if arguments.animation:
        return list(range(len(all_times)))
    for step in arguments.steps:
        if not -len(all_times) <= step < len(all_times):
            raise UserError(f"--steps has {step}, but solution.pvd has {len(all_times)} entries, "
                            "counted from 0, or from -1 backwards")
    return [step % len(all_times) for step in arguments.steps]


def make_panels(arguments, results, steps, all_times):
    contact = contact_to_look_at(results, steps)
    panels = [BodyPanel(arguments, results, steps, all_times, contact)]
    if contact and not panels[0].flat and not arguments.no_pressure and any(
            contact_at(results, step) for step in steps):
        panels.append(PressurePanel(arguments, results, steps, contact))
    return panels


def draw_animation(arguments, panels, steps, all_times, units):
    try:
        os.makedirs(arguments.animation, exist_ok=True)
    except OSError as error:
        raise UserError(f"the folder '{arguments.animation}' cannot be created: {error.strerror}") from None
    frames = [os.path.join(arguments.animation, f"frame_{i:04d}.png") for i in range(len(steps))]
    for step, frame in zip(steps, frames):
        save(draw_sheet(panels, [step], [f"t = {all_times[step]:.3f}"], units, parse_size(arguments.size)), frame)
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
    results = Results(arguments.directory)
    results.expect("solution.pvd")
    all_times = times(arguments.directory, "solution")
    if results.has("surface.pvd") and times(arguments.directory, "surface") != all_times:
        raise UserError(f"'{results.path('surface.pvd')}' and 'solution.pvd' have different times: "
                        "is the run complete?")
    steps = choose_steps(arguments, all_times)
    panels = make_panels(arguments, results, steps, all_times)
    units = units_of(results, arguments)
    if arguments.animation:
        draw_animation(arguments, panels, steps, all_times, units)
        return
    titles = [f"t = {all_times[step]:g}" for step in steps] if len(steps) > 1 else [arguments.title]
    figure = draw_sheet(panels, steps, titles, units, size)
    if len(steps) > 1:
        figure.suptitle(arguments.title)
    save(figure, arguments.output or results.path("picture.png"))
