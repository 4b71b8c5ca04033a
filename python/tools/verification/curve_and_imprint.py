# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two materials whose curves under a cone are equal within what is measured, and whose imprints are not: how far force,
depth of the unloading and imprint differ, and how well curve, and curve and imprint together, determine the first one.

usage: scripts/command.py curve_and_imprint [--fine] [--at-once 2] [--output-directory DIRECTORY] [--program PROGRAM]

Standard errors are those of a fit at the first material (inverse of J^T J, by central differences), for noises of 1 %
of the largest force and of 1 % of the depth (heights of the imprint). A command that has been stopped goes on where it
was.
"""

import argparse
import math
import pathlib

import numpy

from .published_metals import CONE, swift_entries
from elasto_plastic_contact.arguments import number
from elasto_plastic_contact.fitting.predictions import Curve, imprint_at, interpolated
from elasto_plastic_contact.fitting.runs import Runs, expect
from elasto_plastic_contact.fitting.statistics import covariance
from elasto_plastic_contact.program import add_program, find_program, ready_case
from elasto_plastic_contact.study.command import open_folder
from elasto_plastic_contact.study.plan import Case

DEPTH = 0.02  # of the case

# Yield stress and Young's modulus in MPa, exponent of sigma_Y (1 + E plastic strain / sigma_Y)^n.
NAMES = ("ln sigma_Y", "n", "ln E")
PAIR = ((280., 0.1, 63700.), (211.2, 0.2, 66800.))

NOISE = 0.01
STEP = 0.02  # of the differences, in ln sigma_Y, n and ln E

# Where curve and imprint are compared: shares of the largest depth and force, distances over the depth.
LOADING, UNLOADING, PLACES = numpy.linspace(0.02, 1., 120), numpy.linspace(0.98, 0.02, 60), numpy.linspace(0., 5., 60)


def entries(coordinates):
    """Of a material given by NAMES."""
    log_yield_stress, exponent, log_modulus = map(float, coordinates)
    return swift_entries(math.exp(log_modulus), math.exp(log_yield_stress), exponent)


def coordinates_of(material):
    yield_stress, exponent, modulus = material
    return numpy.array([numpy.log(yield_stress), exponent, numpy.log(modulus)])


def observed(run):
    """Force over the loading, depth over the unloading, heights of the imprint."""
    curve = Curve(run)
    top = curve.load[-1, 1]
    return (interpolated(*curve.load.T, LOADING * DEPTH, "loading"),
            interpolated(curve.unload[:, 1], curve.unload[:, 0], UNLOADING * top, "unloading"),
            imprint_at(run, PLACES * DEPTH))


def slope(one):
    """Of the unloading, down to half the force."""
    force, depth, _ = one
    return (UNLOADING[0] - 0.5) * force[-1] / (depth[0] - numpy.interp(0.5, UNLOADING[::-1], depth[::-1]))


def residuals(one, other, scale):
    """What is observed of another material less what is observed of one, over the noise of the one called 'scale': of
    the curve (a change of depth in the unloading is one of force, by its slope) and of the imprint."""
    changes = [after - before for before, after in zip(one, other)]
    curve = numpy.concatenate([changes[0], -slope(scale) * changes[1]]) / (NOISE * scale[0][-1])
    return curve, changes[2] / (NOISE * DEPTH)


def standard_errors(low, high, first):
    """From the curve alone, and together with the imprint. low, high: what is observed at both sides of the first
    material, for each coordinate."""
    columns = [residuals(before, after, first) for before, after in zip(low, high)]
    curve, imprint = (numpy.column_stack(parts) / (2. * STEP) for parts in zip(*columns))
    return [numpy.sqrt(numpy.diag(covariance(jacobian))) for jacobian in (curve, numpy.vstack([curve, imprint]))]


def main(arguments):
    parser = argparse.ArgumentParser(prog="curve_and_imprint", formatter_class=argparse.RawDescriptionHelpFormatter,
                                     description=__doc__)
    parser.add_argument("--fine", action="store_true", help="on the mesh of the ready case, instead of a coarse one")
    parser.add_argument("--at-once", type=number(int, least=1), default=2, help="runs at a time (default: %(default)s)")
    parser.add_argument("--output-directory", type=pathlib.Path, default="output/curve_and_imprint",
                        help="default: %(default)s")
    add_program(parser)
    chosen = parser.parse_args(arguments)
    program = find_program(chosen.program)
    common = CONE.entries | {"Output/Fields": "never"} | ({} if chosen.fine else CONE.coarse)
    case = Case(case=ready_case(CONE.case, program), common=common, ranks=1)
    with open_folder(chosen.output_directory, "pair"), Runs(chosen.output_directory, program, chosen.at_once) as runs:
        def found(points):
            return [observed(expect(result, "a run")) for result in runs.results([(case, entries(x)) for x in points])]

        first = coordinates_of(PAIR[0])
        one, other = found([first, coordinates_of(PAIR[1])])
        print_differences(one, other)
        steps = STEP * numpy.eye(3)
        around = found([*(first - steps), *(first + steps)])
    for text, errors in zip(("curve", "curve and imprint"), standard_errors(around[:3], around[3:], one)):
        print(f"standard errors from {text}: " + ", ".join(f"{name} {error:.3g}" for name, error in zip(NAMES, errors)))
    return 0


def print_differences(one, other):
    curve, imprint = residuals(one, other, one)
    for text, values in (("loading", curve[:len(LOADING)]), ("unloading", curve[len(LOADING):]), ("imprint", imprint)):
        print(f"{text}: {len(values)} values, differences over the noise: root of mean square "
              f"{numpy.sqrt((values ** 2).mean()):.2f}, largest {abs(values).max():.2f}")
    print(f"pile-up over depth: {one[2].max() / DEPTH:.3f} and {other[2].max() / DEPTH:.3f}")
