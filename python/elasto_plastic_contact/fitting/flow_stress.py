# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Uniaxial stress-strain curves of the materials of a parameter file (doc/theory, "The material")."""

import numpy

from ..errors import UserError


def flow_stress(entries, plastic_strain, material=0):
    """The stress of a specimen that is pulled monotonically, at these plastic strains (logarithmic, >= 0).

    entries: 'Section/Entry' to text, as Results.parameters; material: the number of the value in each list.
    """
    def text(name, default):
        values = str(entries.get(f"Material/{name}", default)).split(",")
        return values[material if len(values) > 1 else 0].strip()

    def number(name, default):
        return float(text(name, default))

    strain = numpy.asarray(plastic_strain, float)
    law, yield_stress = text("Law", "isotropic hardening"), number("Yield stress", 400)
    stress = numpy.full_like(strain, yield_stress)
    if law == "linear elastic":
        raise UserError("a linear elastic material has no yield stress, and so no stress-strain curve to draw")
    if law in ("isotropic hardening", "combined hardening", "nonlinear hardening"):
        stress += number("Isotropic hardening modulus", 2000) * strain
    if law in ("kinematic hardening", "combined hardening"):
        stress += number("Kinematic hardening modulus", 0) * strain
    if law == "nonlinear hardening":
        stress += number("Voce stress", 0) * -numpy.expm1(-number("Voce rate", 0) * strain)
        stress += yield_stress * ((1. + strain / number("Power law reference strain", 0.01))
                                  ** number("Power law exponent", 0) - 1.)
        stress += table(text("Hardening table", "none"), yield_stress, strain)
        stress += back_stresses(text("Back stress moduli", "none"), text("Recovery rates", "none"), strain)
    return stress


def pairs(text, separator):
    return [] if text == "none" else [part.split(separator) for part in text.split("|")]


def table(text, yield_stress, strain):
    """What a hardening table adds: linear between its points, constant beyond the last one."""
    points = [(float(a), float(b)) for a, b in pairs(text, ":")]
    if not points:
        return 0.
    if points[0][0] > 0.:
        points.insert(0, (0., yield_stress))
    return numpy.interp(strain, *zip(*points)) - yield_stress


def back_stresses(moduli, rates, strain):
    """The sum of the back stresses X' = C - gamma X."""
    total = numpy.zeros_like(strain)
    for (modulus,), (rate,) in zip(pairs(moduli, ":"), pairs(rates, ":")):
        c, gamma = float(modulus), float(rate)
        total += c * strain if gamma == 0. else c / gamma * -numpy.expm1(-gamma * strain)
    return total


def total_strain(entries, stress, plastic_strain, material=0):
    """Elastic and plastic strain together."""
    values = str(entries.get("Material/Young's modulus", 200000)).split(",")
    return stress / float(values[material if len(values) > 1 else 0]) + plastic_strain
