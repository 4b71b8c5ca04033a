#!/usr/bin/python3
# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plot what a run has written, as far as it has it: the contact pressure over the
distance from the indenter's axis (pressure.png), the force over the number of
unknowns (convergence.png); of a load history, force and contact radius over the
depth (force_depth.png, contact_radius.png) and the energies over time
(energies.png); without an indenter, the forces of the supports over time
(reactions.png) and the stress-strain curve of a box that is displaced at one end
(stress_strain.png).

Needs matplotlib and VTK's Python modules (Debian packages python3-matplotlib,
and python3-paraview or python3-vtk9).
"""

import argparse
import os
import sys


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("directory", help="output directory of a run")
    parser.add_argument("--hertz", choices=["sphere", "cylinder"],
                        help="also draw the pressure of Hertz under the same force, for a sphere "
                             "(three-dimensional or axisymmetric) or a cylinder (plane strain)")
    parser.add_argument("--parts", type=float,
                        help="how many of the computed part make up the whole body, such as 4 for a quarter "
                             "(default: what indentation.csv says, or 1)")
    parser.add_argument("--centre", type=float, nargs="+",
                        help="horizontal coordinates of the indenter's axis (default: Indenter/Position)")
    parser.add_argument("--step", type=int, default=-1,
                        help="which entry of surface.pvd, counted from 0 (default: the last)")
    parser.add_argument("--output-directory", help="where the plots go (default: DIRECTORY)")
    return parser.parse_args()


def main():
    arguments = parse_arguments()
    try:
        import curves
        from run_results import ResultError, Run
        import vtkmodules.vtkIOXML  # noqa: F401 (what reading fields needs)
    except ImportError as error:
        sys.exit(f"plot.py: {error}: Debian packages python3-matplotlib and python3-paraview (or python3-vtk9)")
    try:
        run = Run(arguments.directory)
        for curve in curves.ALL:
            figure = curve(run, arguments)
            if figure:
                path = os.path.join(arguments.output_directory or arguments.directory, f"{curve.__name__}.png")
                figure.savefig(path)
                print(path)
    except ResultError as error:
        sys.exit(f"plot.py: {error}")
    except OSError as error:
        sys.exit(f"plot.py: '{error.filename}' cannot be written: {error.strerror}")


if __name__ == "__main__":
    main()
