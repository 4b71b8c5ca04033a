# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lengths that are given with their unit or without."""

from dataclasses import dataclass

from .units import factor


@dataclass(frozen=True)
class Length:
    """One that was given with its unit, in µm."""
    value: float

    @staticmethod
    def of(given, unit):
        """A plain number is in this unit."""
        return given.value if isinstance(given, Length) else given * factor("length", unit)
