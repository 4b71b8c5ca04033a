# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tests that need a body in space: a scratch, a rough surface."""

import math
import pathlib
from dataclasses import dataclass

from .case import Case
from .contact import STICK, Tip, cone, expected_radius
from .revolution import set_friction, set_materials, set_tip
from .rules import FINENESS, describe_steps, needs_finite_strains, rounded, set_elements, set_output, set_strain
from .units import text_of, units_for
from ..errors import UserError
from .rough_surface import rough_surface

# Of a scratch: steps of the way for each contact radius, and contact radii around the way that are meshed finely, and
# the body's.
STEPS_OF_WAY = 12
FINE_AROUND_WAY = 2.5
BODY_AROUND_WAY = 4.5

# Of a rough surface: heights along each side, the waves that they are made of (wave numbers per side), and Hurst's
# exponent.
N_HEIGHTS, LONGEST, SHORTEST, HURST = 65, 2, 12, 0.8
SEED = 1978
N_COARSE = 16  # cells of the coarse mesh along each side


@dataclass(frozen=True)
class Surface:
    """A measured height map: its file, and whether that is an image or a matrix of numbers."""
    path: pathlib.Path
    is_image: bool


def scratch(given):
    """A sphere or cone with a spherical cap: pressed in, drawn along the surface, lifted. A half of the body. Raises
    UserError."""
    if given.friction == STICK:
        raise UserError(f"--friction is '{STICK}', with which no tip is drawn along a surface: give a coefficient")
    slope = None if given.angle is None else cone(given.angle).slope
    tip = Tip(given.tip_radius, slope)
    units = units_for(given.depth)
    case = Case(f"A scratch in {given.material.name}: a tip of the radius {text_of(units.length(given.tip_radius))} "
                f"{units.length_unit} pressed "
                f"in, drawn along the surface and lifted", units)
    radius = expected_radius(tip, [given.material], depth=given.depth)
    fineness = FINENESS[given.mesh]
    length = 3. * radius if given.length is None else given.length
    tip_slope = tip.slope_at(radius)
    is_finite = needs_finite_strains(tip_slope)
    unit = units.length_unit
    case.chosen["contact radius"] = f"about {units.length(radius):.3g} {unit} (an estimate, for the mesh)"
    case.set("", "Dimension", 3)
    set_strain(case, is_finite, tip_slope)
    set_block_around(case, radius, length, fineness)
    set_materials(case, [given.material], None)
    set_tip(case, tip)
    case.sections["Indenter"][-1] = ("Position", "0, 0", "where the way begins")
    set_friction(case, given)
    set_way(case, given, radius, length)
    set_elements(case)
    case.set("Refinement", "Strategy", "none")
    set_output(case, "1, 4, 5")
    case.remarks += ["A half of the body, cut along the scratch: forces are half of the whole.",
                     "Friction of the scratch: tangential_force_x over force of history.csv."]
    case.kind_of_time = "finite strains, space" if is_finite else "small strains, space"
    return case


def set_block_around(case, radius, length, fineness):
    """A half of a block around the way, with small cells within some contact radii of it. Lengths in µm."""
    n_local = 2
    cell = rounded(case.units.length(radius) / fineness.scratch_over_radius) * 2 ** n_local
    reach = case.units.length(BODY_AROUND_WAY * radius)
    way = case.units.length(length)
    n_behind = math.ceil(reach / cell)
    n_ahead = math.ceil((way + reach) / cell)
    corner = text_of(n_behind * cell)
    case.set("Geometry", "Type", "box")
    case.set("Geometry", "Lower corner", f"-{corner}, 0, -{corner}")
    case.set("Geometry", "Upper corner", f"{text_of(n_ahead * cell)}, {corner}, 0")
    case.set("Geometry", "Repetitions", f"{n_behind + n_ahead}, {n_behind}, {n_behind}")
    case.set("Geometry", "Local refinements", n_local, f"the smallest cells measure {text_of(cell / 2 ** n_local)}")
    fine = case.units.length(FINE_AROUND_WAY * radius) + 0.5 * way
    case.set("Geometry", "Local radius", text_of(rounded(2 ** (n_local - 1) * fine, 3)))
    case.set("Geometry", "Local centre", f"{text_of(0.5 * way)}, 0, 0", "the middle of the way")
    case.set("Boundary conditions", "Fixed", "bottom")
    case.set("Boundary conditions", "Roller", "front", "the plane of symmetry")
    case.set("Boundary conditions", "Free", "left, right, back")
    case.set("Boundary conditions", "Contact", "top")
    unit = case.units.length_unit
    case.chosen["mesh"] = (f"cubes of {text_of(cell / 2 ** n_local)} {unit} around the way, "
                           f"{fineness.scratch_over_radius} over the contact radius")
    case.chosen["body"] = (f"{BODY_AROUND_WAY} contact radii around the way: a larger one changes the force by less "
                           "than the mesh does")


def set_way(case, given, radius, length):
    """Pressed in until t = 1, drawn until t = 4, lifted until t = 5."""
    depth = text_of(case.units.length(given.depth))
    case.set("Loading", "History", f"1: depth {depth} | 4: depth {depth} | 5: force 0")
    case.set("Loading", "Path", f"1: 0, 0 | 4: {text_of(case.units.length(length))}, 0")
    n_way = max(12, math.ceil(STEPS_OF_WAY * length / radius))
    n_third = math.ceil(n_way / 3)
    case.set("Loading", "Number of steps", 5 * n_third)
    case.chosen["steps"] = (f"{n_third} to press, {3 * n_third} along the way of {text_of(case.units.length(length))} "
                            f"{case.units.length_unit}, each 1/{3 * n_third * radius / length:.0f} of the contact "
                            f"radius, {n_third} to lift")


