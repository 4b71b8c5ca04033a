# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Heights of a self-affine rough surface."""

import math
import random


def rough_surface(n, hurst, longest, shortest, seed):
    """n x n heights; waves of wave numbers longest..shortest per side."""
    generator = random.Random(seed)
    waves = []
    for kx in range(-shortest, shortest + 1):
        for ky in range(0, shortest + 1):
            k = math.hypot(kx, ky)
            if longest <= k <= shortest and (ky > 0 or kx > 0):
                amplitude = k ** -(hurst + 1) * generator.gauss(0, 1)
                waves.append((kx, ky, amplitude, generator.uniform(0, 2 * math.pi)))
    angle = 2 * math.pi / (n - 1)
    return [
        [
            sum(a * math.cos(angle * (kx * i + ky * j) + phase) for kx, ky, a, phase in waves)
            for i in range(n)
        ]
        for j in range(n)
    ]
