# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quantities with units, and the consistent units of a parameter file.

Within this package lengths are in µm, forces in mN and stresses in GPa, which are those of measured curves and
consistent (1 GPa µm² = 1 mN)."""

from dataclasses import dataclass

from ..errors import UserError
from ..measured.units import FACTORS, value_with_unit


@dataclass(frozen=True)
class UnitSystem:
    """Consistent units: that of force is that of stress times the square of that of length."""
    length_unit: str
    stress_unit: str
    force_unit: str

    def length(self, value):
        """A length in µm as the file has it."""
        return value / FACTORS["length"][self.length_unit]

    def stress(self, value):
        """A stress in GPa as the file has it."""
        return value / FACTORS["stress"][self.stress_unit]

    def force(self, value):
        """A force in mN as the file has it."""
        return value / FACTORS["force"][self.force_unit]

    def __str__(self):
        return f"{self.length_unit}, {self.force_unit}, {self.stress_unit}"


MILLIMETRES = UnitSystem("mm", "MPa", "N")
MICROMETRES = UnitSystem("µm", "GPa", "mN")
NANOMETRES = UnitSystem("nm", "GPa", "nN")


def units_for(length):
    """The units in which a length that matters (in µm), the largest depth mostly, is a number without many zeros."""
    if length >= 100.:
        return MILLIMETRES
    return MICROMETRES if length >= 0.05 else NANOMETRES


def text_of(value):
    """A number with six digits, which is more than any of them is known to, and no exponent as long as it can be
    read."""
    return f"{value:.6g}"


def quantity(text, kind, example, name, *, least=None, above=0.):
    """A number with a unit in the units of this package. kind: length, force or stress; example: for the message;
    name: the option, for the message; least, above: limits of the value. Raises UserError."""
    try:
        value = value_with_unit(text, kind, example.split()[-1])
    except ValueError:
        units = ", ".join(FACTORS[kind])
        raise UserError(f"{name} is '{text}', but must be a number with a unit, such as '{example}'. Units of {kind} "
                        "are "
                        f"{units}") from None
    if value < least if least is not None else not value > above:
        raise UserError(f"{name} is '{text}', but must be {'at least' if least is not None else 'above'} "
                        f"{text_of(least if least is not None else above)}")
    return value


def plain_number(text, name, *, above, below):
    """A number without a unit between two limits, both excluded. Raises UserError."""
    try:
        value = float(text)
    except ValueError:
        value = above
    if not above < value < below:
        raise UserError(f"{name} is '{text}', but must be a number above {text_of(above)} and below {text_of(below)}")
    return value
