# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Read what a run has written. Needs NumPy, and for fields VTK's Python modules."""

import csv
import functools
import os
import xml.etree.ElementTree as ElementTree

import numpy


class ResultError(Exception):
    """Something the user can mend; the message says how."""


class Run:
    """The output directory of a run."""

    def __init__(self, directory):
        self.directory = directory

    def path(self, name):
        return os.path.join(self.directory, name)

    def has(self, name):
        return os.path.isfile(self.path(name))

    @functools.lru_cache(maxsize=None)
    def table(self, name):
        """The columns of a .csv file, by name."""
        path = self.path(name)
        try:
            with open(path, newline="", encoding="utf-8") as file:
                rows = list(csv.DictReader(file))
        except OSError as error:
            raise ResultError(f"'{path}' cannot be read: {error.strerror}") from None
        if not rows:
            raise ResultError(f"'{path}' holds no results yet")
        try:
            return {column: numpy.array([float(row[column]) for row in rows]) for column in rows[0]}
        except (TypeError, ValueError):
            raise ResultError(f"'{path}' is damaged: a value is missing or is not a number") from None

    @functools.cached_property
    def parameters(self):
        """The effective input of the run: 'Section/Entry' to text."""
        path = self.path("parameters.prm")
        values, sections, continued = {}, [], ""
        try:
            with open(path, encoding="utf-8") as file:
                lines = file.read().splitlines()
        except OSError as error:
            raise ResultError(f"'{path}' cannot be read: {error.strerror}") from None
        for line in lines:
            line = continued + line.split("#")[0].strip()
            continued = ""
            if line.endswith("\\"):
                continued = line[:-1]
            elif line.startswith("subsection "):
                sections.append(line[len("subsection "):].strip())
            elif line == "end":
                sections.pop()
            elif line.startswith("set "):
                entry, value = line[len("set "):].split("=", 1)
                values["/".join(sections + [entry.strip()])] = value.strip()
        return values

    def numbers(self, path):
        """The values of an entry that is a list of numbers; empty without it."""
        return [float(part) for part in self.parameters.get(path, "").split(",") if part.strip()]

    def number(self, path):
        """The first value of an entry of numbers."""
        try:
            return self.numbers(path)[0]
        except (IndexError, ValueError):
            raise ResultError(f"the run's parameters.prm holds no number for '{path}'") from None

    @property
    def is_axisymmetric(self):
        return self.parameters.get("Kinematics") == "axisymmetric"

    @property
    def is_plane(self):
        return self.parameters.get("Dimension") == "2" and not self.is_axisymmetric

    def surface(self, step):
        """Points and contact pressure of one entry of surface.pvd."""
        from vtkmodules.util.numpy_support import vtk_to_numpy
        from vtkmodules.vtkIOXML import vtkXMLPUnstructuredGridReader

        path = self.path("surface.pvd")
        try:
            files = [entry.get("file") for entry in ElementTree.parse(path).iter("DataSet")]
        except OSError as error:
            raise ResultError(f"'{path}' cannot be read: {error.strerror}") from None
        except ElementTree.ParseError as error:
            raise ResultError(f"'{path}' is damaged: {error}") from None
        if not -len(files) <= step < len(files):
            raise ResultError(f"--step is {step}, but '{path}' has {len(files)} entries")

        record = self.path(files[step])
        if not os.path.isfile(record):
            raise ResultError(f"'{record}', named in '{path}', does not exist")
        reader = vtkXMLPUnstructuredGridReader()
        reader.SetFileName(record)
        reader.Update()
        pressure = reader.GetOutput().GetPointData().GetArray("contact_pressure")
        if pressure is None:
            raise ResultError(f"'{record}' holds no point data 'contact_pressure'")
        points = vtk_to_numpy(reader.GetOutput().GetPoints().GetData())
        return points, vtk_to_numpy(pressure)
