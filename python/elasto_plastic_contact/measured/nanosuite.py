# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""NanoSuite of Agilent and KLA: its methods, which are told from its exports of data (those are tables)."""

from ..errors import UserError
from .blocks import text_blocks

FORMAT = "NanoSuite"


def knows(lines):
    """Whether it is a method: channels, inputs and formulas."""
    return lines[0].startswith("Method Name") and any(line.strip() in ("Channels", "Inputs", "Test Segments")
                                                      for line in lines)


def read(path, lines, _):
    """Raises UserError: a method has no curve."""
    name = lines[0].partition(":")[2].strip().rpartition("\\")[2]
    channels = [line.strip() for line in lines if line.startswith("\t") and not line.startswith("\t\t")]
    if text_blocks(lines, path):
        raise UserError(f"'{path}' is a method of NanoSuite with rows of numbers, which is not known: export the "
                        "samples alone, as a text or .xls")
    raise UserError(f"'{path}' is the method '{name}' of NanoSuite, with its channels ({', '.join(channels[:3])} and "
                    "so on), formulas and segments: how to measure, without a curve. Export the samples that were "
                    "measured with it, as a text or .xls (File > Export, sheets of the tests), and evaluate that file")
