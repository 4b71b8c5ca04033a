# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the curves of the ready fits: computed by the program on the meshes of the ready cases, with a noise of the
force of 1 % of its largest value (normal, the same numbers each time); that of a hold, in which a body creeps, with a
noise of the depth of 0.2 %; and that of a ball on a half space, as a laboratory has it, on the fine mesh of 'epc new'.

usage: scripts/command.py fit_data [--output-directory DIRECTORY] [--program PROGRAM]
"""

import argparse
import csv
import pathlib
import tempfile

import numpy
from scipy.interpolate import PchipInterpolator

from elasto_plastic_contact.files import new_file
from elasto_plastic_contact.fitting.loading import UNLOADING_TIME
from elasto_plastic_contact.fitting.predictions import Curve, curve_at
from elasto_plastic_contact.program import ROOT, add_program, run
from elasto_plastic_contact.study.plan import read_json
from ..verification.new_cases import file_of

# Swift's law with the reference strain sigma_Y / E: sigma_Y (1 + E plastic strain / sigma_Y)^n, in MPa.
YOUNG, YIELD_STRESS, EXPONENT = 200000., 400., 0.2
MATERIAL = {"Material/Law": "nonlinear hardening", "Material/Isotropic hardening modulus": 0,
            "Material/Young's modulus": YOUNG, "Material/Yield stress": YIELD_STRESS,
            "Material/Power law exponent": EXPONENT, "Material/Power law reference strain": YIELD_STRESS / YOUNG}

# Name of the curve, case and largest depth; the steps are those of the fits.
CURVES = {"sphere": ("indentation/sphere_finite_strain.prm", 0.1), "cone": ("indentation/cone_finite_strain.prm", 0.02)}
STEPS = {"Loading/Integration": "backward Euler", "Loading/Number of steps": 120}
NOISE = 0.01

# The curve of a ball, the same material by the options of 'epc new sphere'.
BALL = "ball"
OPTIONS = {"young_modulus": "200 GPa", "yield_stress": "400 MPa", "hardening": "power 0.2", "tip_radius": "1 mm",
           "depth": "100 um"}

# The problem of the hold, what its parameters are, its noise relative to the largest depth, and its points in time.
HOLD = "creep"
CREEP = {"D": 0.1, "n": 5.}
NOISE_OF_HOLD = 0.002
TIMES = numpy.append(numpy.linspace(0.2, 10., 50), numpy.linspace(10.5, 70., 120))
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


def creeping(folder, program, generator):
    """Rows of time, depth and force of the experiment in creep.json, with its fine mesh and the true parameters."""
    problem = read_json(folder / f"{HOLD}.json")
    experiment, = problem["experiments"].values()
    entries = experiment["set"] | {path: CREEP[name] for path, name in problem["entries"].items()}
    with tempfile.TemporaryDirectory() as directory:
        history = run(experiment["case"], directory, entries | {"Output/Fields": "never"}, overwrite=True,
                      program=program).history
    depth, force = (PchipInterpolator(numpy.append(0., history["time"]), numpy.append(0., history[column]))(TIMES)
                    for column in ("depth", "force"))
    return zip(TIMES, depth + NOISE_OF_HOLD * depth.max() * generator.normal(size=len(TIMES)), force)


def write_curve(path, results, generator):
    write(path, ["Depth (µm)", "Force (N)"],
          ([f"{1e3 * depth:.5g}", f"{force:.5g}"] for depth, force in measured(results, NOISE, generator)))


def write(path, head, rows):
    with new_file(path) as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(head)
        writer.writerows(rows)
    print(path)


def main(arguments):
    parser = argparse.ArgumentParser(prog="fit_data", formatter_class=argparse.RawDescriptionHelpFormatter,
                                     description=__doc__)
    parser.add_argument("--output-directory", type=pathlib.Path, help="default: parameter_files/fit of the checkout")
    add_program(parser)
    chosen = parser.parse_args(arguments)
    folder = chosen.output_directory or ROOT / "parameter_files/fit"
    generator = numpy.random.default_rng(46)
    for name, (case, depth) in CURVES.items():
        entries = MATERIAL | STEPS | {"Loading/History": f"1: depth {depth} | {UNLOADING_TIME}: force 0",
                                      "Output/Fields": "never"}
        with tempfile.TemporaryDirectory() as directory:
            write_curve(folder / f"{name}.csv", run(case, directory, entries, overwrite=True, program=chosen.program),
                        generator)
    write(folder / f"{HOLD}.csv", ["Time (s)", "Depth (nm)", "Force (mN)"],
          ([f"{time:.4g}", f"{1e3 * depth:.5g}", f"{force:.5g}"] for time, depth, force in
           creeping(ROOT / "parameter_files/fit", chosen.program, generator)))
    with file_of("sphere", "fine", OPTIONS) as case, tempfile.TemporaryDirectory() as directory:
        write_curve(folder / f"{BALL}.csv", run(case, directory, {"Output/Fields": "never"}, overwrite=True,
                                                program=chosen.program), generator)
    return 0
