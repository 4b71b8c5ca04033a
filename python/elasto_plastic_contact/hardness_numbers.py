# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hardness numbers of a run in their own units: Brinell and Vickers in kgf/mm² (ISO 6506-1, 6507-1), Martens in N/mm²
(ISO 14577-1). Forces are in N and lengths in mm, of the whole indenter; Results need NumPy."""

import math

from .errors import UserError
from .new_case.revolution import STANDARD_GRAVITY
from .results import last_of_largest

VICKERS_ANGLE = 68.  # between faces and axis


def brinell(force, ball, imprint):
    """HBW: the force over the curved surface of an imprint of this diameter, by a ball of that diameter."""
    if not 0. < imprint <= ball:
        raise UserError(f"the imprint's diameter is {imprint:g}, but must be above 0 and at most that of the ball, {ball:g}")
    surface = 0.5 * math.pi * ball * (ball - math.sqrt(ball ** 2 - imprint ** 2))
    return force / STANDARD_GRAVITY / surface


def vickers(force, diagonal):
    """HV: the force over the inclined surface of an imprint with this (mean) diagonal."""
    return 2. * math.sin(math.radians(VICKERS_ANGLE)) * force / STANDARD_GRAVITY / diagonal ** 2


def martens(force, depth, n_faces, face_angle):
    """HM: the force over the surface of a sharp pyramid below the undeformed surface; 26.43 h^2 for Vickers'."""
    angle = math.radians(face_angle)
    return force / (n_faces * math.tan(math.pi / n_faces) * math.tan(angle) ** 2 / math.sin(angle) * depth ** 2)


def residual_diagonal(run):
    """Of a Vickers imprint without load, in the unit of the run: twice how far its outermost corner is from the axis
    then. A corner is where the contact ends on an edge of the pyramid at the largest force. None without a line of
    surface_profile.csv along an edge, at both times."""
    largest = run.history[last_of_largest(run.history["force"])]
    unloaded = run.history[-1]
    if unloaded["force"] > 1e-3 * largest["force"] or not run.has("surface_profile.csv"):
        return None
    at_largest, at_end = (lines_below_edges(run, step) for step in (largest["step"], unloaded["step"]))
    corners = [corner(points, at_end.get(edge, {})) for edge, points in at_largest.items()]
    return 2. * max(filter(None, corners), default=0.) or None


def corner(at_largest, at_end):
    """The distance from the axis at the end of the outermost point of a line that touches at the largest force, or,
    where the edge is inside there, of the point between it and the next one at which a linear gap is zero (so ends a
    contact within faces); 0 if none touches. The points of a line by their undeformed distance from the axis."""
    touching = [place for place, (pressure, _, _) in at_largest.items() if pressure > 0. and place in at_end]
    if not touching:
        return 0.
    last = max(touching)
    beyond = min((place for place in at_largest if place > last and place in at_end), default=last)
    inside, outside = at_largest[last][1], at_largest[beyond][1]
    share = inside / (inside - outside) if inside < 0. < outside else 0.
    return at_end[last][2] + share * (at_end[beyond][2] - at_end[last][2])


def lines_below_edges(run, step):
    """For each edge of the pyramid, by its number, the points of surface_profile.csv below it in this step: pressure,
    gap, and distance from the axis as it is then, by the undeformed distance."""
    position = run.numbers("Indenter/Position") or [0., 0.]
    to_edges = math.radians(run.number("Indenter/Rotation") + 45.)
    found = {}
    for row in run.table("surface_profile"):
        x, y = row["x"] - position[0], row["y"] - position[1]
        quarters = (math.atan2(y, x) - to_edges) / (0.5 * math.pi)
        if row["step"] != step or abs(math.sin(math.pi * quarters)) > 1e-6:
            continue
        found.setdefault(round(quarters) % 4, {})[math.hypot(x, y)] = (
            row["contact_pressure"], row["gap"], math.hypot(x + row["displacement_x"], y + row["displacement_y"]))
    return found


def numbers_of_run(run, millimetre, newton):
    """Name, value and unit of what the indenter of a run is made for, at the largest force, and after a hold of it at
    its end. millimetre, newton: what to multiply lengths and forces of the run by. Raises UserError."""
    row = run.history[last_of_largest(run.history["force"])]
    shape, force = run.parameters.get("Indenter/Type"), newton * row["force"] / run.modelled_part
    area = math.pi * (millimetre * row["contact_radius"]) ** 2
    if shape == "sphere":
        ball, imprint = 2. * millimetre * run.number("Indenter/Radius"), 2. * millimetre * row["contact_radius"]
        return [("force", force, "N"), ("diameter", imprint, "mm"), ("HBW", brinell(force, ball, imprint), "kgf/mm²")]
    if shape != "pyramid":
        raise UserError(f"the indenter of the run in '{run.directory}', '{shape}', has no hardness number: there are "
                        "Brinell's of a sphere, Vickers' and Martens' of a pyramid. Hardness and modulus of its "
                        "unloadings are in its indentation.csv")
    pyramid = int(run.number("Indenter/Number of faces")), run.number("Indenter/Face angle")
    depth = millimetre * (row["depth"] - run.number("Indenter/Initial gap"))
    found = [("force", force, "N"), ("HM", martens(force, depth, *pyramid), "N/mm²")]
    if pyramid == (4, VICKERS_ANGLE):
        diagonal = math.sqrt(2. * area)
        found += [("diagonal_of_area", diagonal, "mm"), ("HV_of_area", vickers(force, diagonal), "kgf/mm²")]
        residual = residual_diagonal(run)
        if residual is not None:
            residual *= millimetre
            found += [("residual_diagonal", residual, "mm"), ("HV", vickers(force, residual), "kgf/mm²")]
    return found


def show(run, millimetre, newton):
    lines = [f"{name},{value:.6g},{unit}" for name, value, unit in numbers_of_run(run, millimetre, newton)]
    print("quantity,value,unit", *lines, sep="\n")
    return 0
