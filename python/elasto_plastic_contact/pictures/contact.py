# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the contact is."""

from dataclasses import dataclass

import numpy


@dataclass
class Contact:
    """Where the pressure is: its centre of gravity and the radius around it, of a single node up to the next one."""
    centre: numpy.ndarray
    radius: float


def contact_at(view):
    """The contact that is seen in surface.pvd, or None."""
    surface = view.fields("surface")
    points, pressure = surface["points"], surface["contact_pressure"].clip(min=0.)
    if pressure.sum() == 0.:
        return None
    centre = (points * pressure[:, None]).sum(axis=0) / pressure.sum()
    is_loaded = pressure > 1e-3 * pressure.max()
    distances = numpy.linalg.norm(points - centre, axis=1)
    radius = distances[is_loaded].max()
    is_one_node = radius < 1e-9 * distances.max()
    return Contact(centre, distances[~is_loaded].min() if is_one_node else radius)


def contact_to_look_at(views):
    """The largest one of the views or, where there is none any more, the last one before, of the first run that has
    one; or None."""
    views = [view for view in views if view.results.has("surface.pvd")]
    contacts = [contact for contact in map(contact_at, views) if contact]
    if contacts:
        return max(contacts, key=lambda contact: contact.radius)
    return next(filter(None, (contact_at(earlier) for view in views for earlier in view.earlier())), None)


def most_plastic_point(fields):
    """Where the equivalent plastic strain is largest; without any, the middle."""
    strain = fields.get("equivalent_plastic_strain", numpy.zeros(1))
    if strain.max() > 0.:
        return fields["points"][strain.argmax()]
    return 0.5 * (fields["points"].min(axis=0) + fields["points"].max(axis=0))
