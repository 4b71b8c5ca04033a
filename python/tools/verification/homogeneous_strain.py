# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Homogeneous finite deformations in closed form, for finite_strain: laws of small strains between the
logarithmic strain and the stress conjugate to it (doc/theory, "Finite strain")."""

import math


def bar(young, nu, yield_stress, hardening, stretch):
    """Uniaxial stress with linear isotropic hardening, loaded in one direction: nominal stress, true
    stress, and the stretch across."""
    strain = math.log(stretch)
    stress = young * abs(strain)
    if stress > yield_stress:
        stress = (yield_stress + hardening * abs(strain)) * young / (young + hardening)
    stress = math.copysign(stress, strain)
    elastic = stress / young
    across = math.exp(-nu * elastic - 0.5 * (strain - elastic))
    return stress / stretch, stress / (stretch * across**2), across


def simple_shear(shear_modulus, yield_stress, gammas):
    """True stresses (sigma_xx, sigma_xy) of a perfectly plastic body under F = 1 + gamma e_x e_y^T, step by
    step; sigma_yy = -sigma_xx."""
    radius = yield_stress / math.sqrt(3)
    plastic = 0j
    for gamma in gammas:
        strain = shear_strain(gamma)
        trial = 2 * shear_modulus * (strain - plastic)
        stress = trial / max(1., abs(trial) / radius)
        plastic = strain - stress / (2 * shear_modulus)
        true = true_stress(gamma, stress)
        yield true.real, true.imag


# A plane tensor without trace is the complex number a_xx + i a_xy. Turned by an angle, it is multiplied
# by exp(2 i angle).

def directions(gamma):
    """Those of the larger stretch before and after the shear: exp(2 i angle) of each."""
    length = math.hypot(2, gamma)
    return complex(-gamma, 2) / length, complex(gamma, 2) / length


def shear_strain(gamma):
    """ln(F^T F) / 2: the stretches are exp(asinh(gamma / 2)) and its inverse."""
    return math.asinh(0.5 * gamma) * directions(gamma)[0]


def true_stress(gamma, conjugate):
    """Of the stress that is conjugate to the logarithmic strain."""
    before, after = directions(gamma)
    logarithm = math.asinh(0.5 * gamma)
    principal = conjugate * before.conjugate()
    # 2 f[a, b] of the squares of the stretches, whose product is 1
    off_diagonal = 2 * logarithm / math.sinh(2 * logarithm)
    return complex(principal.real, off_diagonal * principal.imag) * after
