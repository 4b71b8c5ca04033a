# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a load history gives the same however it is computed, for values of 'Contact/Edge'.

usage: scripts/command.py contact_uniqueness [--edge VALUE ...] [--histories TEXT ...] [--variants NAME ... | --number N]
                                             [--json FILE] [--program PROGRAM]

Coarse bodies in the plane, of revolution and in space are pressed, unloaded in part and pressed again: once, and in
other ways (variants): shape of the indenter or load times 1 + 1e-12, other linear solvers and tolerances, other
numbers of ranks, x and -x exchanged, other units, other kernels of OpenBLAS. The nonlinear solver's tolerance is
1e-12 everywhere (1e-13 in the variant 'tolerance').

Columns: the largest relative change of the quantity in all variants and steps, and the variant with the largest of
force, depth and contact area. A change is relative to the value in the step, or to a thousandth of the largest one
of the history where the value is smaller.
"""

import argparse
import subprocess
import tempfile

from .edge_runs import EdgeRuns, Report, add_edges, chosen_edges, last_message
from .uniqueness_histories import histories
from .uniqueness_variants import VARIANTS, Variant, as_entries, force_factor
from elasto_plastic_contact.arguments import number

QUANTITIES = ("force", "depth", "contact_area", "max_pressure")
# Values below this part of the largest one are compared with that.
SMALL = 1e-3


def results(runs, history, edge, variant=Variant()):
    """The steps of a run in the units of the history."""
    length, stress = variant.length, variant.stress
    units = {"force": force_factor(history.kind, length, stress), "depth": length, "max_pressure": stress,
             "contact_area": length ** (1 if history.kind == "plane" else 2)}
    with tempfile.TemporaryDirectory() as folder:
        rows = runs.run(history.case, as_entries(history, folder), edge, variant.ranks, variant.environment)["history"]
    return [{name: row[name] / unit for name, unit in units.items()} for row in rows]


def changes(rows, others):
    """The largest relative change of each quantity over all steps; None if the numbers of steps differ."""
    if len(rows) != len(others):
        return None
    found = {}
    for name in QUANTITIES:
        small = SMALL * max(abs(row[name]) for row in rows)
        found[name] = max(abs(other[name] - row[name]) / max(abs(row[name]), small) for row, other in zip(rows, others))
    return found


def compare(runs, history, edge, variants):
    """The changes in each variant by its name; a text if there are none to compare."""
    rows = results(runs, history, edge)
    found = {}
    for name, variant in variants.items():
        changed = variant.change(history)
        if changed is None:
            continue
        try:
            found[name] = changes(rows, results(runs, changed, edge, variant)) or "other steps"
        except subprocess.CalledProcessError as error:
            found[name] = last_message(error)
    return found


def worst_of(found):
    """The largest change of each quantity, and the variant of the largest of all but the pressure."""
    compared = {name: change for name, change in found.items() if not isinstance(change, str)}
    failed = [f"{name}: {text}" for name, text in found.items() if isinstance(text, str)]
    if not compared:
        return [None] * len(QUANTITIES) + ["; ".join(failed)]
    worst = max(compared, key=lambda name: max(compared[name][quantity] for quantity in QUANTITIES[:3]))
    return [*(max(change[quantity] for change in compared.values()) for quantity in QUANTITIES),
            "; ".join([worst, *failed])]


def main(arguments):
    """Prints a table for each edge, and one by variant."""
    parser = argparse.ArgumentParser(prog="contact_uniqueness", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    add_edges(parser)
    parser.add_argument("--histories", nargs="+", default=[""], metavar="TEXT",
                        help="those whose names begin so (default: all)")
    which = parser.add_mutually_exclusive_group()
    which.add_argument("--variants", nargs="+", default=list(VARIANTS), choices=VARIANTS, metavar="NAME",
                       help=f"{'; '.join(VARIANTS)} (default: all)")
    which.add_argument("--number", type=number(int, least=1), metavar="N", help="the first N of these variants")
    chosen = parser.parse_args(arguments)
    runs, report = EdgeRuns(chosen.program), Report(chosen.json)
    variants = {name: VARIANTS[name] for name in chosen.variants[:chosen.number]}
    for edge in chosen_edges(chosen):
        all_found = {}
        report.begin(f"{edge}: largest relative changes", [*QUANTITIES, "worst variant"])
        for name, history in histories().items():
            if name.startswith(tuple(chosen.histories)):
                try:
                    found = compare(runs, history, edge, variants)
                except subprocess.CalledProcessError as error:
                    found = {"unchanged": last_message(error)}
                report.add(name, worst_of(found))
                all_found |= {(name, variant): change for variant, change in found.items()}
        report.add("all", worst_of({f"{name}, {variant}": change for (name, variant), change in all_found.items()
                                    if not isinstance(change, str)}))
        report.begin(f"{edge}: by variant", [*QUANTITIES, "worst history"])
        for variant in variants:
            report.add(variant, worst_of({name: change for (name, other), change in all_found.items() if other == variant}))
    return 0
