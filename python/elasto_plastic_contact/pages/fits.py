# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of the page on fits: the ready problems; see command."""

import functools
import pathlib
import tempfile

from ..program import ROOT
from .recipe import Content, measured_table

PROBLEMS = ("sphere",)


@measured_table(300)
def fits(runs):
    """The ready problem of a sphere: values, errors and regions, and the number of runs."""
    from ..fitting.command import fit  # (which needs SciPy)
    with tempfile.TemporaryDirectory() as folder:
        return content_of({name: fit(ROOT / f"parameter_files/fit/{name}.json", pathlib.Path(folder) / name,
                                     program=runs.program,
                                     report=functools.partial(print, flush=True)) for name in PROBLEMS})


def content_of(found):
    """found: the Fit of each problem."""
    from ..inputs.fit_data import EXPONENT, YIELD_STRESS, YOUNG  # (which needs NumPy)
    truth = {"sigma_Y": YIELD_STRESS, "n": EXPONENT, "E": YOUNG}
    rows, numbers = [], {}
    for name, fit in found.items():
        for parameter, value in fit.values.items():
            region = fit.regions[parameter]
            ends = [f"{mark * (not closed)}{end:.3g}" for end, closed, mark in
                    ((region.lower, region.closed[0], "< "), (region.upper, region.closed[1], "> "))]
            rows.append([None, None, f"{truth[parameter]:g}", f"{value:.4g}", f"{fit.standard_errors[parameter]:.2g}",
                         " to ".join(ends)])
        best, strain = fit.representative, fit.representative.plastic_strain
        true_stress = YIELD_STRESS * (1. + YOUNG * strain / YIELD_STRESS) ** EXPONENT
        rows.append([None, f"stress at the plastic strain {strain:.2g}", f"{true_stress:.4g}", f"{best.stress:.4g}", "",
                     f"{best.lower:.4g} to {best.upper:.4g}"])
        numbers[f"{name}_runs"] = f"{fit.n_runs}"
    return Content(rows, numbers)
