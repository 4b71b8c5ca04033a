# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Table of the files that 'epc new' writes; see command."""

from ..verification.new_cases import (ALUMINIUM, BALL, HERTZ, brinell_hardness, hertz_ratios, loading_curvature,
                                      tables_of)
from .recipe import Content, signed_percent, table


def bounds(tables):
    """By how much the upper bound is above the lower one."""
    row = tables["limit_load"][-1]
    return signed_percent(row["upper_bound"] / row["lower_bound"] - 1., 2)


# Kind, options, and what its tables say.
RUNS = (("sphere", HERTZ, lambda tables: signed_percent(hertz_ratios(tables)[0] - 1.)),
        ("brinell", BALL, lambda tables: f"{brinell_hardness(tables, 10.):.1f}"),
        ("cone", ALUMINIUM, lambda tables: f"{loading_curvature(tables):.2f}"),
        ("limit-load", {"material": "steel", "half_width": "1 mm"}, bounds))


@table(140)
def new_cases(runs):
    """Sphere, Brinell, cone and limit load as 'epc new' writes them, coarse and usual."""
    return Content([[None, *(show(tables_of(runs, kind, mesh, texts)) for mesh in ("coarse", "usual")), None]
                    for kind, texts, show in RUNS])
