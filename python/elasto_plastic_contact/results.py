# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a run has written, as arrays. Needs NumPy for that."""

import functools
import math
import os

from .errors import UserError
from .fields import check_step, read_record, reading, records
from .parameter_file import read_entries
from .tables import read_table


# What it takes that a run writes a table.
ORIGINS = {
    "surface_profile.csv": "it takes an indenter, and 'Output/Surface profile' other than 'none'",
    "indentation.csv": "it takes an indenter whose force falls, with three load steps between 95 and 50 % of its largest value, "
                       "or a rate law and a hold of the force or a jump of the rate",
    "continuous_stiffness.csv": "it takes 'Evaluation/Continuous stiffness = true' and a contact that is not plane",
    "error_bound.csv": "it takes 'Analysis = contact with error bound'",
}


def last_of_largest(forces):
    """The number of the largest one; of those that are equal to it but for rounding, as in a hold, of the last."""
    import numpy

    return int(numpy.flatnonzero(forces >= forces.max() - 1e-9 * abs(forces.max()))[-1])


class Results:
    """The output directory of a run. The tables are NumPy arrays with a field for each column:
    results.history["force"] is a column, results.history[-1] the last row."""

    def __init__(self, directory):
        self.directory = os.fspath(directory)

    def path(self, name):
        return os.path.join(self.directory, name)

    def has(self, name):
        return os.path.isfile(self.path(name))

    def expect(self, name):
        """Refuses to look for what a limit load, or such a run, does not have."""
        if self.has(name):
            return
        if name in ORIGINS and self.has("history.csv"):
            raise UserError(f"there is no {name} in '{self.directory}': {ORIGINS[name]}")
        if self.has("limit_load.csv"):
            raise UserError(f"there is no {name} in '{self.directory}': these are the results of a limit load. "
                            f"Draw them by 'epc plot {self.directory}'")

    @functools.lru_cache(maxsize=None)
    def table(self, name):
        """A table by its name without '.csv'."""
        from .arrays import Table  # (which needs NumPy: those who only start the program do without)

        self.expect(f"{name}.csv")
        rows = read_table(self.path(f"{name}.csv"))
        if not rows:
            raise UserError(f"'{self.path(name)}.csv' holds no results yet")
        return Table.of(rows)

    @property
    def history(self):
        """One row per load step; doc/lookup/tables.md lists the columns of all tables."""
        return self.table("history")

    @property
    def statistics(self):
        """One row per nonlinear solve."""
        return self.table("statistics")

    @property
    def indentation(self):
        """One row per unloading of an indentation test, and with rate laws per hold and jump of the rate."""
        return self.table("indentation")

    @property
    def unloadings(self):
        """The rows of indentation.csv that are of an unloading; there may be none."""
        import numpy

        return self.indentation[numpy.isfinite(self.indentation["stiffness"])]

    @property
    def reactions(self):
        """The forces of the supports, one row per load step."""
        return self.table("reactions")

    def fields(self, kind="solution", step=-1):
        """One entry of solution.pvd, surface.pvd and the like: 'points' (x, y, z), the numbers of
        the points of each of the 'cells', and the data of the points by name."""
        import numpy

        files = records(self.directory, kind)
        check_step(step, self.path(f"{kind}.pvd"), len(files))
        with reading(self.path(files[step])):
            return {name: numpy.array(values) for name, values in read_record(self.directory, files[step]).items()}

    @functools.cached_property
    def parameters(self):
        """The effective input of the run: 'Section/Entry' to text."""
        return read_entries(self.path("parameters.prm"))

    def numbers(self, path):
        """The values of an entry that is a list of numbers; empty without it."""
        try:
            return [float(part) for part in self.parameters.get(path, "").split(",") if part.strip()]
        except ValueError:
            raise UserError(f"the run's parameters.prm holds no numbers for '{path}'") from None

    def number(self, path):
        """The first value of an entry of numbers."""
        numbers = self.numbers(path)
        if not numbers:
            raise UserError(f"the run's parameters.prm holds no number for '{path}'")
        return numbers[0]

    @property
    def modelled_part(self):
        """How much of the indenter stands on the body that is computed, such as 0.25; 1 if it never touches."""
        if self.has("indentation.csv"):
            return self.indentation["modelled_part"][0]
        largest = self.history[int(self.history["contact_area"].argmax())]
        radius = largest["contact_radius"]
        whole = 2. * radius if self.is_plane else math.pi * radius ** 2
        return largest["contact_area"] / whole if whole > 0. else 1.

    @property
    def is_axisymmetric(self):
        return self.parameters.get("Kinematics") == "axisymmetric"

    @property
    def is_plane(self):
        return self.parameters.get("Dimension") == "2" and not self.is_axisymmetric
