# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of the page on fits: the ready problems, and published measurements; see command."""

import functools
import pathlib
import tempfile

from elasto_plastic_contact.program import ROOT
from .recipe import Content, measured_table, signed_percent

PROBLEMS = ("sphere", "cone_and_sphere")


@measured_table(1200)
def fits(runs):
    """The ready problems of a sphere, and of cone and sphere: values, errors and regions, and the number of runs."""
    from elasto_plastic_contact.fitting.command import fit  # (which needs SciPy)
    with tempfile.TemporaryDirectory() as folder:
        return content_of({name: fit(ROOT / f"parameter_files/fit/{name}.json", pathlib.Path(folder) / name,
                                     program=runs.program,
                                     report=functools.partial(print, flush=True)) for name in PROBLEMS})


def rows_of_parameters(fit, truth):
    """Parameter, what is true, what is found, standard error, region."""
    rows = []
    for parameter, value in fit.values.items():
        region = fit.regions[parameter]
        ends = [f"{mark * (not closed)}{end:.3g}" for end, closed, mark in
                ((region.lower, region.closed[0], "< "), (region.upper, region.closed[1], "> "))]
        rows.append([None, f"{truth[parameter]:g}", f"{value:.4g}", f"{fit.standard_errors[parameter]:.2g}",
                     " to ".join(ends)])
    return rows


def content_of(found):
    """found: the Fit of each problem."""
    from ..inputs.fit_data import EXPONENT, YIELD_STRESS, YOUNG  # (which needs NumPy)
    truth = {"sigma_Y": YIELD_STRESS, "n": EXPONENT, "E": YOUNG}
    rows, numbers = [], {}
    for name, fit in found.items():
        rows += [[None, *row] for row in rows_of_parameters(fit, truth)]
        best, strain = fit.representative, fit.representative.plastic_strain
        true_stress = YIELD_STRESS * (1. + YOUNG * strain / YIELD_STRESS) ** EXPONENT
        rows.append([None, f"stress at the plastic strain {strain:.2g}", f"{true_stress:.4g}", f"{best.stress:.4g}", "",
                     f"{best.lower:.4g} to {best.upper:.4g}"])
        numbers[f"{name}_runs"] = f"{fit.n_runs}"
    return Content(rows, numbers)


@measured_table(60)
def fit_of_hold(runs):
    """The ready problem of a hold: values, errors and regions, and the number of runs."""
    from elasto_plastic_contact.fitting.command import fit  # (which needs SciPy)
    from ..inputs.fit_data import CREEP
    with tempfile.TemporaryDirectory() as folder:
        found = fit(ROOT / "parameter_files/fit/creep.json", folder, program=runs.program,
                    report=functools.partial(print, flush=True))
    return Content(rows_of_parameters(found, CREEP), {"runs": f"{found.n_runs}"})


@measured_table(600)
def curve_and_imprint_fit(runs):
    """The fits of one of two materials with equal curves: to the curve alone, and to curve and imprint."""
    from ..verification.curve_and_imprint_fit import fits_of  # (which needs SciPy)
    with tempfile.TemporaryDirectory() as folder:
        found = fits_of(pathlib.Path(folder), runs.program, 2, functools.partial(print, flush=True))
    return content_of_pair(found)


def content_of_pair(found):
    """found: the Fit of the curve alone, and of both."""
    from ..verification.curve_and_imprint import PAIR
    from ..verification.curve_and_imprint_fit import FITS, region_in_words
    rows = []
    for parameter, true in zip(found[FITS[0]].values, PAIR[0]):
        cells = [f"{found[name].values[parameter]:.4g}, {region_in_words(found[name].regions[parameter])}" for name in FITS]
        rows.append([None, f"{true:g}", *cells])
    return Content(rows, {"runs": f"{sum(fit.n_runs for fit in found.values())}"})


@measured_table(400)
def published_metals(runs):
    """Two aluminium alloys: what their tension tests give, and the fits, against what was measured."""
    from ..verification.published_metals import CONE  # (which needs SciPy)
    return metals_under(CONE, runs, coarse=False)


@measured_table(1200)
def published_metals_pyramid(runs):
    """The same with the pyramid itself, on a coarse mesh."""
    from ..verification.published_metals import PYRAMID
    return metals_under(PYRAMID, runs, coarse=True)


def metals_under(tip, runs, coarse):
    from ..verification.published_metals import METALS, fitted, from_tension
    with tempfile.TemporaryDirectory() as folder:
        place = pathlib.Path(folder)
        computed = from_tension(place / "tension", runs.program, tip, coarse, 2)
        fits_of = [fitted(name, place, runs.program, tip, coarse, 2)[1:] for name in METALS]
    return content_of_metals(computed, fits_of)


def content_of_metals(computed, fits_of):
    """computed: of each metal, the quantities from its tension test; fits_of: E* and stress."""
    from ..verification.published_metals import METALS
    rows = []
    for metal, of_tension, (modulus, stress) in zip(METALS.values(), computed, fits_of):
        pairs = [(mean, of_tension[name]) for name, (mean, _) in metal.quantities().items()]
        pairs += [(metal.tensile[0], modulus), (metal.tensile[2], stress)]
        rows += [[None, None, f"{known:g}", f"{found:.4g}", signed_percent(found / known - 1.)] for known, found in pairs]
    return Content(rows)


@measured_table(600)
def two_cones(runs):
    """What others have computed of cones of two angles: the same here, and fits to it, on a coarse mesh."""
    from ..verification.two_cones import ROWS, compare_with_material, compare_with_published, fit_case, of_materials
    with tempfile.TemporaryDirectory() as folder:
        place = pathlib.Path(folder)
        compared = compare_with_published(of_materials(place / "rows", runs.program, True, 2))
        for case in ROWS:
            compared += compare_with_material(case, fit_case(case, place, runs.program, True, 2))
    return content_of_cones(compared)


@measured_table(100)
def two_cones_errors(runs):
    """What errors in these quantities do to a fit, and what their differences from what is computed here would."""
    from ..verification.two_cones import ROWS, errors_of_fit, expected_change, of_materials
    with tempfile.TemporaryDirectory() as folder:
        place, how = pathlib.Path(folder), (runs.program, True, 2)
        computed = of_materials(place / "rows", *how)
        errors = {case: errors_of_fit(case, place / "errors", *how) for case in ROWS}
    expected = [expected_change(case, of_case, computed) for case, of_case in errors.items()]
    return content_of_changes([*zip(*(of_case.values() for of_case in errors.values())), expected])


def content_of_cones(compared):
    """compared: case, what it is, value and known value. One row for each quantity, one column for each case."""
    columns = {}
    for case, what, value, known in compared:
        columns.setdefault(what, {})[case] = f"{value:.4g} of {known:.4g}, {signed_percent(value / known - 1.)}"
    return Content([[None, *cells.values()] for cells in columns.values()])


def content_of_changes(rows):
    """rows: changes as those of errors_of_fit(), one for each case."""
    return Content([[None, *(f"{100. * change[1]:+.1f} %, {change[2]:+.3f}" for change in row)] for row in rows])
