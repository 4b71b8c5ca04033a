# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hardening laws: stress over plastic strain, and the entries that say so in a parameter file.

Stresses are in GPa, strains are equivalent plastic ones."""

import math
from dataclasses import dataclass

from .units import plain_number, quantity, text_of
from ..errors import UserError

# Where Ludwik's law is tabulated, as its slope is infinite at first: linear in between, the stress of the library's
# materials is within 0.5 % of it, and within 2 % below the first strain.
TABULATED = (1e-6, 3e-6, 1e-5, 2e-5, 5e-5, 1e-4, 0.0002, 0.0005, 0.001, 0.002, 0.004, 0.007, 0.012, 0.02, 0.03,
             0.045, 0.065, 0.09, 0.12, 0.16, 0.21, 0.28, 0.37, 0.5, 0.65, 0.85, 1.1, 1.5, 2.)


@dataclass(frozen=True)
class Perfect:
    """No hardening."""

    def added(self, strain, yield_stress, young_modulus):
        return 0.

    def entries(self, material, units):
        return {"Law": "perfectly plastic"}

    def __str__(self):
        return "none"


@dataclass(frozen=True)
class Linear:
    """H times the plastic strain."""
    modulus: float

    def added(self, strain, yield_stress, young_modulus):
        return self.modulus * strain

    def entries(self, material, units):
        return {"Law": "isotropic hardening", "Isotropic hardening modulus": text_of(units.stress(self.modulus))}

    def __str__(self):
        return f"linear, H = {text_of(1e3 * self.modulus)} MPa"


@dataclass(frozen=True)
class PowerLaw:
    """Yield stress times (1 + E strain / yield stress)^n, which continues Hooke's line (Dao et al. 2001)."""
    exponent: float

    def added(self, strain, yield_stress, young_modulus):
        return yield_stress * ((1. + young_modulus * strain / yield_stress) ** self.exponent - 1.)

    def entries(self, material, units):
        return {"Law": "nonlinear hardening", "Isotropic hardening modulus": "0",
                "Power law exponent": text_of(self.exponent),
                "Power law reference strain": text_of(material.yield_stress / material.young_modulus)}

    def __str__(self):
        return f"power law, n = {text_of(self.exponent)}"


@dataclass(frozen=True)
class Ludwik:
    """B times the plastic strain to the power of n."""
    factor: float
    exponent: float

    def times(self, factor):
        """With other stresses."""
        return Ludwik(factor * self.factor, self.exponent)

    def added(self, strain, yield_stress, young_modulus):
        return self.factor * strain ** self.exponent

    def entries(self, material, units):
        table = " | ".join(f"{text_of(strain)}: {units.stress(material.stress(strain)):.5g}" for strain in TABULATED)
        return {"Law": "nonlinear hardening", "Isotropic hardening modulus": "0", "Hardening table": table}

    def __str__(self):
        return (f"Ludwik, {text_of(1e3 * self.factor)} MPa times the plastic strain to the power of "
                f"{text_of(self.exponent)}")


@dataclass(frozen=True)
class Voce:
    """Q (1 - exp(-b strain))."""
    stress: float
    rate: float

    def added(self, strain, yield_stress, young_modulus):
        return self.stress * (1. - math.exp(-self.rate * strain))

    def entries(self, material, units):
        return {"Law": "nonlinear hardening", "Isotropic hardening modulus": "0",
                "Voce stress": text_of(units.stress(self.stress)), "Voce rate": text_of(self.rate)}

    def __str__(self):
        return f"Voce, {text_of(1e3 * self.stress)} MPa at the rate {text_of(self.rate)}"


FORMS = "'none', 'linear 2 GPa', 'power 0.1', 'Ludwik 510 MPa, 0.26' or 'Voce 250 MPa, 15'"


def read_hardening(text):
    """The law of a text such as 'power 0.1'. Raises UserError."""
    name, _, rest = text.strip().partition(" ")
    parts = [part.strip() for part in rest.split(",")]
    where = "--hardening"
    if name == "none" and not rest:
        return Perfect()
    if name == "linear" and len(parts) == 1:
        return Linear(quantity(parts[0], "stress", "2 GPa", where, least=0.))
    if name == "power" and len(parts) == 1:
        return PowerLaw(plain_number(parts[0], where, above=0., below=1.))
    if name == "Ludwik" and len(parts) == 2:
        return Ludwik(quantity(parts[0], "stress", "510 MPa", where),
                      plain_number(parts[1], where, above=0., below=1.))
    if name == "Voce" and len(parts) == 2:
        return Voce(quantity(parts[0], "stress", "250 MPa", where), plain_number(parts[1], where, above=0., below=1e6))
    raise UserError(f"--hardening is '{text}', but must be {FORMS}")
