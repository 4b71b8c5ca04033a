# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether the rows of a measured curve are in the order of time."""

import numpy

from ..errors import UserError

# No body gives back that many times the work that its loading takes (more than 1, for what drifts).
LARGEST_RETURN = 1.2

SORT = "the rows of a curve must be in the order of time: sort them"


def check_time(time, column, what):
    """Refuses one that falls. what: file and indent, for the message."""
    falls = numpy.flatnonzero(numpy.diff(time) < 0.)
    if len(falls):
        row = falls[0]
        raise UserError(f"{what} has a time that falls from {time[row]:g} in row {row + 1} to {time[row + 1]:g} in row "
                        f"{row + 2} (column '{column}'): {SORT}, or, if that column is no time, leave it out")


def check_work(depth, force, what):
    """Refuses a curve that gives back much more work than its loading takes, above the force that it begins with: one
    that is read backwards."""
    peak = int(force.argmax())
    over = (force - max(force[0], 0.)).clip(0.)
    parts = 0.5 * (over[1:] + over[:-1]) * numpy.diff(depth)
    taken, returned = parts[:peak].sum(), -parts[peak:].sum()
    if returned > LARGEST_RETURN * max(taken, 0.):
        raise UserError(f"{what} gives back more work from its largest force on, {returned:.4g}, than it takes before, "
                        f"{taken:.4g} (force times depth as in the file), as if it were unloaded first: {SORT}; if they "
                        "are, the depth drifts by more than a curve can have")
