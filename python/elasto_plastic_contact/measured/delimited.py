# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of numbers as texts, with any separator: what all instruments and spreadsheets can write."""

from ..errors import UserError
from .blocks import text_blocks
from .columns import curves_of_blocks

FORMAT = "a table of numbers"


def knows(_):
    """The last reader that is asked."""
    return True


def read(path, lines, chosen):
    """Raises UserError."""
    blocks = text_blocks(lines, path)
    if not blocks:
        number, line = next((number, line) for number, line in enumerate(lines, 1) if line.strip())
        raise UserError(f"'{path}' holds no rows of numbers; line {number} is '{line.strip()[:60]}'. A curve has a "
                        "column for depth and one for force, separated by tabs, ';', ',' or blanks, and at least five "
                        "rows")
    return curves_of_blocks(blocks, path, chosen)
