# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The numbers of a run that a reader looks for first, and that two meshes are compared by."""

import math
from dataclasses import dataclass

from .facts import BOUNDED, LIMIT, TEST


@dataclass(frozen=True)
class KeyNumber:
    """kind: of Facts.quantity()."""
    name: str
    value: float
    kind: str


# Of the first unloading: column of indentation.csv, name, kind.
UNLOADING = (("stiffness", "initial slope of the unloading", "stiffness"),
             ("hardness", "hardness, with the contact area", "stress"),
             ("reduced_modulus", "reduced modulus, with the contact area", "stress"),
             ("tip_hardness", "hardness by Oliver and Pharr", "stress"),
             ("tip_reduced_modulus", "reduced modulus by Oliver and Pharr", "stress"))

# Of holds, and of jumps of the rate: column of indentation.csv, name.
RATES = (("hold_rate_sensitivity", "rate sensitivity of the hardness, by the first hold"),
         ("jump_rate_sensitivity", "rate sensitivity of the hardness, by the first jump of the rate"))


def key_numbers(facts):
    return {LIMIT: of_limit_load, BOUNDED: of_bounds, TEST: of_test}.get(facts.kind, of_contact)(facts)


def of_contact(facts):
    history = facts.run.history
    top, last = history[facts.step_of_largest_force], history[-1]
    found = [KeyNumber("largest force", top["force"], "force"), KeyNumber("depth there", top["depth"], "length"),
             KeyNumber("contact radius there", top["contact_radius"], "length"),
             KeyNumber("contact area there", top["contact_area"], "area"),
             KeyNumber("largest pressure there", top["max_pressure"], "stress"),
             KeyNumber("pile-up there (negative: sink-in)", top["pile_up"], "length"),
             KeyNumber("largest equivalent plastic strain", history["max_equivalent_plastic_strain"].max(), "number"),
             KeyNumber("work of the loads at the end", last["external_work"], "energy"),
             KeyNumber("dissipation at the end", last["dissipation"], "energy")]
    if last["depth"] < top["depth"] and last["force"] < 0.01 * top["force"]:
        found.append(KeyNumber("depth after unloading", last["depth"], "length"))
    if facts.run.has("indentation.csv"):
        found += [KeyNumber(name, row[column], kind) for row in facts.run.unloadings[:1]
                  for column, name, kind in UNLOADING if row[column] > 0.]
    return found + rate_sensitivities(facts)


def rate_sensitivities(facts):
    """None of runs without a rate law, or of versions that do not have them."""
    found = []
    table = facts.run.indentation if facts.run.has("indentation.csv") else None
    for column, name in RATES:
        if table is not None and column in table.dtype.names:
            found += [KeyNumber(name, value, "number") for value in table[column] if math.isfinite(value)][:1]
    return found


def of_test(facts):
    history = facts.run.history
    found = [KeyNumber("largest equivalent plastic strain", history["max_equivalent_plastic_strain"].max(), "number"),
             KeyNumber("work of the loads at the end", history["external_work"][-1], "energy"),
             KeyNumber("plastic work at the end", history["plastic_work"][-1], "energy")]
    if facts.run.has("reactions.csv"):
        row = facts.run.reactions[-1]
        found += [KeyNumber(f"force of the support {name} at the end", row[name], "force")
                  for name in row.dtype.names if name not in ("step", "time")]
    return found


def of_limit_load(facts):
    row = facts.run.table("limit_load")[-1]
    factor = facts.text("Limit load/Load") == "tractions" or facts.text("Indenter/Type") == "none"
    return [KeyNumber(f"{end} bound of the limit load", row[f"{end}_bound"], "number" if factor else "force")
            for end in ("lower", "upper")]


def of_bounds(facts):
    row = facts.run.table("error_bound")[-1]
    columns = (("force", "force", "force"), ("depth", "depth", "length"),
               ("force_lower_bound", "force, lower bound", "force"),
               ("force_upper_bound", "force, upper bound", "force"),
               ("depth_lower_bound", "depth, lower bound", "length"),
               ("depth_upper_bound", "depth, upper bound", "length"),
               ("bound", "bound of the error in energy", "energy"),
               ("relative_bound", "the same over the energy", "number"))
    return [KeyNumber(name, row[column], kind) for column, name, kind in columns]


def text_of(facts, number):
    if number.kind == "stiffness":
        unit = f" {facts.units.force}/{facts.units.length}" if facts.units.are_known else ""
        return f"{number.value:.5g}{unit}"
    return facts.quantity(number.value, number.kind)


def write(facts, document):
    document.heading("Results in short")
    part = facts.run.modelled_part if facts.has_contact else 1.
    if part < 0.99:
        document.paragraph("Forces, areas, stiffness and energies, also in the curves, are those of the part of the "
                           f"indenter that stands on the body, {part:.3g} of the whole.")
    document.table([], [[number.name, text_of(facts, number)] for number in key_numbers(facts)])
