# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plot what a run has written, as far as it has it: the contact pressure over the
distance from the indenter's axis (pressure.png; of a load history at the largest
force), the force over the number of unknowns (convergence.png), the deformed contact surface at the largest depth and
after unloading (imprint.png); of a load history, force and contact radius over the
depth (force_depth.png, contact_radius.png) and the energies over time
(energies.png); without an indenter, the forces of the supports over time
(reactions.png) and the stress-strain curve of a box that is loaded along an axis
(stress_strain.png).

    scripts/plot.py output/sphere_axisymmetric
    scripts/plot.py force_depth energies output/sphere_axisymmetric --format svg --length-unit mm --force-unit N
    scripts/plot.py force_depth contact_radius output/sphere_axisymmetric --normalised --panels figure.pdf
"""

import os

from . import curves
from .figures import add_units, letter, make_parser, new_diagram, plt, save
from .quantities import scales_of
from ..errors import UserError
from ..results import Results

DIAGRAMS = {curve.__name__: curve for curve in curves.ALL}


def make_run_parser(epilog):
    parser = make_parser(__doc__, epilog=epilog)
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
    parser.add_argument("--parts", type=float,
                        help="how many of the computed part make up the whole body, such as 4 for a quarter "
                             "(default: what indentation.csv says, or 1)")
    parser.add_argument("--centre", type=float, nargs="+",
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


def draw_each(run, arguments, scales):
    for name in arguments.names or DIAGRAMS:
        figure, axes = new_diagram()
        if arguments.names:
            draw_or_complain(name, run, arguments, scales, axes)
        elif not DIAGRAMS[name](run, arguments, scales, axes):
            plt.close(figure)
            continue
        folder = arguments.output_directory or arguments.directory
        save(figure, os.path.join(folder, f"{name}.{arguments.format}"))


def main(arguments, epilog):
    arguments = make_run_parser(epilog).parse_args(arguments)
    unknown = [name for name in arguments.names if name not in DIAGRAMS]
    if unknown:
        raise UserError(f"there is no diagram '{unknown[0]}' of a run; there are {', '.join(DIAGRAMS)}")
    run = Results(arguments.directory)
    scales = scales_of(run, arguments)
    (draw_panels if arguments.panels else draw_each)(run, arguments, scales)
