# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two fits of the first of the two materials of curve_and_imprint, begun at the second one, whose curve is the same: to
the curve of a cone alone, and to curve and imprint.

usage: scripts/command.py curve_and_imprint_fit [--at-once 2] [--output-directory DIRECTORY] [--program PROGRAM]

Curve and imprint are computed by the program on a coarse mesh and have a noise of 1 % of the largest force and of 1 % of
the depth; the fits are made on the same mesh. A command that has been stopped goes on where it was.
"""

import argparse
import csv
import functools
import pathlib

import numpy

from .curve_and_imprint import DEPTH, NOISE, PAIR, PLACES, coordinates_of, entries
from .published_metals import CONE
from elasto_plastic_contact.arguments import number
from elasto_plastic_contact.files import new_file
from elasto_plastic_contact.fitting.command import fit
from elasto_plastic_contact.fitting.predictions import imprint_at
from elasto_plastic_contact.fitting.runs import Runs, expect
from ..inputs.fit_data import measured
from elasto_plastic_contact.program import add_program, find_program, ready_case
from elasto_plastic_contact.study.command import open_folder
from elasto_plastic_contact.study.plan import Case

# Bounds of yield stress and Young's modulus in MPa and of the exponent; the step of derivatives in their coordinates.
BOUNDS = {"sigma_Y": (100., 600.), "n": (0., 0.4), "E": (50000., 85000.)}
STEP = 0.02
SETTINGS = CONE.entries | CONE.coarse

FITS = ("curve", "curve and imprint")


def write_data(folder, program):
    """The files that the fits read: those of the first material, with noise."""
    case = Case(case=ready_case(CONE.case, program), common=SETTINGS | {"Output/Fields": "never"}, ranks=1)
    with Runs(folder, program, 1) as runs:
        results = expect(runs.results([(case, entries(coordinates_of(PAIR[0])))])[0], "the run with the true material")
    generator = numpy.random.default_rng(8)
    heights = imprint_at(results, PLACES * DEPTH) + NOISE * DEPTH * generator.normal(size=len(PLACES))
    for name, head, rows in (("curve", ("Depth (mm)", "Force (N)"), measured(results, NOISE, generator)),
                             ("imprint", ("x", "height"), zip(PLACES * DEPTH, heights))):
        with new_file(folder / f"{name}.csv") as file:
            writer = csv.writer(file)
            writer.writerow(head)
            writer.writerows([f"{value:.8g}" for value in row] for row in rows)


def problem_of_fit(folder, name):
    """For fit(): one of FITS."""
    data = [{"curve": str(folder / "curve.csv"), "noise": {"of largest": NOISE}}]
    if "imprint" in name:
        data.append({"imprint": str(folder / "imprint.csv"), "noise": {"absolute": NOISE * DEPTH}})
    return {
        "parameters": {parameter: {"start": start, "lower": lower, "upper": upper} for (parameter, (lower, upper)), start
                       in zip(BOUNDS.items(), PAIR[1])},
        "entries": {"Material/Young's modulus": "E", "Material/Yield stress": "sigma_Y",
                    "Material/Power law exponent": "n", "Material/Power law reference strain": "sigma_Y / E"},
        "experiments": {"cone": {"case": CONE.case, "set": SETTINGS, "units": {"length": "mm", "force": "N"}, "data": data}},
        "step": STEP}


def fits_of(folder, program, at_once, report):
    """The Fit of each of FITS."""
    with open_folder(folder, "data"):
        write_data(folder, program)
    return {name: fit(problem_of_fit(folder, name), folder / name.replace(" ", "_"), program=program, at_once=at_once,
                      report=report) for name in FITS}


def region_in_words(region):
    """Such as '250 to 300', with a sign at an end that the data do not give."""
    return " to ".join(f"{mark * (not closed)}{end:.3g}" for end, closed, mark in
                       zip((region.lower, region.upper), region.closed, ("< ", "> ")))


def main(arguments):
    parser = argparse.ArgumentParser(prog="curve_and_imprint_fit", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--at-once", type=number(int, least=1), default=2, help="runs at a time (default: %(default)s)")
    parser.add_argument("--output-directory", type=pathlib.Path, default="output/curve_and_imprint_fit",
                        help="default: %(default)s")
    add_program(parser)
    chosen = parser.parse_args(arguments)
    found = fits_of(chosen.output_directory, find_program(chosen.program), chosen.at_once,
                    functools.partial(print, flush=True))
    for name, result in found.items():
        for (parameter, value), true in zip(result.values.items(), PAIR[0]):
            print(f"{name}: {parameter} {value:.4g}, 95 % region {region_in_words(result.regions[parameter])}; true "
                  f"{true:g}")
        print(f"{name}: {result.n_runs} runs, {result.processor_seconds:.0f} s of processors, {result.verdict}")
    return 0
