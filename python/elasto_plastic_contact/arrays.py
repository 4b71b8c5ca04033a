# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables as NumPy arrays."""

import numpy

from .errors import UserError


class Table(numpy.ndarray):
    """The rows of a table, with a field for each column; says which there are if one is missing."""

    @classmethod
    def of(cls, rows):
        """rows: not empty, dictionaries of numbers by column."""
        return numpy.array([tuple(row.values()) for row in rows], [(column, float) for column in rows[0]]).view(cls)

    def __getitem__(self, key):
        columns = self.dtype.names
        if isinstance(key, str) and columns and key not in columns:
            raise UserError(f"a table of the run lacks the column '{key}'; it has {', '.join(columns)}. Has another version "
                            "of the program written it?")
        return super().__getitem__(key)
