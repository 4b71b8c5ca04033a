# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs ElastoPlasticContact, and reads, draws and checks what it computes."""

from .errors import UserError
from .program import run
from .results import Results

__all__ = ["Results", "UserError", "fit", "read_curve", "run"]


def __getattr__(name):
    """What needs NumPy, or SciPy, for those who use it only."""
    if name == "fit":
        from .fitting.command import fit
        return fit
    if name == "read_curve":
        from .measured import read_curve
        return read_curve
    raise AttributeError(f"module '{__name__}' has no attribute '{name}'")
