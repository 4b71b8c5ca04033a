# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hardness and moduli of tables of results: of unloading slope, largest depth and force (or loading curvature)."""

from ..errors import UserError
from ..oliver_pharr import contact_of
from .evaluate_files import constants_of, given_tip, sentence_on
from .evaluation import numbers


def evaluate_results(results, arguments, path):
    """A dictionary by evaluation.QUANTITIES of each row, and sentences; None without a tip. Raises UserError."""
    given = given_tip(arguments, results.depth_unit())
    if given is None:
        return None
    known = results.known()
    if not ({"stiffness", "max_depth"} <= set(known) and {"max_force", "loading_curvature"} & set(known)):
        raise UserError(f"'{path}' has no hardness to be found: that takes columns of dP/dh, h_m, and P_m or C, with "
                        f"their units, and it has {', '.join(results.headings)}. Leave out the tip")
    force = known["max_force"] if "max_force" in known else known["loading_curvature"] * known["max_depth"] ** 2
    constants = constants_of(given[0], arguments)
    rows = [evaluate_row(*row, constants) for row in zip(known["max_depth"], force, known["stiffness"])]
    return rows, [f"tip: {given[1]}", sentence_on(constants, arguments)]


def evaluate_row(depth, force, stiffness, constants):
    found = {"max_depth": depth, "max_force": force, "stiffness": stiffness}
    contact = contact_of(constants.tip, depth, force, stiffness, beta=constants.beta, epsilon=constants.epsilon)
    if not contact[3] > 0.:
        return numbers(found)
    found |= dict(zip(("contact_depth", "tip_area", "tip_hardness", "tip_reduced_modulus"), contact))
    return numbers(found | constants.moduli(contact[3]))
