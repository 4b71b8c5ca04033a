# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all readers make of a file: the curve of one indent, and what the instrument says of it."""

from dataclasses import dataclass, field, replace

import numpy

from ..errors import UserError
from .units import KINDS, OWN_UNITS, factor

# What units usually are, for messages.
EXAMPLES = {"depth": "nm", "force": "mN", "time": "s", "stiffness": "N/m"}


@dataclass(frozen=True)
class Notes:
    """What the instrument says of an indent, in the units of units.py; None of what it does not say."""
    area_function: tuple = None  # coefficients C0, C1, ... of h^2, h, h^(1/2), ...
    usable_depth: float = None  # up to which the area function holds
    frame_compliance: float = None
    drift_rate: float = None
    hardness: float = None  # as the instrument evaluates it
    plane_strain_modulus: float = None
    others: dict = field(default_factory=dict)  # words of the file


@dataclass(frozen=True)
class MeasuredCurve:
    """Arrays of the same length, in the order of time; time and stiffness (continuous contact stiffness) may be None.
    units: of each quantity, in words, empty if the file does not say it; units_of_file: those before in_own_units().
    columns: what the file calls them.
    remarks: what has been assumed or left out in reading, in sentences."""
    name: str
    depth: numpy.ndarray
    force: numpy.ndarray
    time: numpy.ndarray = None
    stiffness: numpy.ndarray = None
    units: dict = field(default_factory=dict)
    units_of_file: dict = field(default_factory=dict)
    columns: dict = field(default_factory=dict)
    notes: Notes = Notes()
    remarks: tuple = ()

    def quantities(self):
        """The names of the arrays that are there."""
        return [quantity for quantity in KINDS if getattr(self, quantity) is not None]

    def named(self):
        """Without blanks around its name."""
        return replace(self, name=self.name.strip())

    def with_remark(self, remark):
        return self.with_remarks([remark])

    def with_remarks(self, remarks):
        return replace(self, remarks=(*self.remarks, *remarks))


def numbered(indents):
    """The curves of all indents, named by their numbers, with a remark on indents without rows. indents: the line behind
    which each begins, and its curves."""
    curves = [replace(curve, name=str(number))
              for number, curve in enumerate((curve for _, found in indents for curve in found), 1)]
    empty = [start for start, found in indents if not found]
    if not empty:
        return curves
    lines = ", ".join(str(start + 1) for start in empty[:5]) + (", ..." if len(empty) > 5 else "")
    return [curve.with_remark(f"indents that hold no rows of numbers, and are left out: {len(empty)}, of line {lines}")
            for curve in curves]


def in_own_units(curve, path, given):
    """The curve in µm, mN and s. given: units by quantity, which the file may contradict. Raises UserError."""
    units = {}
    for quantity in curve.quantities():
        stands, chosen = curve.units.get(quantity, ""), given.get(quantity, "")
        if stands and chosen and stands != chosen:
            raise UserError(f"'{path}' says that its unit of {quantity} is {stands} (column "
                            f"'{curve.columns.get(quantity)}'), and --unit {quantity}={chosen} says otherwise: leave "
                            "that out, or choose another column by --columns")
        units[quantity] = stands or chosen
    unknown = [quantity for quantity, unit in units.items() if not unit]
    if unknown == ["time"]:  # (it matters for rates only)
        return replace(in_own_units(replace(curve, time=None), path, given),
                       remarks=(*curve.remarks, "the unit of time is not known, so that there are no rates: --unit "
                                                "time=s"))
    if unknown:
        columns = " nor ".join(f"of {quantity} (column '{curve.columns.get(quantity, '?')}')" for quantity in unknown)
        example = " ".join(f"--unit {quantity}={EXAMPLES[quantity]}" for quantity in unknown)
        raise UserError(f"'{path}' does not say the unit {columns}: give it, such as by {example}")
    scaled = {quantity: getattr(curve, quantity) * factor(KINDS[quantity], unit) for quantity, unit in units.items()}
    return replace(curve, **scaled, units={quantity: OWN_UNITS[quantity] for quantity in scaled}, units_of_file=units)
