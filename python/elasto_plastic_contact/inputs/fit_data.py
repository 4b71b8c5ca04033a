# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the curves of the ready fits: computed by the program on the meshes of the ready cases, with a noise of the
force of 1 % of its largest value (normal, the same numbers each time).

usage: scripts/command.py fit_data [--output-directory DIRECTORY] [--program PROGRAM]
"""

import argparse
import csv
import pathlib
import tempfile

import numpy

from ..files import new_file
from ..fitting.predictions import Curve, curve_at
from ..program import ROOT, run
from ..verification.runner import add_program

# Swift's law with the reference strain sigma_Y / E: sigma_Y (1 + E plastic strain / sigma_Y)^n, in MPa.
YOUNG, YIELD_STRESS, EXPONENT = 200000., 400., 0.2
MATERIAL = {"Material/Law": "nonlinear hardening", "Material/Isotropic hardening modulus": 0,
            "Material/Young's modulus": YOUNG, "Material/Yield stress": YIELD_STRESS,
            "Material/Power law exponent": EXPONENT, "Material/Power law reference strain": YIELD_STRESS / YOUNG}

# Name of the curve and case.
CURVES = {"sphere": "indentation/sphere_finite_strain.prm", "cone": "indentation/cone_finite_strain.prm"}
NOISE = 0.01
POINTS = {"load": 120, "unload": 60}


def measured(results, noise, generator):
    """Rows of depth and force, from 2 % of the largest ones up and back to 2 % of the force."""
    rows, largest = [], Curve(results).load[-1, 1]
    for segment, n_points in POINTS.items():
        depths = Curve(results).segment(segment)[:, 0]
        first = 0.02 * depths.max() if segment == "load" else depths[0]
        places = numpy.linspace(first, depths[-1], n_points + 1)[:n_points]
        forces = curve_at(results, segment, "force", places)
        rows += zip(places, forces + noise * largest * generator.normal(size=n_points))
    return rows


def main(arguments):
    parser = argparse.ArgumentParser(prog="fit_data", formatter_class=argparse.RawDescriptionHelpFormatter,
                                     description=__doc__)
    parser.add_argument("--output-directory", type=pathlib.Path, help="default: parameter_files/fit of the checkout")
    add_program(parser)
    chosen = parser.parse_args(arguments)
    folder = chosen.output_directory or ROOT / "parameter_files/fit"
    generator = numpy.random.default_rng(46)
    for name, case in CURVES.items():
        with tempfile.TemporaryDirectory() as directory:
            results = run(case, directory, MATERIAL | {"Output/Fields": "never"}, overwrite=True,
                          program=chosen.program)
            rows = measured(results, NOISE, generator)
        with new_file(folder / f"{name}.csv") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(["Depth (µm)", "Force (N)"])
            writer.writerows([f"{1e3 * depth:.5g}", f"{force:.5g}"] for depth, force in rows)
        print(folder / f"{name}.csv")
    return 0
