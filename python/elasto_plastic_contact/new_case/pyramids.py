# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pyramids: Berkovich, Vickers, the corner of a cube. The smallest sector that symmetry allows is computed, with
finite strains and a mesh whose cells grow with the distance from the tip."""

import math
from dataclasses import dataclass

from ..pyramids import PYRAMIDS as STANDARD
from ..pyramids import area_factor
from .case import Case
from .contact import STICK, STRAIN_OF_SLOPE, Tip, depth_at, expected_radius
from .revolution import set_friction, set_materials, units_of
from .rules import BODY_OVER_CONTACT, FINENESS, describe_steps, rounded, set_elements, set_output
from .units import text_of


# Under the corner of a cube, a run becomes difficult from that depth over the radius of the tip on, unless the ratio of the
# plane strain modulus to the stress at the representative strain is below the second number: it is 16 in fused silica, which
# is easy, and 46 in polycarbonate, where a run hardly comes to seven radii (doc/lookup/new_cases.md).
DEEP_CORNER, ELASTIC_CORNER = 1.5, 25.


@dataclass(frozen=True)
class Pyramid:
    """face_angle: between axis and faces, in degrees. friction: unless told, a coefficient or STICK; 0: none."""
    title: str
    n_faces: int
    face_angle: float
    friction: float | str = 0.

    @property
    def tip(self):
        """The cone of the same area."""
        return Tip(None, math.sqrt(math.pi / area_factor(self.n_faces, self.face_angle)))


PYRAMIDS = {
    "berkovich": Pyramid("Berkovich's pyramid", *STANDARD["berkovich"]),
    "vickers": Pyramid("Vickers' pyramid", *STANDARD["vickers"]),
    # (Where the surface slides, elements beside such a sharp edge collapse: doc/lookup/new_cases.md.)
    "cube-corner": Pyramid("the corner of a cube", *STANDARD["cube_corner"], STICK),
}


def indentation(kind, given):
    """By depth or force, and the unloading."""
    pyramid = PYRAMIDS[kind]
    tip = Tip(given.tip_radius, pyramid.tip.slope)
    case = Case(f"{pyramid.title[0].upper()}{pyramid.title[1:]} pressed into {given.material.name} and unloaded: "
                f"1/{2 * pyramid.n_faces} "
                "of the body", units_of(given, tip))
    radius = expected_radius(tip, [given.material], depth=given.depth, force=given.force)
    fineness = FINENESS[given.mesh]
    unit = case.units.length_unit
    case.chosen["contact radius"] = (f"about {case.units.length(radius):.3g} {unit} at the largest load, of the circle "
                                     "with the same "
                                     "area (an estimate, for the mesh)")
    case.chosen["strain"] = "finite: a pyramid turns the surface beside it far beyond small strains"
    case.set("", "Dimension", 3)
    case.set("", "Strain", "logarithmic")
    set_sector(case, 180. / pyramid.n_faces, radius, fineness)
    set_materials(case, [given.material], None)
    set_pyramid(case, pyramid, given)
    set_friction(case, given, pyramid.friction)
    end = set_loading(case, pyramid, given, fineness)
    set_elements(case)
    case.set("Refinement", "Strategy", "none")
    set_output(case, f"1, {end}")
    case.remarks += [f"Forces and areas of history.csv are those of the part: times {2 * pyramid.n_faces} for the "
                     "whole.",
                     "Hardness and modulus: indentation.csv."]
    case.kind_of_time = "corner of a cube" if kind == "cube-corner" else "pyramid"
    if kind == "cube-corner":
        warn_of_deep_corner(case, tip, given, radius)
    return case


def warn_of_deep_corner(case, tip, given, radius):
    """radius: of the contact, in µm."""
    material = given.material
    depth = given.depth or depth_at(tip, material, radius)
    if (material.is_elastic or depth <= DEEP_CORNER * given.tip_radius
            or material.plane_strain_modulus <= ELASTIC_CORNER * material.stress(STRAIN_OF_SLOPE * tip.slope)):
        return
    safe = f"{text_of(case.units.length(DEEP_CORNER * given.tip_radius))} {case.units.length_unit}"
    case.chosen["difficult"] = (f"{depth / given.tip_radius:.2g} radii of the tip, beside a corner that is so sharp, in a "
                                "body that yields so easily: the run may take several times as long as estimated, or end "
                                f"before. Choose a --depth of {safe} at most, a larger --tip-radius, or 'berkovich'")


def set_sector(case, angle, radius, fineness):
    """radius: of the contact, in µm."""
    core = rounded(0.25 * case.units.length(radius))
    size = core * 2 ** math.ceil(math.log2(4 * BODY_OVER_CONTACT))
    n = fineness.sector_refinements
    case.set("Geometry", "Type", "sector", "the smallest part that symmetry allows")
    case.set("Geometry", "Sector angle", text_of(angle))
    case.set("Geometry", "Radius", text_of(size))
    case.set("Geometry", "Height", text_of(size))
    case.set("Geometry", "Core radius", text_of(core), "a quarter of the largest radius of the contact")
    case.set("Geometry", "Initial refinements", n)
    case.set("Boundary conditions", "Fixed", "bottom")
    case.set("Boundary conditions", "Roller", "front, back", "the planes of symmetry")
    case.set("Boundary conditions", "Free", "side")
    case.set("Boundary conditions", "Contact", "top")
    case.chosen["mesh"] = (f"a sector of {text_of(angle)} degrees, cells that grow with the distance from the tip: "
                           f"{2 ** n} to {2 ** (n + 1)} over the radius, at every depth")
    case.chosen["body"] = (f"{text_of(size)} {case.units.length_unit} in radius and height, about "
                           f"{size / (4 * core):.0f} contact radii")


def set_pyramid(case, pyramid, given):
    case.set("Indenter", "Type", "pyramid")
    case.set("Indenter", "Number of faces", pyramid.n_faces)
    case.set("Indenter", "Face angle", text_of(pyramid.face_angle), "degrees, axis to faces")
    case.set("Indenter", "Rotation", text_of(180. / pyramid.n_faces), "an edge in the plane y = 0")
    if given.tip_radius is not None:
        case.set("Indenter", "Rounding radius", text_of(case.units.length(given.tip_radius)))
    case.set("Indenter", "Position", "0, 0")


def set_loading(case, pyramid, given, fineness):
    """Short steps first while few nodes touch: a tenth of the depth in the first fifth of the steps; of the force, a
    hundredth. The unloading has steps enough for the law of Oliver and Pharr. Returns its end."""
    steps = fineness.sector_steps
    n_unloading = max(steps // 5, 8)
    if given.force is None:
        parts = [f"depth {text_of(part * case.units.length(given.depth))}" for part in (0.1, 0.35, 1.)]
    else:
        parts = [f"force {text_of(part * case.units.force(given.force) / (2 * pyramid.n_faces))}" for part in (0.01,
                                                                                                               0.12,
                                                                                                               1.)]
    rows = [f"{time}: {part}" for time, part in zip(("0.2", "0.5", "1"), parts)]
    end = text_of(1. + n_unloading / steps)
    case.set("Loading", "History", " | ".join([*rows, f"{end}: force 0"]), "(short steps first, while few nodes touch)")
    case.set("Loading", "Number of steps", steps + n_unloading, f"{steps} of them load")
    case.set("Loading", "Integration", "BDF2", "of second order in the length of the steps")
    describe_steps(case, steps, n_unloading)
    return end
