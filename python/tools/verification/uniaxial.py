# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Uniaxial stress with nonlinear hardening, for verify: where the flow of each step ends is one scalar equation,
solved by bisection."""

import bisect
import math


class Law:
    """sigma_Y(alpha), its integral, and back stresses; by the names of the entries in 'Material'."""

    def __init__(self, young, yield_stress, isotropic=0.0, voce=(0.0, 1.0), power=(0.0, 1.0),
                 table=(), back=()):
        self.young = young
        self.yield_stress = yield_stress
        self.isotropic = isotropic
        self.voce = voce
        self.power = power
        self.table = [(0.0, yield_stress), *table]
        self.back = list(back)

    def entries(self):
        """The same for the program."""
        def joined(numbers):
            return " | ".join(map(str, numbers)) or "none"
        return [
            "Material/Law=nonlinear hardening",
            f"Material/Yield stress={self.yield_stress}",
            f"Material/Isotropic hardening modulus={self.isotropic}",
            f"Material/Voce stress={self.voce[0]}", f"Material/Voce rate={self.voce[1]}",
            f"Material/Power law exponent={self.power[0]}",
            f"Material/Power law reference strain={self.power[1]}",
            "Material/Hardening table=" + (" | ".join(f"{a}: {s}" for a, s in self.table[1:]) or "none"),
            f"Material/Back stress moduli={joined(c for c, _ in self.back)}",
            f"Material/Recovery rates={joined(rate for _, rate in self.back)}",
        ]

    def sigma(self, alpha):
        """The yield stress."""
        voce, rate = self.voce
        exponent, reference = self.power
        return (self.isotropic * alpha + voce * (1 - math.exp(-rate * alpha))
                + self.yield_stress * ((1 + alpha / reference) ** exponent - 1)
                + self.table_at(alpha)[0])

    def table_at(self, alpha):
        """The table's stress and its integral beyond the yield stress."""
        area = 0.0
        for (a, s), (b, t) in zip(self.table, self.table[1:]):
            end = min(alpha, b)
            if end > a:
                stress = s + (t - s) * (end - a) / (b - a)
                area += (0.5 * (s + stress) - self.yield_stress) * (end - a)
        last = self.table[-1]
        if alpha >= last[0]:
            return last[1], area + (last[1] - self.yield_stress) * (alpha - last[0])
        i = bisect.bisect_right([a for a, _ in self.table], alpha) - 1
        (a, s), (b, t) = self.table[i], self.table[i + 1]
        return s + (t - s) * (alpha - a) / (b - a), area

    def stored(self, alpha):
        """int_0^alpha (sigma_Y - sigma_0)."""
        voce, rate = self.voce
        exponent, reference = self.power
        power = (reference / (exponent + 1) * ((1 + alpha / reference) ** (exponent + 1) - 1) - alpha)
        return (0.5 * self.isotropic * alpha**2 + voce * (alpha + (math.exp(-rate * alpha) - 1) / rate)
                + self.yield_stress * power + self.table_at(alpha)[1])


def steps(law, strains):
    """Stress, plastic work so far and what hardening stores, at the end of each step."""
    plastic = alpha = work = 0.0
    back = [0.0] * len(law.back)
    for strain in strains:
        sign = math.copysign(1.0, law.young * (strain - plastic) - sum(back))

        def new_back(length):
            return [x * math.exp(-rate * length) + sign * c * (-math.expm1(-rate * length) / rate if rate else length)
                    for x, (c, rate) in zip(back, law.back)]

        def excess(length):
            stress = law.young * (strain - plastic - sign * length)
            return sign * (stress - sum(new_back(length))) - law.sigma(alpha + length)

        lower, upper = 0.0, max(0.0, excess(0.0)) / law.young
        for _ in range(200):
            middle = 0.5 * (lower + upper)
            lower, upper = (middle, upper) if excess(middle) > 0 else (lower, middle)
        back = new_back(upper)
        plastic += sign * upper
        alpha += upper
        stress = law.young * (strain - plastic)
        work += stress * sign * upper
        yield stress, work, law.stored(alpha) + sum(
            x**2 / (2 * c) for x, (c, _) in zip(back, law.back))
