# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of friction; see command."""

import math

from ..verification.friction import MINDLIN, MU, PUSHED, SSNV128
from .recipe import Content, table

PUNCH = "friction/bonded_punch.prm"
COEFFICIENT = "Contact/Friction coefficient={}"


@table(1)
def ssnv128(runs):
    """code_aster's SSNV128."""
    profile = runs.tables("friction/ssnv128.prm", "Geometry/Initial refinements=6")["surface_profile"]
    displacements = {row["x"]: 1e3 * row["displacement_x"] for row in profile}
    return Content([[None, *(f"{displacements[x]:.2f}" for x in SSNV128)], [None] * 6, [None] * 6])


@table(2)
def bonded_punch(runs):
    """A flat circular punch that is bonded to the body, and with friction."""
    bonded, smooth = (runs.run(PUNCH, COEFFICIENT.format(coefficient))[-1]["force"] for coefficient in ("stick", "0"))
    radii = {}
    for coefficient in (5, 10, 20):
        last = runs.history(PUNCH, COEFFICIENT.format(coefficient / 100), "Loading/Number of steps=5")[-1]
        radii[f"stick_{coefficient}"] = f"{math.sqrt(last['stick_area'] / last['contact_area']):.3g}"
    nu = 0.3
    exact = (1 - nu) * math.log(3 - 4 * nu) / (1 - 2 * nu)
    return Content(numbers={"more": f"{100 * (bonded / smooth - 1):.2f}", "exact": f"{100 * (exact - 1):.2f}", **radii})


@table(55)
def mindlin_cylinder(runs):
    """A cylinder pushed to the side: the width that sticks against Cattaneo's and Mindlin's."""
    deviations, ratios = [], []
    for row in runs.history(MINDLIN, *PUSHED, "Loading/Number of steps=20"):
        if row["time"] > 1:
            ratios.append(row["tangential_force_x"] / (MU * row["force"]))
            deviations.append(row["stick_area"] / row["contact_area"] / math.sqrt(1 - ratios[-1]) - 1)
    return Content(numbers={"deviation": f"{100 * max(map(abs, deviations)):.1f}", "ratio": f"{max(ratios):.2f}"})