def rough(given):
    """A rough, rigid surface pressed onto a block with symmetric sides, as one of many alike. Raises UserError."""
    check_options_of_surface(given)
    depth = 2. * given.rms if given.depth is None else given.depth
    units = units_for(0.2 * given.size)
    name = ("A measured surface" if given.surface is not None else
            f"A rough surface, {text_of(units.length(given.rms))} {units.length_unit} rms,")
    case = Case(f"{name} pressed onto {given.material.name}", units)
    side = units.length(given.size)
    n_refinements = {"coarse": 1, "usual": 2, "fine": 3}[given.mesh]
    n_cells = N_COARSE * 2 ** n_refinements
    case.set("", "Dimension", 3)
    case.set("Geometry", "Type", "box")
    case.set("Geometry", "Lower corner", f"0, 0, -{text_of(0.5 * side)}")
    case.set("Geometry", "Upper corner", f"{text_of(side)}, {text_of(side)}, 0")
    case.set("Geometry", "Repetitions", f"{N_COARSE}, {N_COARSE}, 6")
    case.set("Geometry", "Grading", 3, "the lowest cells are higher than those at the surface")
    case.set("Geometry", "Initial refinements", n_refinements, f"{n_cells} cells along each side")
    case.set("Boundary conditions", "Fixed", "bottom")
    case.set("Boundary conditions", "Roller", "left, right, front, back",
             "as if the surface went on as its mirror image")
    case.set("Boundary conditions", "Contact", "top")
    set_materials(case, [given.material], None)
    (set_random_surface if given.surface is None else set_measured_surface)(case, given, side)
    case.set("Indenter", "Size", f"{text_of(side)}, {text_of(side)}")
    case.set("Indenter", "Position", f"{text_of(0.5 * side)}, {text_of(0.5 * side)}")
    set_friction(case, given)
    n_steps = 10 if given.mesh == "coarse" else 20
    case.set("Loading", "History", f"1: depth {text_of(units.length(depth))} | 1.2: force 0")
    case.set("Loading", "Number of steps", n_steps + n_steps // 5)
    describe_steps(case, n_steps, n_steps // 5)
    set_elements(case)
    case.set("Refinement", "Strategy", "none")
    set_output(case, "1, 1.2")
    case.chosen["depth"] = f"{text_of(units.length(depth))} {units.length_unit} beyond the first contact"
    shortest = f", {n_cells / SHORTEST:.1f} to the shortest wave" if given.surface is None else ""
    case.chosen["mesh"] = f"{n_cells} cells along each side{shortest}"
    case.chosen["strain"] = "small: the slopes of rough surfaces are"
    case.remarks += ["Results: contact_area and force of history.csv; the spots: contact_pressure of surface.pvd."]
    case.kind_of_time = "small strains, space"
    return case


def check_options_of_surface(given):
    """Raises UserError: a measured surface needs its heights and how deep it is pressed, a random one has neither file
    nor scale."""
    if given.surface is None:
        if given.height_scale is not None:
            raise UserError("--height-scale is that of a measured surface: give it by --surface, or leave it out")
        return
    for name, what in (("height_scale",
                        "--height-scale '1 nm', the height of the number 1 of a matrix, or of white above black"),
                       ("depth", "--depth '500 nm', how far it goes beyond the first contact")):
        if getattr(given, name) is None:
            raise UserError(f"--surface needs {what}")
    if given.seed is not None:
        raise UserError("--seed is that of a random surface: leave it out, or --surface")


def set_measured_surface(case, given, side):
    """The height map of a file. side: of the square, as in the file of the case."""
    case.surface = given.surface.path
    case.set("Indenter", "Type", "image" if given.surface.is_image else "height matrix")
    case.set("Indenter", "File", "{surface}")
    case.set("Indenter", "Height scale", text_of(case.units.length(given.height_scale)),
             "white above black" if given.surface.is_image else "of the number 1")
    case.set("Indenter", "Side down", "light", "the peaks touch first")
    case.remarks += [f"Surface: {given.surface.path.name}, stretched over the square of the side {text_of(side)}."]


def set_random_surface(case, given, side):
    """A self-affine surface that is made and lies beside the file. side: of the square, as in the file."""
    case.set("Indenter", "Type", "height matrix")
    name = "{stem}_heights.txt"
    heights = rough_surface(N_HEIGHTS, HURST, LONGEST, SHORTEST, random_seed(given))
    mean = sum(map(sum, heights)) / N_HEIGHTS ** 2
    rms = math.sqrt(sum((h - mean) ** 2 for row in heights for h in row) / N_HEIGHTS ** 2)
    factor = case.units.length(given.rms) / rms
    case.files[name] = (f"# Heights in {case.units.length_unit}: a self-affine surface, Hurst's exponent {HURST}, "
                        f"waves of {LONGEST} to {SHORTEST} "
                        "per side, the lowest touch first\n" +
                        "".join(" ".join(text_of(factor * (h - mean)) for h in row) + "\n" for row in heights))
    case.set("Indenter", "File", name)
    case.remarks += [f"Surface: self-affine, Hurst's exponent {HURST}, waves from 1/{LONGEST} to 1/{SHORTEST} of the "
                     f"side, random phases (seed {random_seed(given)})."]


def random_seed(given):
    return SEED if given.seed is None else given.seed

