# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ratchetting of a bar with one back stress that recovers (Armstrong and Frederick), for verify."""

import math

from .indentation import at_time

CASE = "material/ratchetting.prm"
LARGEST, SMALLEST, YIELD_STRESS = 320, -240, 200  # the stresses between which the case cycles
MODULUS, RATE = 40000, 300
EXACT_DRIFT = math.log(((MODULUS / RATE) ** 2 - (SMALLEST + YIELD_STRESS) ** 2)
                       / ((MODULUS / RATE) ** 2 - (LARGEST - YIELD_STRESS) ** 2)) / RATE
"""The strain by which the bar grows in each cycle: X' = C eps_p' - gamma X |eps_p'| integrated from the back stress
SMALLEST + YIELD_STRESS, where the flow in compression ends, to LARGEST - YIELD_STRESS, and back."""


def drift(runner, steps_per_cycle):
    """The growth of the strain from the first to the second maximum of the stress, over the exact one."""
    probes = runner.tables(CASE, f"Material/Back stress moduli={MODULUS}", f"Material/Recovery rates={RATE}",
                           "Loading/Final time=3", f"Loading/Number of steps={3 * steps_per_cycle // 2}")["probes"]
    first, second = (at_time(probes, time)["top_displacement_z"] for time in (1, 3))
    return (second - first) / EXACT_DRIFT


def ratchetting_drift(runner):
    """The strain by which a bar ratchets in a cycle: first order in the size of the steps (closed form)."""
    errors = [drift(runner, n) - 1 for n in (160, 320, 640)]
    runner.compare("order, 160 to 320 steps a cycle", math.log2(errors[0] / errors[1]), 1, 0.1)
    runner.compare("order, 320 to 640 steps a cycle", math.log2(errors[1] / errors[2]), 1, 0.05)
    runner.compare("drift, extrapolated from the last two", 2 * errors[2] - errors[1], 0, 2e-3, absolute=True)
