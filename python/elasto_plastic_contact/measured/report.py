# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What an evaluation of measured curves prints and writes: sentences, tables, JSON."""

import json

import numpy

from ..files import new_file
from .evaluation import QUANTITIES, statistics

# The columns of the table on the screen; JSON has all quantities.
SHOWN = ("max_force", "max_depth", "stiffness", "contact_depth", "tip_area", "tip_hardness", "tip_reduced_modulus",
         "plane_strain_modulus", "youngs_modulus", "loading_curvature", "total_work", "plastic_share",
         "creep_depth", "creep_rate", "hold_rate_sensitivity")

CONTINUOUS = ("tip_hardness", "tip_reduced_modulus", "plane_strain_modulus", "youngs_modulus")


def print_sentences(evaluation):
    """Those of all indents once, the others with their indent."""
    for sentence in evaluation.sentences:
        print(sentence)
    common = set.intersection(*(set(indent.remarks) for indent in evaluation.indents))
    for sentence in dict.fromkeys(evaluation.indents[0].remarks):
        if sentence in common:
            print(sentence)
    for indent in evaluation.indents:
        for sentence in indent.remarks:
            if sentence not in common:
                print(f"indent {indent.curve.name}: {sentence}")


def segments_of(indent):
    """Such as 'load 0 to 300 mN in 12 s, hold 5.02 s, unload ...'."""
    curve, texts = indent.curve, []
    for segment in indent.segments:
        forces = f"{curve.force[segment.begin]:.3g} to {curve.force[segment.end]:.3g} mN"
        duration = "" if curve.time is None else f" in {curve.time[segment.end] - curve.time[segment.begin]:.3g} s"
        texts.append(f"{segment.kind} {forces}{duration}")
    return ", ".join(texts)


def print_segments(indents):
    """Of each indent, unless all have the same kinds of segments; then of the first."""
    kinds = {tuple(segment.kind for segment in indent.segments) for indent in indents}
    for indent in indents[:1] if len(kinds) == 1 else indents:
        print(f"segments of indent {indent.curve.name}: {segments_of(indent)}")


def print_rows(head, rows):
    """Right-aligned columns."""
    widths = [max(map(len, column)) for column in zip(head, *rows)]
    for row in (head, *rows):
        print("  ".join(text.rjust(width) for text, width in zip(row, widths)))


def head_of(names, first):
    labels = [QUANTITIES[name] for name in names]
    return [*first, *(label for label, _ in labels)], [*[""] * len(first), *(unit for _, unit in labels)]


def print_table(indents):
    """A row for each unloading, and mean ± standard deviation for each number of unloading, and of all."""
    present = [name for name in SHOWN if any(name in found for indent in indents for found in indent.unloadings)]
    head, units = head_of(present, ["indent", "unloading"])
    rows = [[indent.curve.name, str(number), *(f"{found[name]:.4g}" if name in found else "-" for name in present)]
            for indent in indents for number, found in enumerate(indent.unloadings, 1)]
    if not rows:
        print("no unloading was found; it takes a fall of the force after the load (if that is there, change --noise)")
        print_loadings(indents)
        return
    print_rows(head, [units, *rows])
    if len(rows) > 1:
        print_statistics(indents, present)


def print_loadings(indents):
    present = [name for name in QUANTITIES if any(name in indent.loading for indent in indents)]
    head, units = head_of(present, ["indent"])
    print_rows(head, [units, *([indent.curve.name, *(f"{indent.loading[name]:.4g}" if name in indent.loading else "-"
                                                     for name in present)] for indent in indents)])


def print_statistics(indents, present):
    print("\nmean ± standard deviation")
    head, units = head_of(present, ["unloading", "number"])
    groups = {str(number): group for number, group in enumerate(by_number(indents), 1)} if len(indents) > 1 else {}
    if len(groups) != 1:
        groups["all"] = [found for indent in indents for found in indent.unloadings]
    rows = []
    for name, group in groups.items():
        found = statistics(group)
        rows.append([name, str(len(group)), *(mean_and_deviation(found.get(quantity)) for quantity in present)])
    print_rows(head, [units, *rows])


def print_means(rows):
    """Mean ± standard deviation of the quantities of all rows, in a line each."""
    print_rows(["", "mean ± deviation", ""], [[QUANTITIES[name][0], mean_and_deviation(found), QUANTITIES[name][1]]
                                            for name, found in statistics(rows).items()])


