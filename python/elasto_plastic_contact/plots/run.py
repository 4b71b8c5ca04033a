# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plot what a run has written, as far as it has it: the contact pressure over the
distance from the indenter's axis (pressure.png; of a load history at the largest
force), the force over the number of unknowns (convergence.png), the deformed contact surface at the largest depth and
after unloading (imprint.png); of a load history, force and contact radius over the
depth (force_depth.png, contact_radius.png) and the energies over time
(energies.png); with a rate law, the depth over time (depth_time.png) and the hardness over
the rate of the depth (hardness_rate.png); without an indenter, the forces of the supports over time
(reactions.png) and the stress-strain curve of a box that is loaded along an axis
(stress_strain.png); of a limit load in the plane, the fields on its last mesh
(equilibrium.png). Forces and energies are those of the whole body, also where a half or a sector of it is computed.

    epc plot output/sphere_axisymmetric
    epc plot force_depth energies output/sphere_axisymmetric --format svg --length-unit mm --force-unit N
    epc plot force_depth contact_radius output/sphere_axisymmetric --normalised --panels figure.pdf
"""

import os
import sys

from . import curves, equilibrium
from .figures import add_units, letter, make_parser, new_diagram, plt, save
from .quantities import check_shown_entry, scales_of
from ..arguments import folder, number, picture
from ..errors import FileError, NothingToShow, UserError
from ..results import Results

DIAGRAMS = {curve.__name__: curve for curve in curves.ALL}


def make_run_parser(others):
    names = "".join(f"\n  plot {name} ... : {text}" for name, text in others.items())
    parser = make_parser(__doc__, epilog=f"Other diagrams (each explains itself with --help):{names}")
    parser.add_argument("names", nargs="*", metavar="NAME",
                        help=f"only some of {', '.join(DIAGRAMS)}")
    parser.add_argument("directory", help="output directory of a run")
    parser.add_argument("--hertz", choices=["sphere", "cylinder"],
                        help="also draw the pressure of Hertz under the same force, for a sphere "
                             "(three-dimensional or axisymmetric) or a cylinder (plane strain)")
    parser.add_argument("--normalised", action="store_true",
                        help="lengths over the largest contact radius a, stresses over the yield stress Y, forces "
                             "over Y times the largest contact area A; with --hertz over Hertz's radius a and "
                             "largest pressure p0")
    add_units(parser)
    parser.add_argument("--parts", type=number(above=0),
                        help="how many of the computed part make up the whole body, such as 4 for a quarter "
                             "(default: what the contact radius of the run says)")
    parser.add_argument("--centre", type=number(), nargs="+",
                        help="horizontal coordinates of the indenter's axis (default: Indenter/Position)")
    parser.add_argument("--step", type=int,
                        help="which entry of surface.pvd, counted from 0 (default: of a load history the one with the "
                             "largest force, else the last)")
    parser.add_argument("--format", choices=["png", "svg", "pdf"], help="of the files (default: png)")
    parser.add_argument("--output-directory", type=folder,
                        help="where the plots go, a folder that is made if need be (default: DIRECTORY)")
    parser.add_argument("--panels", type=picture, metavar="FILE",
                        help="one figure with the panels (a), (b) and so on instead, the diagrams that are named")
    return parser


def drawn_names(run, arguments):
    """Those that are named, or all, without the pressure if there are no fields."""
    return arguments.names or [name for name in DIAGRAMS if name != "pressure" or run.has("surface.pvd")]


def check_options(run, arguments):
    """Refuses options that nothing of what is drawn depends on."""
    names = drawn_names(run, arguments)
    has_pressure = "pressure" in names
    is_scaled_by_hertz = arguments.hertz and arguments.normalised
    for option, is_used, needed in (
            ("hertz", has_pressure or is_scaled_by_hertz, "the diagram pressure and fields of the surface, or --normalised"),
            ("parts", arguments.hertz or not arguments.normalised, "--hertz, or axes with units, not --normalised"),
            ("step", has_pressure or is_scaled_by_hertz, "the diagram pressure and fields of the surface"),
            ("centre", has_pressure or "imprint" in names, "the diagram pressure or imprint"),
            ("panels", arguments.names, f"the names of the diagrams, some of {', '.join(DIAGRAMS)}"),
            ("format", not arguments.panels, "files of their own, not --panels, whose name says the format"),
            ("output_directory", not arguments.panels, "files of their own, not --panels, which names the file"),
            ("length_unit", not arguments.normalised, "axes with units, not --normalised"),
            ("force_unit", not arguments.normalised, "axes with units, not --normalised")):
        if getattr(arguments, option) is not None and not is_used:
            raise UserError(f"--{option.replace('_', '-')} needs {needed}")
    if arguments.centre and len(arguments.centre) > (n_directions := int(run.number("Dimension")) - 1):
        raise UserError(f"--centre has {len(arguments.centre)} coordinates, but must have at most {n_directions}, the number "
                        "of horizontal directions")


def draw_or_complain(name, run, arguments, scales, axes):
    try:
        DIAGRAMS[name](run, arguments, scales, axes)
    except NothingToShow as error:
        raise UserError(f"the run in '{arguments.directory}' has nothing to show for {name}: {error}") from None


def draw_panels(run, arguments, scales):
    n = len(arguments.names)
    figure, panels = plt.subplots(1, n, figsize=(4.8 * n, 3.6), squeeze=False)
    for i, (name, axes) in enumerate(zip(arguments.names, panels[0])):
        draw_or_complain(name, run, arguments, scales, axes)
        letter(axes, i)
    save(figure, arguments.panels)


def make_folder(path):
    """Raises FileError."""
    try:
        os.makedirs(path, exist_ok=True)
    except OSError as error:
        raise FileError(path, error) from None


def path_of(name, arguments):
    return os.path.join(arguments.output_directory or arguments.directory, f"{name}.{arguments.format or 'png'}")


def draw_each(run, arguments, scales):
    for name in arguments.names:
        figure, axes = new_diagram()
        draw_or_complain(name, run, arguments, scales, axes)
        save(figure, path_of(name, arguments))


def draw_all(run, arguments, scales):
    """What the run has; if that is nothing, says so."""
    reasons = {}
    for name, diagram in DIAGRAMS.items():
        figure, axes = new_diagram()
        try:
            diagram(run, arguments, scales, axes)
            save(figure, path_of(name, arguments))
        except NothingToShow as error:
            plt.close(figure)
            reasons[name] = str(error)
    if len(reasons) == len(DIAGRAMS):
        print(f"plot: the run in '{arguments.directory}' has nothing to show: "
              + "; ".join(f"{name}: {reason}" for name, reason in reasons.items()), file=sys.stderr)


def draw_limit_load(run, arguments):
    for option in ("hertz", "normalised", "parts", "centre", "length_unit", "force_unit"):
        if getattr(arguments, option):
            raise UserError(f"--{option.replace('_', '-')} has no meaning for the fields of a limit load")
    if not run.has("limit_load.pvd"):
        print("plot: of a limit load nothing is drawn without its fields: 'Output/Fields' was 'never'",
              file=sys.stderr)
    elif run.parameters.get("Dimension") == "3":
        print(f"plot: '{run.path('limit_load.pvd')}' is of a body in space: ParaView shows it", file=sys.stderr)
    else:
        equilibrium.draw(run.directory, path_of("equilibrium", arguments))


def main(arguments, others):
    """others: what the diagrams show that have commands of their own, by name."""
    arguments = make_run_parser(others).parse_args(arguments)
    unknown = [name for name in arguments.names if name not in DIAGRAMS]
    if unknown:
        raise UserError(f"there is no diagram '{unknown[0]}' of a run; there are {', '.join(DIAGRAMS)}. "
                        f"Others, one at a time and as the first word, are {', '.join(others)}")
    run = Results(arguments.directory)
    if arguments.names or arguments.panels:
        run.expect("history.csv")
    if arguments.step is not None:
        check_shown_entry(run, arguments.step)
    if run.has("limit_load.csv"):
        make_folder(arguments.output_directory or arguments.directory)
        draw_limit_load(run, arguments)
        return
    check_options(run, arguments)
    scales = scales_of(run, arguments)
    make_folder(arguments.output_directory or arguments.directory)
    draw = draw_panels if arguments.panels else draw_each if arguments.names else draw_all
    draw(run, arguments, scales)
