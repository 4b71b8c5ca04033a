# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Versions, tolerances, what the solver has reached, and the input to repeat a run."""

import numpy

from .facts import LIMIT

# What the solver has reached: column of statistics.csv, name.
REACHED = (("residual", "residual, relative to all forces"), ("force_balance_error", "contact force against reactions"),
           ("complementarity_error", "force times distance over force times depth"))


def write(facts, document):
    document.heading("Constants")
    document.subheading("Versions")
    if facts.program:
        program = facts.program
        document.table([], [["program", f"ElastoPlasticContact {program['version']}"],
                            ["revision", program["revision"] or "-"],
                            ["build", program["build"]], ["library", f"deal.II {program['deal_ii']}"],
                            ["processors (MPI ranks)", program["ranks"]], ["numbers per SIMD batch", program["lanes"]]])
    else:
        document.missing("parameters.prm does not say which version of the program has made these results: they are of "
                         "a version that did not record it.")
    write_solver(facts, document)
    document.subheading("Input")
    document.paragraph("Entries that are not at their defaults; with them and this version the run can be repeated "
                       "(files that it names must be there).")
    document.code(as_parameter_file(facts.changed))


def write_solver(facts, document):
    document.subheading("Solver")
    if facts.kind == LIMIT:
        table = facts.run.table("limit_load")
        document.table(["", "last mesh"], [[name, f"{table[column][-1]:.3g}"] for column, name in (
            ("lower_iterations", "iterations of the interior point method, lower bound"),
            ("upper_iterations", "upper bound"), ("stress_error", "largest violation by the stresses"),
            ("velocity_error", "largest violation by the mechanism"), ("wall_seconds", "seconds"))])
        return
    rows = [[entry, facts.text(path)] for entry, path in (
        ("tolerance of the residual", "Nonlinear solver/Tolerance"),
        ("Newton iterations allowed", "Nonlinear solver/Maximum number of iterations"),
        ("linear solver", "Linear solver/Type"),
        ("linear iterations allowed", "Linear solver/Maximum number of iterations"))]
    statistics = facts.run.statistics
    rows += [[f"{name}, largest of all solves", f"{numpy.nanmax(statistics[column]):.2g}"] for column, name in REACHED
             if numpy.isfinite(statistics[column]).any()]
    rows += [["Newton iterations, mean of all solves", f"{statistics['newton_iterations'].mean():.1f}"],
             ["largest penetration of a node", facts.quantity(statistics["max_penetration"].max(), "length", 2)],
             ["seconds of all solves", f"{statistics['wall_seconds'].sum():.3g}"],
             ["memory of all ranks together", f"{statistics['memory_mb'].max():.0f} MB"]]
    document.table([], rows)


def as_parameter_file(changed):
    """Entries as a parameter file."""
    lines, section = [], ""
    for path, value in sorted(changed.items(), key=lambda item: ("/" in item[0], list(changed).index(item[0]))):
        head, _, entry = path.rpartition("/")
        if head != section:
            lines += ["end"] * bool(section) + ["", f"subsection {head}"]
            section = head
        lines.append(f"{'  ' if head else ''}set {entry} = {value}")
    return "\n".join(lines + ["end"] * bool(section))