def by_number(indents):
    """The first unloadings of all indents, the second ones and so on."""
    return [[indent.unloadings[number] for indent in indents if number < len(indent.unloadings)]
            for number in range(max(len(indent.unloadings) for indent in indents))]


def mean_and_deviation(found):
    if found is None:
        return "-"
    return f"{found['mean']:.4g}" + ("" if found["deviation"] is None else f" ± {found['deviation']:.2g}")


def print_last_holds(indents):
    """Of loads that are not unloaded."""
    for indent in indents:
        if indent.last_hold:
            texts = (f"{QUANTITIES[name][0]} {value:.4g} {QUANTITIES[name][1]}".rstrip()
                     for name, value in indent.last_hold.items())
            print(f"hold at the end of indent {indent.curve.name}: {', '.join(texts)}")


def print_continuous(indents):
    """Means over the deeper half of the loading, where tips are best known."""
    for indent in indents:
        values = indent.continuous
        if values:
            deep = values["max_depth"] >= 0.5 * values["max_depth"].max()
            texts = (f"{QUANTITIES[name][0]} {values[name][deep].mean():.4g} ± {values[name][deep].std(ddof=1):.2g} "
                     f"{QUANTITIES[name][1]}"
                     for name in CONTINUOUS if name in values)
            print(f"continuous stiffness of indent {indent.curve.name}, {deep.sum()} points of the deeper half of the "
                  f"loading: {', '.join(texts)}")


def print_evaluation(evaluation):
    print_sentences(evaluation)
    print_segments(evaluation.indents)
    print()
    print_table(evaluation.indents)
    print_last_holds(evaluation.indents)
    print_continuous(evaluation.indents)


def as_json(evaluation):
    """A dictionary of numbers, texts and lists."""
    constants = evaluation.constants
    unloadings = [found for indent in evaluation.indents for found in indent.unloadings]
    return {
        "files": [str(file) for file in evaluation.files],
        "units": {name: unit for name, (_, unit) in QUANTITIES.items()},
        "constants": {"beta": constants.beta, "epsilon": constants.epsilon, "fitted_shares": list(constants.shares),
                      "indenter": list(constants.indenter), "poissons_ratio": constants.poissons_ratio},
        "remarks": evaluation.sentences,
        "indents": [indent_as_json(indent) for indent in evaluation.indents],
        "statistics": {"all": statistics(unloadings),
                       "by_unloading": [statistics(group) for group in by_number(evaluation.indents)]}}


def indent_as_json(indent):
    return {"name": indent.curve.name, "remarks": list(indent.remarks), "instrument": indent.curve.notes.others,
            "segments": [segment_as_json(indent.curve, segment) for segment in indent.segments],
            "loading": indent.loading, "unloadings": indent.unloadings, "last_hold": indent.last_hold,
            "continuous": {name: plain(values) for name, values in indent.continuous.items()}}


def segment_as_json(curve, segment):
    ends = {"begin": segment.begin, "end": segment.end}
    found = {"kind": segment.kind, "points": [segment.begin, segment.end]}
    for quantity in curve.quantities():
        found[quantity] = [float(getattr(curve, quantity)[point]) for point in ends.values()]
    return found


def write_json(values, path):
    with new_file(path) as file:
        json.dump(values, file, indent=1, ensure_ascii=False)
        file.write("\n")


def print_results(results, path):
    """Mean and scatter of a table of results."""
    print(f"{path}: results, one row an indent, no curve; {len(results.values)} indents")
    rows = []
    for heading, column in zip(results.headings, results.values.T):
        if numpy.isfinite(column).all() and column.mean() != 0.:
            deviation = column.std(ddof=1) if numpy.ptp(column) > 0. else 0.
            share = 100. * deviation / abs(column.mean())
            rows.append([heading, f"{column.mean():.5g}", f"{deviation:.3g}", f"{share:.2g} %"])
    print_rows(["", "mean", "deviation", "relative"], rows)


def results_as_json(results, evaluated):
    """evaluated: dictionaries by QUANTITIES, a row each; empty if nothing was."""
    return {"headings": list(results.headings), "rows": [plain(row) for row in results.values],
            "mean": plain(results.values.mean(axis=0)), "deviation": plain(results.values.std(axis=0, ddof=1)),
            "evaluated": evaluated, "statistics": statistics(evaluated)}


def plain(values):
    """A list of numbers, None where there is none."""
    return [float(value) if numpy.isfinite(value) else None for value in values]
