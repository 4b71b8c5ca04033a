# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is shown side by side."""

import pathlib
from dataclasses import dataclass

from ..fields import times
from ..results import Results


@dataclass(frozen=True)
class View:
    """An entry of the .pvd files of a run, counted from 0."""
    results: Results
    step: int

    def fields(self, kind):
        return self.results.fields(kind, self.step)

    @property
    def time(self):
        return times(self.results.directory, "solution")[self.step]

    @property
    def run(self):
        """The name of its folder."""
        return pathlib.Path(self.results.directory).resolve().name

    def earlier(self):
        """Those of the same run before it, the last one first."""
        return (View(self.results, step) for step in range(self.step - 1, -1, -1))
