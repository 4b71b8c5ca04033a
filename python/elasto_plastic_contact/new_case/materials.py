# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Materials: a small library with the source of each number (library.json), and those of the user."""

import difflib
import functools
import json
import math
import pathlib
from dataclasses import dataclass, replace

from .hardening import Perfect, read_hardening
from .units import plain_number, quantity, text_of
from ..errors import UserError

FILE = pathlib.Path(__file__).with_name("library.json")


@dataclass(frozen=True)
class Material:
    """young_modulus and yield_stress in GPa; without a yield stress, the material is linear elastic. rate_coefficient:
    C of the rate term of the plastic source, in which all stresses go with 1 + C ln(strain rate in 1/s); None: it has
    none. elastic_source, plastic_source: where the numbers are from; remark: what else is known of it, such as its
    hardness."""
    name: str
    description: str
    young_modulus: float
    poisson_ratio: float
    yield_stress: float | None = None
    hardening: object = Perfect()
    rate_coefficient: float | None = None
    elastic_source: str = "given"
    plastic_source: str = "given"
    remark: str = ""

    @property
    def plane_strain_modulus(self):
        """E / (1 - nu^2): the modulus that a rigid indenter meets."""
        return self.young_modulus / (1. - self.poisson_ratio ** 2)

    @property
    def is_elastic(self):
        return self.yield_stress is None

    def stress(self, strain):
        """The yield stress after a plastic strain, in GPa."""
        return self.yield_stress + self.hardening.added(strain, self.yield_stress, self.young_modulus)

    def entries(self, units):
        """Those of the section Material."""
        plastic = {"Law": "linear elastic"}
        if not self.is_elastic:
            plastic = self.hardening.entries(self, units)
            plastic["Yield stress"] = text_of(units.stress(self.yield_stress))
        return {"Young's modulus": text_of(units.stress(self.young_modulus)),
                "Poisson's ratio": text_of(self.poisson_ratio), **plastic}


@functools.cache
def library():
    """All materials by their names."""
    return {name: Material(name, record["description"], quantity(record["Young's modulus"], "stress", "210 GPa", name),
                           record["Poisson's ratio"],
                           quantity(record["yield stress"], "stress", "1 GPa", name) if "yield stress" in record
                           else None,
                           read_hardening(record.get("hardening", "none")), record.get("rate coefficient"),
                           record["elastic source"], record.get("plastic source", ""), record.get("remark", ""))
            for name, record in json.loads(FILE.read_text(encoding="utf-8"))["materials"].items()}


def of_library(name):
    """In small or large letters. Raises UserError: there is no such material, and which there are."""
    aliases = json.loads(FILE.read_text(encoding="utf-8"))["other names"]
    small = name.lower()
    found = library().get(aliases.get(small, small))
    if found is None:
        close = difflib.get_close_matches(small, [*library(), *aliases], n=1)
        hint = f" Did you mean '{close[0]}'?" if close else ""
        raise UserError(f"there is no material '{name}' in the library.{hint} 'epc new --list-materials' lists those "
                        "that there are; another one takes --young-modulus and --yield-stress")
    return found


def at_strain_rate(material, text):
    """With the stress-strain curve at another strain rate, in 1/s, by the rate term of its source. Raises UserError."""
    rate = plain_number(text, "--strain-rate", above=1e-6, below=1e6)
    if material.rate_coefficient is None:
        known = ", ".join(name for name, other in library().items() if other.rate_coefficient is not None)
        raise UserError(f"--strain-rate takes a curve of the library whose source says how it depends on the rate: of "
                        f"{known}. Leave it out, or --yield-stress and --hardening")
    factor = 1. + material.rate_coefficient * math.log(rate)
    return replace(material, yield_stress=factor * material.yield_stress, hardening=material.hardening.times(factor),
                   plastic_source=f"{material.plastic_source}; brought to {text_of(rate)}/s by its rate term, "
                                  f"1 + {text_of(material.rate_coefficient)} ln(rate) = {factor:.3f}")


def chosen_material(name, young_modulus, poisson_ratio, yield_stress, hardening, strain_rate=None):
    """A material of the library, or one of numbers; of both, the numbers count. The arguments are texts or None.
    Raises UserError."""
    material = of_library(name) if name else Material(
        "your material", "numbers given", quantity(young_modulus, "stress", "210 GPa", "--young-modulus"), 0.3)
    changes = {}
    if young_modulus:
        changes["young_modulus"] = quantity(young_modulus, "stress", "210 GPa", "--young-modulus")
    if poisson_ratio:
        changes["poisson_ratio"] = plain_number(poisson_ratio, "--poisson-ratio", above=-1., below=0.5)
    if yield_stress:
        changes["yield_stress"] = quantity(yield_stress, "stress", "400 MPa", "--yield-stress")
        # (A law belongs to its yield stress.)
        changes["hardening"] = Perfect()
    if hardening:
        if not yield_stress and material.is_elastic:
            raise UserError("--hardening says how a yield stress grows, and there is none: give --yield-stress")
        changes["hardening"] = read_hardening(hardening)
    if name and changes.keys() & {"young_modulus", "poisson_ratio"}:
        changes["elastic_source"] = "given"
    if changes.keys() & {"yield_stress", "hardening"}:
        changes |= {"plastic_source": "given", "remark": "", "rate_coefficient": None}
    material = replace(material, **changes)
    return at_strain_rate(material, strain_rate) if strain_rate else material


def print_library():
    for material in library().values():
        plastic = ("elastic constants only: give --yield-stress" if material.is_elastic else
                   f"yields at {text_of(1e3 * material.yield_stress)} MPa, hardening: {material.hardening}")
        print(f"{material.name}: {material.description}\n"
              f"    E = {text_of(material.young_modulus)} GPa, nu = {material.poisson_ratio} "
              f"({material.elastic_source})\n"
              f"    {plastic}" + (f" ({material.plastic_source})" if material.plastic_source else ""))
        if material.rate_coefficient is not None:
            print(f"    stresses go with 1 + {text_of(material.rate_coefficient)} ln(strain rate in 1/s) "
                  "(--strain-rate)")
        if material.remark:
            print(f"    {material.remark}")
