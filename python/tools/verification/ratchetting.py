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
    """The strain by which a bar ratchets in a cycle (closed form), whatever the size of the steps."""
    for steps_per_cycle in (8, 40):
        runner.compare(f"drift, steps in a cycle: {steps_per_cycle}", drift(runner, steps_per_cycle), 1, 1e-6)
