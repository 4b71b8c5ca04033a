# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the work of the loads has gone."""

from .facts import LIMIT

PARTS = (("elastic_energy", "elastic energy"), ("hardening_energy", "stored by hardening"),
         ("dissipation", "plastic dissipation"), ("frictional_dissipation", "friction"))


def balance(row):
    """Work of the loads, the parts of PARTS, and what is missing in them, of a row of history.csv."""
    parts = [row[column] for column, _ in PARTS]
    return [row["external_work"], *parts, row["external_work"] - sum(parts)]


def write(facts, document):
    document.heading("Energy balance")
    if facts.kind == LIMIT:
        document.missing("A limit load has no energies: its stresses and its mechanism are rates.")
        return
    history = facts.run.history
    rows = {"at the end": history[-1]}
    if facts.has_contact and facts.step_of_largest_force < len(history) - 1:
        rows = {"at the largest force": history[facts.step_of_largest_force]} | rows
    names = ["work of indenter, supports and tractions", *(name for _, name in PARTS), "difference"]
    columns = [balance(row) for row in rows.values()]
    largest = max(abs(history["external_work"]))
    document.table(["", *rows], [[name, *(facts.quantity(value, "energy") for value in values)]
                                 for name, values in zip(names, zip(*columns))])
    share = max(abs(column[-1]) for column in columns) / largest if largest > 0. else 0.
    document.paragraph(f"The difference is {100. * share:.2g} % of the largest work. {reason(facts)}")


def reason(facts):
    if facts.is_single_step:
        return ("In a single step (Hencky's deformation theory) the loads are taken to grow in proportion, and half of "
                "final forces times displacements is no more than an estimate of their work.")
    return ("The work of the loads is summed up by the trapezoidal rule over the load steps; the difference is its "
            "error and, if the mesh has changed, what the changes add.")
