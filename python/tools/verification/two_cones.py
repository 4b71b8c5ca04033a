# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fits of what others have computed of cones of two angles [lu_2020], against the materials they have computed it of.

usage: scripts/command.py two_cones [--coarse] [--at-once 2] [--output-directory DIRECTORY] [--program PROGRAM]

Prints, for each row of the published tables, what this program gives for its material beside what is published, and
then the fit of Young's modulus, yield stress and exponent to loading curvature, slope of the unloading and plastic work
share of a cone of 70.3 degrees, and the loading curvature of one of 60 degrees; the same fit to what this program gives,
known ten times better; and what a fit makes of an error in each quantity. A command that has been stopped goes on where it
was.
"""

import argparse
import functools
import pathlib
from dataclasses import dataclass

import numpy

from .published_metals import COMMON, CONE, CURVATURE, SLOPE, UNITS, WORK_SHARE, swift_entries
from elasto_plastic_contact.arguments import number
from elasto_plastic_contact.fitting.command import fit
from elasto_plastic_contact.fitting.flow_stress import flow_stress
from elasto_plastic_contact.fitting.models import ProgramModel
from elasto_plastic_contact.fitting.optimisation import Derivatives, start_of
from elasto_plastic_contact.fitting.predictions import QUANTITIES
from elasto_plastic_contact.fitting.reading import read_problem
from elasto_plastic_contact.fitting.runs import Runs, expect
from elasto_plastic_contact.program import add_program, find_program, ready_case
from elasto_plastic_contact.study.command import open_folder
from elasto_plastic_contact.study.plan import Case

ANGLES = {"blunt": 70.3, "sharp": 60}

# Where stress-strain curves are compared: the plastic strain that represents the blunt cone [dao_2001], and that of the
# sharp one, larger as the cotangent of the angle [johnson_1985].
STRAINS = (0.033, 0.053)

# The depth at which slopes are published, in m.
DEPTH = 2e-7

# Of what is published, relative; of the plastic work share, absolute. Of what this program gives, that part of it.
NOISE, NOISE_OF_SHARE = 0.01, 0.003
OWN = 0.1

STEP = 0.04  # of the differences, in the coordinates of a fit


@dataclass(frozen=True)
class Row:
    """Young's modulus, yield stress (GPa) and exponent; of both cones the loading curvature in GPa, of the blunt one the
    slope of the unloading in N/m and the plastic work share."""
    young: float
    yield_stress: float
    exponent: float
    blunt_curvature: float
    slope: float
    work_share: float
    sharp_curvature: float

    def published(self):
        """By cone and quantity, in GPa."""
        return {"blunt": {CURVATURE: self.blunt_curvature, SLOPE: 1e-9 * self.slope / DEPTH, WORK_SHARE: self.work_share},
                "sharp": {CURVATURE: self.sharp_curvature}}

    def values(self):
        """Of the parameters of a fit."""
        return {"E": 1e3 * self.young, "sigma_Y": 1e3 * self.yield_stress, "n": self.exponent}

    def entries(self):
        return swift_entries(*self.values().values())


# By the numbers of their cases.
ROWS = {1004: Row(177.128, 0.77102177, 0.104538091, 79.0083632, 242266.561, 0.892374516, 33.053029),
        1005: Row(73.432, 0.561384659, 0.177243493, 51.55608338, 91208.7232, 0.813524272, 23.3765256),
        1006: Row(83.518, 0.698605786, 0.248499571, 66.71392543, 95641.878, 0.781243186, 31.2771226)}


def deviation(name, value):
    """Of a published quantity."""
    return NOISE * value if name in UNITS else NOISE_OF_SHARE


def problem_of(known, coarse, noise=1.):
    """As a file of a fit, in mm, N and MPa. known: quantities by cone and name, in GPa; noise: over that of what is
    published."""
    experiments = {}
    for cone, quantities in known.items():
        data = [{"quantity": name, "value": value, "noise": {"absolute": noise * deviation(name, value)}}
                | ({"unit": UNITS[name]} if name in UNITS else {}) for name, value in quantities.items()]
        settings = CONE.entries | {"Indenter/Semi-apex angle": ANGLES[cone]}
        experiment = {"case": CONE.case, "units": {"length": "mm", "force": "N"}, "data": data}
        experiments[cone] = experiment | ({"set": settings | CONE.coarse} if coarse else
                                          {"set": settings, "coarse": CONE.coarse})
    return {"parameters": {"E": {"start": 100000, "lower": 20000, "upper": 400000},
                           "sigma_Y": {"start": 500, "lower": 50, "upper": 3000},
                           "n": {"start": 0.2, "lower": 0, "upper": 0.5}},
            "entries": {"Material/Young's modulus": "E", "Material/Yield stress": "sigma_Y",
                        "Material/Power law exponent": "n", "Material/Power law reference strain": "sigma_Y / E"},
            "experiments": experiments}


def of_materials(folder, program, coarse, at_once):
    """What this program gives for the material of each row: its case and quantities by cone and name, in GPa."""
    places = [(row, cone) for row in ROWS for cone in ANGLES]
    with open_folder(folder, "rows"), Runs(folder, program, at_once) as runs:
        case = Case(case=ready_case(CONE.case, program), ranks=1,
                    common=CONE.entries | {"Output/Fields": "never"} | (CONE.coarse if coarse else {}))
        results = runs.results([(case, ROWS[row].entries() | {"Indenter/Semi-apex angle": ANGLES[cone]})
                                for row, cone in places])
    return {(row, cone): {name: QUANTITIES[name][0](expect(result, "a run")) / (1e3 if name in UNITS else 1.)
                          for name in ROWS[row].published()[cone]}
            for (row, cone), result in zip(places, results)}


def compare_with_published(computed):
    """Case, what it is, value and what is published, of what of_materials() returns."""
    return [(case, f"{name}, {ANGLES[cone]:g} degrees", value, ROWS[case].published()[cone][name])
            for (case, cone), quantities in computed.items() for name, value in quantities.items()]


def fit_case(case, folder, program, coarse, at_once):
    """The values of its parameters."""
    return values_of(problem_of(ROWS[case].published(), coarse), folder / f"case_{case}", program, at_once)


def fit_own(case, computed, folder, program, coarse, at_once):
    """As fit_case(), of what of_materials() returns."""
    known = {cone: computed[case, cone] for cone in ANGLES}
    return values_of(problem_of(known, coarse, OWN), folder / f"own_{case}", program, at_once)


def values_of(problem, folder, program, at_once):
    return fit(problem, folder, program=program, at_once=at_once, report=functools.partial(print, flush=True)).values


def errors_of_fit(case, folder, program, coarse, at_once):
    """What a fit at the material makes of a quantity that is larger by its noise: for each quantity its cone and name, and
    the changes of ln E, of the logarithm of the yield stress, and of the exponent."""
    problem = read_problem(problem_of(ROWS[case].published(), coarse), program)
    values = ROWS[case].values()
    x = numpy.array([parameter.coordinate(values[parameter.name]) for parameter in problem.parameters])
    with open_folder(folder, "errors"), Runs(folder, program, at_once) as runs:
        model = ProgramModel(problem, runs, "fine")
        jacobian = Derivatives(model, STEP)(x, start_of(model, x))
    sizes = [1. if parameter.is_logarithmic else parameter.size for parameter in problem.parameters]
    places = [(cone, name) for cone, quantities in ROWS[case].published().items() for name in quantities]
    return dict(zip(places, (numpy.linalg.pinv(jacobian) * numpy.reshape(sizes, (-1, 1))).T))


def expected_change(case, errors, computed):
    """What those make of the differences of what is published from what of_materials() returns."""
    known = ROWS[case].published()
    return sum(changes * (known[cone][name] - computed[case, cone][name]) / deviation(name, known[cone][name])
               for (cone, name), changes in errors.items())


def numbers_of(values):
    """E in GPa, yield stress in MPa, exponent, and the stresses at STRAINS in MPa."""
    stresses = flow_stress(COMMON | swift_entries(*values.values()), list(STRAINS))
    return values["E"] / 1e3, values["sigma_Y"], values["n"], *stresses


def compare_with_material(case, values):
    """Case, what it is, value of the fit and that of the material."""
    names = ("E in GPa", "yield stress in MPa", "exponent", *(f"stress at {strain:g} in MPa" for strain in STRAINS))
    return [(case, *compared) for compared in zip(names, numbers_of(values), numbers_of(ROWS[case].values()))]


def in_words(changes):
    """Of yield stress and exponent, of an entry of errors_of_fit()."""
    return f"yield stress {100. * changes[1]:+.1f} %, exponent {changes[2]:+.3f}"


def print_rows(rows):
    for case, what, value, known in rows:
        print(f"case {case}, {what}: {value:.4g} for {known:.4g} ({100. * (value / known - 1.):+.1f} %)", flush=True)


def main(arguments):
    parser = argparse.ArgumentParser(prog="two_cones", formatter_class=argparse.RawDescriptionHelpFormatter,
                                     description=__doc__)
    parser.add_argument("--coarse", action="store_true", help="on a coarse mesh only")
    parser.add_argument("--at-once", type=number(int, least=1), default=2, help="runs at a time (default: %(default)s)")
    parser.add_argument("--output-directory", type=pathlib.Path, default="output/two_cones", help="default: %(default)s")
    add_program(parser)
    chosen = parser.parse_args(arguments)
    program, folder = find_program(chosen.program), chosen.output_directory
    how = (program, chosen.coarse, chosen.at_once)
    computed = of_materials(folder / "rows", *how)
    print_rows(compare_with_published(computed))
    for case in ROWS:
        print_rows(compare_with_material(case, fit_case(case, folder, *how)))
        print("to what this program gives:")
        print_rows(compare_with_material(case, fit_own(case, computed, folder, *how)))
        errors = errors_of_fit(case, folder / "errors", *how)
        for (cone, name), changes in errors.items():
            print(f"case {case}, {name} of {ANGLES[cone]:g} degrees larger by its noise: {in_words(changes)}")
        print(f"case {case}, larger by what is published: {in_words(expected_change(case, errors, computed))}", flush=True)
    return 0
