# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the diagrams of the pages that run the program have in common."""

from elasto_plastic_contact.plots.figures import make_parser, save
from elasto_plastic_contact.program import add_program
from ..verification.runner import Runner


def draw_own_runs(plot, description, default_output, arguments):
    """Saves the figure that plot(runner) returns, which runs the program."""
    parser = make_parser(description, default_output)
    add_program(parser)
    chosen = parser.parse_args(arguments)
    save(plot(Runner(chosen.program, 1)), chosen.output)
