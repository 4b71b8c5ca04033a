# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Values in the problem of a fit: numbers within limits, lists of texts."""

import math

from ..errors import UserError

NO_DEFAULT = object()


def number(data, key, place, default=NO_DEFAULT, *, convert=float, least=None, above=None, below=None, most=None):
    """The number of a key, within these limits. Raises UserError."""
    value = data.get(key, default)
    limits = [f"{sign} {limit:g}" for sign, limit in ((">=", least), (">", above), ("<", below), ("<=", most))
              if limit is not None]
    allowed = (convert,) if convert is int else (int, float)
    fits = (isinstance(value, allowed) and not isinstance(value, bool) and math.isfinite(value)
            and (least is None or value >= least) and (above is None or value > above)
            and (below is None or value < below) and (most is None or value <= most))
    if not fits:
        kind = "an integer" if convert is int else "a number"
        given = "missing" if value is NO_DEFAULT else f"{value!r}"
        raise UserError(f"'{place}/{key}' is {given}, but must be {' '.join([kind, ' and '.join(limits)]).strip()}")
    return convert(value)


def texts(data, key, place):
    """The text or the list of texts of a key. Raises UserError."""
    values = data[key] if isinstance(data[key], list) else [data[key]]
    if not values or not all(isinstance(value, str) and value for value in values):
        raise UserError(f"'{place}/{key}' is {data[key]!r}, but must be a text or a list of texts")
    return values
