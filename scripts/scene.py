# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What render.py sees of a run: the fields over time, and where the contact is.
Needs ParaView's Python modules."""

import math
import os
from dataclasses import dataclass

import numpy
from paraview import servermanager
from paraview import simple as pv
from vtkmodules.util.numpy_support import vtk_to_numpy


class RenderError(Exception):
    """Something the user can mend; the message says how."""


@dataclass
class Contact:
    """Where the pressure is: its centre of gravity and the radius around it."""
    centre: list
    radius: float


class TimeSeries:
    """The data of a .pvd file."""

    def __init__(self, directory, name):
        self.path = os.path.join(directory, name)
        if not os.path.isfile(self.path):
            raise RenderError(f"there is no '{name}' in '{directory}'")
        self.source = pv.PVDReader(FileName=self.path)
        self.source.UpdatePipelineInformation()
        self.times = list(self.source.TimestepValues) or [0.]

    def time(self, step):
        if not -len(self.times) <= step < len(self.times):
            raise RenderError(f"--step is {step}, but '{self.path}' has {len(self.times)} entries")
        return self.times[step]

    def show(self, time):
        """Bring the source to a time."""
        self.source.UpdatePipeline(time)
        if self.source.GetDataInformation().GetNumberOfPoints() == 0:
            raise RenderError(f"'{self.path}' holds no points: is the run complete?")


def smooth(source):
    """Join the cells, which are written one by one, and make fields that are
    constant on each of them continuous."""
    cell_values = pv.PointDatatoCellData(Input=source, PassPointData=1)
    joined = pv.CleantoGrid(Input=cell_values)
    return pv.CellDatatoPointData(Input=joined)


def field_names(source):
    return set(source.PointData.keys())


def field_range(source, field, times):
    """The lowest and highest value at any of the times; of a vector or tensor, of
    its norm."""
    lowest, highest = math.inf, -math.inf
    for time in times:
        source.UpdatePipeline(time)
        values = source.PointData[field]
        low, high = values.GetRange(0 if values.GetNumberOfComponents() == 1 else -1)
        lowest, highest = min(lowest, low), max(highest, high)
    return lowest, highest


def extent(source):
    """Lower corner, upper corner, and the longest side of the bounding box."""
    bounds = source.GetDataInformation().GetBounds()
    lower, upper = list(bounds[0::2]), list(bounds[1::2])
    return lower, upper, max(b - a for a, b in zip(lower, upper))


def extent_over_time(source, times):
    """The box that holds the source at all times."""
    boxes = []
    for time in times:
        source.UpdatePipeline(time)
        boxes.append(extent(source)[:2])
    return numpy.min([lower for lower, _ in boxes], axis=0), numpy.max([upper for _, upper in boxes], axis=0)


def is_flat(source):
    lower, upper, length = extent(source)
    return upper[2] - lower[2] < 1e-10 * length


def points_and_values(source, field):
    data = servermanager.Fetch(source)
    values = data.GetPointData().GetArray(field)
    if values is None:
        raise RenderError(f"the data hold no '{field}'")
    return vtk_to_numpy(data.GetPoints().GetData()), vtk_to_numpy(values)


def contact_at(surface, time):
    """The contact at a time, or None."""
    surface.show(time)
    points, pressure = points_and_values(surface.source, "contact_pressure")
    pressure = pressure.clip(min=0.)
    if pressure.sum() == 0.:
        return None
    centre = (points * pressure[:, None]).sum(axis=0) / pressure.sum()
    loaded = points[pressure > 1e-3 * pressure.max()]
    radius = math.sqrt(((loaded - centre) ** 2).sum(axis=1).max())
    return Contact(list(centre), radius)


def last_contact(surface, time):
    """The contact at a time or, where there is none any more, the last one before."""
    for earlier in reversed([t for t in surface.times if t <= time]):
        contact = contact_at(surface, earlier)
        if contact:
            return contact
    return None


def largest_contact(surface):
    contacts = [contact for contact in (contact_at(surface, time) for time in surface.times) if contact]
    return max(contacts, key=lambda contact: contact.radius, default=None)


def most_plastic_point(body):
    """Where the equivalent plastic strain is largest; without any, the middle."""
    if "equivalent_plastic_strain" in field_names(body):
        points, strain = points_and_values(body, "equivalent_plastic_strain")
        if strain.max() > 0.:
            return list(points[strain.argmax()])
    lower, upper, _ = extent(body)
    return [0.5 * (a + b) for a, b in zip(lower, upper)]
