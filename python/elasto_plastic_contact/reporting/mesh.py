# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mesh of a run: elements, unknowns, and how large they are where the contact is."""

from dataclasses import dataclass

import numpy

from ..results import last_of_largest
from .facts import BOUNDED, LIMIT

ELEMENTS = {(2, 1): "bilinear quadrilaterals", (2, 2): "biquadratic quadrilaterals",
            (3, 1): "trilinear hexahedra", (3, 2): "triquadratic hexahedra"}


def elements_in_words(facts):
    return ELEMENTS[facts.dimension, int(facts.number("Discretization/Polynomial degree"))]


@dataclass(frozen=True)
class ContactSizes:
    """Lengths of the sides of undeformed elements under the contact, at the largest force of which there is a profile:
    the smallest one, the largest one, that at the edge; and the contact radius there (in the plane half the width)."""
    smallest: float
    largest: float
    at_edge: float
    radius: float

    @property
    def elements(self):
        """How many of the mean size lie over the radius."""
        return self.radius / (0.5 * (self.smallest + self.largest))


def contact_sizes(facts):
    """None if the run has written no profile with contact."""
    if not facts.has_contact or not facts.run.has("surface_profile.csv"):
        return None
    table, history = facts.run.table("surface_profile"), facts.run.history
    if "line" in table.dtype.names:
        table = table[table["line"] == 1.]
    written = history[numpy.isin(history["step"], table["step"])]
    step = written[last_of_largest(written["force"])]
    rows = table[table["step"] == step["step"]]
    places = numpy.column_stack([rows[name] for name in "xy" if name in rows.dtype.names])
    along = numpy.linalg.norm(places - places[0], axis=1)
    order = numpy.argsort(along)
    along, touched = along[order], numpy.asarray(rows["contact_pressure"] > 0.)[order]
    # (In the plane all nodes have a row, in space all sides of faces.)
    degree = int(facts.number("Discretization/Polynomial degree")) if facts.dimension == 2 else 1
    sizes = degree * numpy.diff(along)
    under = numpy.flatnonzero(touched[1:] & touched[:-1] & (sizes > 1e-9 * along[-1]))
    if not len(under):
        return None
    return ContactSizes(sizes[under].min(), sizes[under].max(), sizes[under[-1]], step["contact_radius"])


def write(facts, document):
    document.heading("Mesh")
    if facts.kind == LIMIT:
        return write_meshes(facts, document, "limit_load", ("lower_bound", "upper_bound", "relative_difference"))
    locking = ("with the volume change as its mean over each element (B-bar)"
               if facts.text("Discretization/Volumetric treatment") == "B-bar" else "fully integrated")
    document.paragraph(f"The elements are {elements_in_words(facts)}, {locking}.")
    history = facts.run.history
    document.table(["", "first step", "last step"],
                   [[name, *(f"{history[column][i]:.0f}" for i in (0, -1))]
                    for name, column in (("elements", "cells"), ("displacement unknowns", "dofs"))])
    sizes = contact_sizes(facts)
    if sizes:
        rows = [["contact radius" if not facts.run.is_plane else "half width of the contact", sizes.radius],
                ["smallest element under the contact", sizes.smallest], ["largest one", sizes.largest],
                ["element at the edge of the contact", sizes.at_edge]]
        document.table([], [[name, facts.quantity(value, "length")] for name, value in rows]
                       + [["elements of mean size over the radius", f"{sizes.elements:.1f}"]],
                       "At the largest force of which there is a profile of the surface")
    elif facts.has_contact:
        document.missing("The run has written no surface profile with contact ('Output/Surface profile'), so that the "
                         "sizes of the elements under the contact are not known here.")
    if facts.kind == BOUNDED:
        return write_meshes(facts, document, "error_bound", ("force", "relative_bound"))
    if facts.run.has("mesh_changes.csv") and has_rows(facts, "mesh_changes"):
        changes = facts.run.table("mesh_changes")
        document.paragraph(f"The mesh has followed the solution; changes of it between load steps: {len(changes)}.")
    return None


def has_rows(facts, name):
    with open(facts.run.path(f"{name}.csv"), encoding="utf-8") as file:
        return sum(1 for _ in file) > 1


def write_meshes(facts, document, name, columns):
    """The meshes of an analysis that is solved on one after the other."""
    table = facts.run.table(name)
    names = ["cycle", "cells", "triangles", *columns]
    document.table([text.replace("_", " ") for text in names],
                   [[f"{row[column]:.8g}" for column in names] for row in table],
                   "Meshes of the run, each solved (triangles: tetrahedra in space)")
