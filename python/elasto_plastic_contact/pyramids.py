# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Regular pyramids, as laboratories use them."""

import math

# The number of faces, and the angle between axis and faces in degrees.
PYRAMIDS = {"berkovich": (3, 65.27), "vickers": (4, 68.), "cube_corner": (3, 35.2644)}


def area_factor(n_faces, face_angle):
    """The section over the square of the height above the apex."""
    return n_faces * math.tan(math.pi / n_faces) * math.tan(math.radians(face_angle)) ** 2
