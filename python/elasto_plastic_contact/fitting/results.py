# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a fit has found, as fit.csv, fit.json and sentences on the screen."""

import csv
import dataclasses
import json

from .statistics import UNKNOWN
from ..files import new_file

COLUMNS = ("parameter", "value", "standard_error", "lower", "upper")


def rows_of(fit):
    """One row for each parameter, as in fit.csv."""
    return [dict(zip(COLUMNS,
                     (name, value, fit.standard_errors[name], fit.regions[name].lower, fit.regions[name].upper)))
            for name, value in fit.values.items()]


def write_csv(fit, path):
    with new_file(path) as file:
        writer = csv.writer(file)
        writer.writerow(COLUMNS)
        writer.writerows([row["parameter"], *(f"{row[column]:.15g}" for column in COLUMNS[1:])] for row in rows_of(fit))


def as_json(fit):
    """All that is known, as a dictionary for JSON."""
    names = fit.problem.names
    parameters = {row["parameter"]: {key: row[key] for key in COLUMNS[1:]} | {
        "closed": dict(zip(("lower", "upper"), fit.regions[row["parameter"]].closed)),
        "remarks": [remark for remark in fit.regions[row["parameter"]].remarks if remark]} for row in rows_of(fit)}
    return {
        "parameters": parameters,
        "correlation": {"parameters": names, "matrix": fit.correlation.tolist()},
        "directions": [{"singular_value": value, "standard_error": error, "components": dict(zip(names, row.tolist()))}
                       for value, error, row in fit.directions],
        "flat_direction": flat_direction(fit),
        "verdict": fit.verdict,
        "representative_stress": dataclasses.asdict(fit.representative) if fit.representative else None,
        "candidates": [dataclasses.asdict(candidate) for candidate in fit.candidates],
        "quality": dataclasses.asdict(fit.quality) | {"noise_is_known": fit.problem.noise_is_known},
        "residuals": residuals_of(fit),
        "converged": fit.converged, "remarks": fit.remarks, "step": fit.step,
        "runs": fit.n_runs, "runs_made": fit.n_made, "processor_seconds": round(fit.processor_seconds,
                                                                                1), "seconds": round(fit.seconds, 1)}


def flat_direction(fit):
    """The direction that the data know least of, and the materials at both ends of the profile of its main
    parameter."""
    _, error, row = fit.directions[-1]
    materials = [fit.problem.values(end.x) for end in fit.ends[fit.flattest]]
    return {"parameter": fit.problem.names[fit.flattest], "components": dict(zip(fit.problem.names, row.tolist())),
            "standard_error": error, "equally_good": materials}


def residuals_of(fit):
    """Of each block its places, measured and computed values and residuals over their standard deviations."""
    found, first = [], 0
    for experiment, block in fit.problem.blocks():
        part = fit.residuals[first:first + len(block.y)]
        first += len(block.y)
        found.append({"experiment": experiment.name, "data": block.name, "kind": block.kind, "x": block.x.tolist(),
                      "measured": block.y.tolist(), "computed": (block.y + part * block.sigma).tolist(),
                      "residual": part.tolist()})
    return found


def write_json(fit, path):
    with new_file(path) as file:
        file.write(json.dumps(as_json(fit), indent=1) + "\n")


def table_of(fit):
    """Lines of the parameters with their errors."""
    lines = [f"{'parameter':16} {'value':>12} {'std. error':>12}   95 % region"]
    for row in rows_of(fit):
        region = fit.regions[row["parameter"]]
        ends = [f"{'' if closed else mark}{row[end]:.5g}" for end, closed, mark in
                zip(("lower", "upper"), region.closed, ("<", ">"))]
        lines.append(f"{row['parameter']:16} {row['value']:12.6g} {row['standard_error']:12.3g}   "
                     f"{ends[0]} to {ends[1]}")
    return lines


def combination(problem, row):
    """A direction in words: the product of powers whose logarithm it is."""
    parts = []
    for parameter, weight in sorted(zip(problem.parameters, row), key=lambda pair: -abs(pair[1])):
        if abs(weight) < 0.05:
            continue
        logarithm = f"ln({parameter.name})" if parameter.is_logarithmic else f"{parameter.name}/{parameter.size:g}"
        parts.append(f"{weight:+.2f} {logarithm}")
    return " ".join(parts).removeprefix("+")


def sentences(fit):
    """What the table does not say."""
    yield from fit.remarks
    quality = fit.quality
    yield (f"sum of squares {quality.chi_square:.5g}, {quality.freedom:g} degrees of freedom; the residuals are worth "
           f"{quality.independent:.0f} independent values")
    if quality.independent < 0.5 * len(fit.residuals) and fit.problem.noise_is_known and quality.scale == 1.:
        yield ("the residuals are not independent of each other, and the errors are those of independent ones: give "
               "\"independent points\", or leave out 'noise'")
    for name, region in fit.regions.items():
        for end, closed, remark in zip(("lower", "upper"), region.closed, region.remarks):
            if remark:
                yield (f"{name}: the {end} end of its region: {remark}"
                       + ("" if closed else ", so that the data give no end"))
    for _, error, row in fit.directions:
        known = f"known to +-{error:.3g} (standard error)" if error < UNKNOWN else "the data say nothing of"
        yield f"{known}: {combination(fit.problem, row)}"
    if len(fit.values) > 1:
        yield ", ".join(f"correlation of {fit.problem.names[i]} and {fit.problem.names[j]}: {fit.correlation[i, j]:.3f}"
                        for i in range(len(fit.x)) for j in range(i))
    yield from of_uniqueness(fit)


def of_uniqueness(fit):
    if fit.verdict != "unique":
        first, second = (", ".join(f"{name} = {value:.4g}" for name, value in material.items())
                         for material in flat_direction(fit)["equally_good"])
        yield f"{fit.verdict.upper()}: these data fit equally well: {first}; and {second}"
    if fit.representative and len(fit.x) > 1:
        found = fit.representative
        yield (f"best known is the flow stress at the plastic strain {found.plastic_strain:.3g} (total strain "
               f"{found.total_strain:.3g}): {found.stress:.5g}, 95 % region {found.lower:.5g} to {found.upper:.5g}")
    for candidate in fit.candidates:
        yield (f"with '{candidate.name}' the standard errors would be "
               + ", ".join(f"{name} {error:.3g}" for name, error in candidate.standard_errors.items()))


def print_fit(fit, report):
    for line in [*table_of(fit), *sentences(fit)]:
        report(line)
    report(f"{fit.n_runs} runs, {fit.n_made} of them made now: {fit.processor_seconds:.0f} s of processors, "
           f"{fit.seconds / 60.:.1f} minutes")

