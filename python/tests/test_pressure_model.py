# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The model of the pressures' Schur complement (doc/theory, "Nearly incompressible bodies") on endless lattices of
bilinear squares or trilinear cubes with edges of 1: the Fourier symbols of F and of R P R^T, at all wave lengths. Only
the two constants are the program's: what it makes of them, tests/mixed_form checks."""

import itertools
import math
import pathlib
import re
import unittest

SOURCE = pathlib.Path(__file__).resolve().parents[2] / "source" / "mechanics" / "pressure_model.cc"


def constant(name):
    """A constant of the program, such as 1. / 3."""
    numerator, _, denominator = re.search(rf"double {name} = ([0-9. /]+);", SOURCE.read_text()).group(1).partition("/")
    return float(numerator) / float(denominator or 1)


def quotients(dim, n_waves):
    """R P R^T over F, with the shear modulus 1 and an excess of the bulk modulus of 1. The waves avoid those at which
    both are zero."""
    waves = [2 * math.pi * (i + 0.37) / n_waves for i in range(n_waves)]
    for wave in itertools.product(waves, repeat=dim):
        sines, cosines = [math.sin(k / 2) ** 2 for k in wave], [math.cos(k / 2) ** 2 for k in wave]
        masses = [1 - 2 / 3 * s for s in sines]
        along = [(sines[d], cosines[:d] + cosines[d + 1:], masses[:d] + masses[d + 1:]) for d in range(dim)]
        divergence = sum(4 * s * math.prod(others) for s, others, _ in along)
        laplacian = sum(4 * s * math.prod(others) for s, _, others in along)
        beta_square = divergence / laplacian
        # A_G has 2 G dev(strain), whose longitudinal waves have the modulus 4/3 G
        exact = beta_square / (1 + beta_square / 3)

        entry = 0.5 ** (dim - 1)  # of D; R is odd in it, and even in the constant
        row = divergence + dim * (2 ** dim * constant("drag") * entry) ** 2 * math.prod(cosines)
        stiffness = 2 ** dim * constant("spring") * 2 ** (dim - 1) * entry ** 2
        yield row / stiffness / exact


class PressureModelTest(unittest.TestCase):
    """The factors that the theory and the source promise."""

    def test_is_the_schur_complement_up_to_a_factor(self):
        for dim, n_waves in ((2, 40), (3, 16)):
            with self.subTest(dim=dim):
                found = list(quotients(dim, n_waves))
                self.assertGreater(min(found), 0.4)
                self.assertLess(max(found), 2.1)


if __name__ == "__main__":
    unittest.main()
