# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plot what a run has written, as far as it has it: the contact pressure over the
distance from the indenter's axis (pressure.png; of a load history at the largest
force), the force over the number of unknowns (convergence.png), the deformed contact surface at the largest depth and
after unloading (imprint.png); of a load history, force and contact radius over the
depth (force_depth.png, contact_radius.png) and the energies over time
(energies.png); without an indenter, the forces of the supports over time
(reactions.png) and the stress-strain curve of a box that is loaded along an axis
(stress_strain.png); of a limit load in the plane, the fields on its last mesh
(equilibrium.png).

    scripts/plot.py output/sphere_axisymmetric
    scripts/plot.py force_depth energies output/sphere_axisymmetric --format svg --length-unit mm --force-unit N
    scripts/plot.py force_depth contact_radius output/sphere_axisymmetric --normalised --panels figure.pdf
"""

import os
import sys

from . import curves, equilibrium
from .figures import add_units, letter, make_parser, new_diagram, plt, save
from .quantities import check_shown_entry, scales_of
from ..arguments import number
from ..errors import UserError
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
                             "(default: what indentation.csv says, or 1)")
    parser.add_argument("--centre", type=number(), nargs="+",
                        help="horizontal coordinates of the indenter's axis (default: Indenter/Position)")
    parser.add_argument("--step", type=int,
                        help="which entry of surface.pvd, counted from 0 (default: of a load history the one with the "
                             "largest force, else the last)")
    parser.add_argument("--format", choices=["png", "svg", "pdf"], default="png",
                        help="of the files (default: %(default)s)")
    parser.add_argument("--output-directory", help="where the plots go (default: DIRECTORY)")
    parser.add_argument("--panels", metavar="FILE",
                        help="one figure with the panels (a), (b) and so on instead, the diagrams that are named")
    return parser


def draw_or_complain(name, run, arguments, scales, axes):
    if not DIAGRAMS[name](run, arguments, scales, axes):
        raise UserError(f"the run in '{arguments.directory}' has nothing to show for {name}")


def draw_panels(run, arguments, scales):
    if not arguments.names:
        raise UserError(f"--panels needs the names of the diagrams, some of {', '.join(DIAGRAMS)}")
    n = len(arguments.names)
    figure, panels = plt.subplots(1, n, figsize=(4.8 * n, 3.6), squeeze=False)
    for i, (name, axes) in enumerate(zip(arguments.names, panels[0])):
        draw_or_complain(name, run, arguments, scales, axes)
        letter(axes, i)
    save(figure, arguments.panels)


def path_of(name, arguments):
    return os.path.join(arguments.output_directory or arguments.directory, f"{name}.{arguments.format}")


def draw_each(run, arguments, scales):
    for name in arguments.names or DIAGRAMS:
        figure, axes = new_diagram()
        if arguments.names:
            draw_or_complain(name, run, arguments, scales, axes)
        elif not DIAGRAMS[name](run, arguments, scales, axes):
            plt.close(figure)
            continue
        save(figure, path_of(name, arguments))


def draw_limit_load(run, arguments):
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
    if arguments.step is not None:
        check_shown_entry(run, arguments.step)
    if run.has("limit_load.csv") and not arguments.names and not arguments.panels:
        draw_limit_load(run, arguments)
        return
    scales = scales_of(run, arguments)
    (draw_panels if arguments.panels else draw_each)(run, arguments, scales)
