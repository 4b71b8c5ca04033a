# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs ElastoPlasticContact, and reads, draws and checks what it computes."""

from .errors import UserError
from .program import run
from .results import Results

__all__ = ["Results", "UserError", "run"]
