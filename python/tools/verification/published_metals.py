# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fits of published measurements on two aluminium alloys under Berkovich's pyramid, against tension tests [lu_2020].

usage: scripts/command.py published_metals [--with-slope | --pyramid] [--slope-fit 0.5 0.95] [--coarse] [--at-once 2]
                                           [--output-directory DIRECTORY] [--program PROGRAM]

Prints, for each metal, what a cone of 70.3 degrees gives on the material of the tension test, beside what was measured,
and then the fit of yield stress and E* to loading curvature and plastic work share, with an exponent of 0.1. With
--with-slope the initial slope of the unloading is fitted, too, and the exponent is looked for. With --pyramid, the
pyramid itself is pressed in, and yield stress and E* are fitted to all three quantities. With --slope-fit, slopes are those
of a power law between these shares of the largest force, as laboratories evaluate them, in place of initial ones. Beside
the slopes it prints those of the published functions of a cone [dao_2001]. A command that has been stopped goes on where it
was.
"""

import argparse
import dataclasses
import functools
import math
import pathlib
from dataclasses import dataclass

from elasto_plastic_contact.arguments import number
from elasto_plastic_contact.fitting.command import fit
from elasto_plastic_contact.fitting.flow_stress import flow_stress
from elasto_plastic_contact.fitting.predictions import FITTED_SLOPES, QUANTITIES
from elasto_plastic_contact.fitting.runs import Runs, expect
from elasto_plastic_contact.program import add_program, find_program, ready_case
from elasto_plastic_contact.study.command import open_folder
from elasto_plastic_contact.study.plan import Case

COMMON = {"Material/Law": "nonlinear hardening", "Material/Isotropic hardening modulus": 0}


@dataclass(frozen=True)
class Tip:
    """Its ready case, entries besides, those that make its mesh coarse, and what is fitted."""
    name: str
    case: str
    entries: dict
    coarse: dict
    quantities: tuple
    looks_for_exponent: bool = False
    slope_fit: tuple = ()

    def slope_options(self, name):
        return {"fit": list(self.slope_fit)} if self.slope_fit and name == SLOPE else {}

    def find(self, name, run):
        """A quantity of a run, in its units."""
        return FITTED_SLOPES[name](run, self.slope_fit) if self.slope_options(name) else QUANTITIES[name][0](run)


CURVATURE, WORK_SHARE, SLOPE = "loading curvature", "plastic work share", "unloading slope over depth"

CONE = Tip("", "indentation/cone_finite_strain.prm",
           COMMON | {"Indenter/Semi-apex angle": 70.3, "Loading/History": "1: depth 0.02 | 1.2: force 0",
                     "Loading/Number of steps": 120, "Loading/Integration": "backward Euler"},
           {"Geometry/Initial refinements": 3, "Geometry/Local refinements": 7, "Geometry/Local radius": 4,
            "Loading/Number of steps": 48}, (CURVATURE, WORK_SHARE))
CONE_WITH_SLOPE = dataclasses.replace(CONE, name="_with_slope", quantities=(CURVATURE, WORK_SHARE, SLOPE),
                                      looks_for_exponent=True)
PYRAMID = Tip("_pyramid", "indentation/berkovich_sector.prm",
              COMMON | {"Loading/History": "0.1: depth 0.002 | 0.35: depth 0.007 | 1: depth 0.02 | 1.2: force 0",
                        "Loading/Number of steps": 60, "Loading/Integration": "backward Euler"},
              {"Geometry/Initial refinements": 2}, (CURVATURE, WORK_SHARE, SLOPE))

# The representative plastic strain [dao_2001].
STRAIN = 0.033

# What is assumed of metals of this kind where the data do not say it.
EXPONENT = 0.1

# 1 - nu^2: the rigid cone on a body with E / (1 - nu^2) = E* stands for diamond and metal together.
CONTRAST = 0.91


@dataclass(frozen=True)
class Metal:
    """Means and standard deviations of six indents: loading curvature and unloading slope over depth in GPa, plastic
    work share. tensile: E* with a diamond in GPa, yield stress and stress at STRAIN in MPa, exponent."""
    curvature: tuple
    slope: tuple
    work_share: tuple
    tensile: tuple

    def quantities(self):
        return {CURVATURE: self.curvature, WORK_SHARE: self.work_share, SLOPE: self.slope}


METALS = {"Al 6061-T6511": Metal((27.44, 0.42), (489.4, 13.), (0.8964, 0.0078), (70.2, 284., 338., 0.08)),
          "Al 7075-T651": Metal((42.73, 1.3), (483.8, 12.), (0.8349, 0.0035), (73.4, 500., 617.5, 0.122))}

UNITS = {CURVATURE: "GPa", SLOPE: "GPa"}


def folder_of(name, tip=CONE):
    return name.lower().replace(" ", "_") + tip.name + ("_power_law" if tip.slope_fit else "")


def published_functions(metal):
    """Loading curvature and slope over depth in GPa of the material of the tension test, by the functions that the
    computations of [dao_2001] under a cone of 70.3 degrees have been fitted to."""
    modulus, _, stress, n = metal.tensile
    x = math.log(1e3 * modulus / stress)
    curvature = 1e-3 * stress * (-1.131 * x ** 3 + 13.635 * x ** 2 - 30.594 * x + 29.267)
    terms = ((-1.40557, 0.77526, 0.1583, -0.06831), (17.93006, -9.22091, -2.37733, 0.86295),
             (-79.99715, 40.55620, 9.00157, -2.54543), (122.65069, -63.88418, -9.58936, 6.20045))
    slope = modulus * sum(sum(c * n ** (3 - j) for j, c in enumerate(row)) * x ** (3 - i) for i, row in enumerate(terms))
    return {CURVATURE: curvature, SLOPE: slope}


def swift_entries(young, yield_stress, exponent):
    """Of a material sigma_Y (1 + E plastic strain / sigma_Y)^n."""
    return {"Material/Young's modulus": young, "Material/Yield stress": yield_stress,
            "Material/Power law exponent": exponent, "Material/Power law reference strain": yield_stress / young}


def tensile_entries(metal):
    """Of the material of the tension test, in MPa."""
    modulus, yield_stress, _, exponent = metal.tensile
    return swift_entries(CONTRAST * 1e3 * modulus, yield_stress, exponent)


def problem_of(metal, tip, coarse):
    """As a file of a fit, in mm, N and MPa."""
    known = metal.quantities()
    data = [{"quantity": name, "value": known[name][0], "noise": {"absolute": known[name][1]}}
            | ({"unit": UNITS[name]} if name in UNITS else {}) | tip.slope_options(name) for name in tip.quantities]
    experiment = {"case": tip.case, "set": tip.entries | (tip.coarse if coarse else {}),
                  "units": {"length": "mm", "force": "N"}, "data": data}
    parameters = {"sigma_Y": {"start": 300, "lower": 50, "upper": 1500},
                  "Es": {"start": 80000, "lower": 30000, "upper": 200000}}
    exponent = {"n": {"start": EXPONENT, "lower": 0, "upper": 0.5}}
    return {"parameters": parameters | (exponent if tip.looks_for_exponent else {}),
            "constants": {} if tip.looks_for_exponent else {"n": EXPONENT},
            "entries": {"Material/Young's modulus": f"{CONTRAST} * Es", "Material/Yield stress": "sigma_Y",
                        "Material/Power law exponent": "n",
                        "Material/Power law reference strain": f"sigma_Y / ({CONTRAST} * Es)"},
            "experiments": {"berkovich": experiment if coarse else experiment | {"coarse": tip.coarse}}}


def from_tension(folder, program, tip, coarse, at_once):
    """What the tension tests say of the quantities, in GPa: a dictionary for each metal."""
    case = Case(case=ready_case(tip.case, program), ranks=1,
                common=tip.entries | {"Output/Fields": "never"} | (tip.coarse if coarse else {}))
    with open_folder(folder, "metals"), Runs(folder, program, at_once) as runs:
        results = runs.results([(case, tensile_entries(metal)) for metal in METALS.values()])
    return [{name: tip.find(name, expect(result, "a run")) / (1e3 if name in UNITS else 1.)
             for name in METALS[metal].quantities()} for metal, result in zip(METALS, results)]


def fitted(name, folder, program, tip, coarse, at_once):
    """The Fit, and its E* in GPa and stress at STRAIN in MPa."""
    found = fit(problem_of(METALS[name], tip, coarse), folder / folder_of(name, tip), program=program,
                at_once=at_once, report=functools.partial(print, flush=True))
    values = found.values
    material = swift_entries(CONTRAST * values["Es"], values["sigma_Y"], values.get("n", EXPONENT))
    stress = flow_stress(COMMON | material, [STRAIN])[0]
    return found, values["Es"] / 1e3, float(stress)


def main(arguments):
    parser = argparse.ArgumentParser(prog="published_metals", formatter_class=argparse.RawDescriptionHelpFormatter,
                                     description=__doc__)
    parser.set_defaults(tip=CONE)
    tips = parser.add_mutually_exclusive_group()
    tips.add_argument("--with-slope", dest="tip", action="store_const", const=CONE_WITH_SLOPE,
                      help="fit the slope of the unloading and the exponent, too")
    tips.add_argument("--pyramid", dest="tip", action="store_const", const=PYRAMID,
                      help="with the pyramid itself, fit the slope of the unloading, too")
    parser.add_argument("--slope-fit", type=number(above=0, most=1), nargs=2, metavar=("LOW", "HIGH"), default=(),
                        help="shares of the largest force between which unloadings are fitted (default: initial slopes)")
    parser.add_argument("--coarse", action="store_true", help="on a coarse mesh only")
    parser.add_argument("--at-once", type=number(int, least=1), default=2, help="runs at a time (default: %(default)s)")
    parser.add_argument("--output-directory", type=pathlib.Path, default="output/published_metals",
                        help="default: %(default)s")
    add_program(parser)
    chosen = parser.parse_args(arguments)
    program, folder = find_program(chosen.program), chosen.output_directory
    tip = dataclasses.replace(chosen.tip, slope_fit=tuple(chosen.slope_fit))
    computed_of = from_tension(folder / f"tension{tip.name}", program, tip, chosen.coarse, chosen.at_once)
    for (name, metal), computed in zip(METALS.items(), computed_of):
        for quantity, (mean, deviation) in metal.quantities().items():
            print(f"{name}, {quantity}: measured {mean:g} +- {deviation:g}, from the tension test "
                  f"{computed[quantity]:.4g} ({100. * (computed[quantity] / mean - 1.):+.1f} %)")
        for quantity, value in published_functions(metal).items():
            print(f"{name}, {quantity}: by the published functions {value:.4g} "
                  f"({100. * (value / metal.quantities()[quantity][0] - 1.):+.1f} %)")
    for name, metal in METALS.items():
        _, modulus, stress = fitted(name, folder, program, tip, chosen.coarse, chosen.at_once)
        print(f"{name}, fit: E* {modulus:.1f} GPa ({100. * (modulus / metal.tensile[0] - 1.):+.1f} % of the tension "
              f"test), stress at {STRAIN:g}: {stress:.0f} MPa ({100. * (stress / metal.tensile[2] - 1.):+.1f} %)")
    return 0
