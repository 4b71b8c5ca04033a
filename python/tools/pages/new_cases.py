# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Table of the files that 'epc new' writes; see command."""

from ..verification.new_cases import (ALUMINIUM, BALL, HERTZ, SCALE, brinell_hardness, hardness_numbers, hertz_ratios,
                                      loading_curvature, rockwell_hardness, tables_of)
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


# Strain rates of the stress-strain curve, in 1/s.
RATES = ("1", "0.01", "0.001")


@table(60)
def new_rockwell(runs):
    """Rockwell hardness of a steel as 'epc new' writes it, coarse, with its curve at several strain rates."""
    found = [tables_of(runs, "rockwell-ball", "coarse", SCALE | {"strain_rate": rate}) for rate in RATES]
    return Content([[None, f"{rockwell_hardness(tables):.1f}"] for tables in found])


@table(150)
def new_pyramids(runs):
    """Hardness numbers of Vickers' and Berkovich's pyramid in a steel as 'epc new' writes them, coarse."""
    numbers = [hardness_numbers(kind, "coarse", runs.program) for kind in ("vickers", "berkovich")]
    return Content([[None, *(f"{found[name]:.0f}" if name in found else "" for found in numbers), None]
                    for name in ("HV_of_area", "HV", "HM")])


@table(140)
def new_cases(runs):
    """Sphere, Brinell, cone and limit load as 'epc new' writes them, coarse and usual."""
    return Content([[None, *(show(tables_of(runs, kind, mesh, texts)) for mesh in ("coarse", "usual")), None]
                    for kind, texts, show in RUNS])
