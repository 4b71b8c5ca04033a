# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tests with an axisymmetric tip: Brinell, Rockwell with a ball, sphere, cone, coating. Half a section of the body is
computed; forces and areas are those of the whole."""

import math

from .case import Case
from .contact import STICK, Tip, cone, expected_radius, force_at
from .rules import (FINENESS, describe_steps, fixed_mesh, following_mesh, needs_finite_strains, set_elements,
                    set_output, set_strain, set_supports_of_section)
from .units import MILLIMETRES, text_of, units_for
from ..errors import UserError

STANDARD_GRAVITY = 9.80665  # N/kgf

# Force over the square of the ball's diameter in kgf/mm², and the largest imprint over that diameter (ISO 6506-1).
BRINELL_RATIOS = (30., 15., 10., 5., 2.5, 1.)
LARGEST_IMPRINT = 0.6

# Scale: diameter of the ball in mm, total force in kgf; the preliminary force is 10 kgf (ISO 6508-1).
ROCKWELL_SCALES = {"B": (1.5875, 100.), "E": (3.175, 100.), "F": (1.5875, 60.), "G": (1.5875, 150.), "H": (3.175, 60.),
                   "K": (3.175, 150.)}
PRELIMINARY_FORCE = 10.  # kgf

# Values of entries that would count: a law 'nonlinear hardening' uses all of them.
NOT_USED = {"Power law exponent": "0", "Hardening table": "none", "Voce stress": "0", "Voce rate": "0",
            "Isotropic hardening modulus": "0"}

BERKOVICH_CONE = 70.3  # degrees; it has the area of Berkovich's and Vickers' pyramid

# The time at which it has unloaded, in half as many steps as it takes to load, to 1.
UNLOADED = 1.5


def newtons(kilograms_force):
    """In mN."""
    return 1e3 * STANDARD_GRAVITY * kilograms_force


def part_of_history(case, depth, force):
    """The goal as a row of 'Loading/History'."""
    if force is None:
        return f"depth {text_of(case.units.length(depth))}"
    return f"force {text_of(case.units.force(force))}"


def set_materials(case, materials, film):
    """The substrate first. film: its thickness in µm, or None."""
    if film is not None:
        case.set("Geometry", "Material id", f"if(y > -{text_of(case.units.length(film))}, 1, 0)",
                 "1: the film, 0: what is below it")
    columns = [material.entries(case.units) for material in materials]
    for name in dict.fromkeys(name for column in columns for name in column):
        # (An entry that a law does not use has the value of the other material, or the default.)
        known = next(column[name] for column in columns if name in column)
        values = [column.get(name, NOT_USED.get(name, known)) for column in columns]
        case.set("Material", name, ", ".join(values[:1] if len(set(values)) == 1 else values))
    for material in materials:
        case.remarks += [f"Material{' of the film' if len(materials) > 1 and material is materials[-1] else ''}: "
                         f"{material.name}, {material.description}.",
                         f"  elastic constants: {material.elastic_source}"]
        if not material.is_elastic:
            case.remarks.append(f"  yield stress and hardening ({material.hardening}): {material.plastic_source}")
    if materials[0].is_elastic:
        case.chosen["plasticity"] = "none: linear elastic; --yield-stress makes it yield"


def set_tip(case, tip):
    if tip.slope is None:
        case.set("Indenter", "Type", "sphere")
    else:
        case.set("Indenter", "Type", "cone" if tip.radius is None else "spheroconical tip")
    if tip.radius is not None:
        case.set("Indenter", "Radius", text_of(case.units.length(tip.radius)))
    if tip.slope is not None:
        case.set("Indenter", "Semi-apex angle", text_of(math.degrees(math.atan(1. / tip.slope))),
                 "degrees, axis to flank")
    case.set("Indenter", "Position", 0, "on the axis")


def indentation(case, tip, given, *, depth=None, force=None, rows=None, goal=None):
    """The body, its mesh, the tip and the loading of an axisymmetric test. depth or force: the largest one; rows:
    those of 'Loading/History', if it is not a loading and an unloading; goal: see expected_radius(). Returns the
    expected contact radius in µm."""
    film = given.film
    materials = [given.material] if film is None else [given.material, film.material]
    radius = expected_radius(tip, materials, depth=depth, force=force, goal=goal)
    slope = tip.slope_at(radius)
    fineness = FINENESS[given.mesh]
    is_finite = needs_finite_strains(slope)
    case.set("", "Dimension", 2)
    case.set("", "Kinematics", "axisymmetric")
    unit = case.units.length_unit
    case.chosen["contact radius"] = (f"about {case.units.length(radius):.3g} {unit} at the largest load (an estimate, "
                                     "for the mesh)")
    set_strain(case, is_finite, slope)
    is_following = not is_finite and film is None
    if is_following:
        following_mesh(case, radius, fineness)
    else:
        fixed_mesh(case, radius, fineness, None if film is None else film.thickness)
    set_supports_of_section(case)
    set_materials(case, materials, None if film is None else film.thickness)
    set_tip(case, tip)
    set_friction(case, given)
    n_loading = fineness.finite_steps if is_finite else fineness.small_steps
    n_unloading = n_loading // 2
    history = rows or f"1: {part_of_history(case, depth, force)} | {UNLOADED}: force 0"
    case.set("Loading", "History", history)
    case.set("Loading", "Number of steps", n_loading + n_unloading, f"{n_loading} of them load")
    if is_finite:
        case.set("Loading", "Integration", "BDF2", "of second order in the length of the steps")
    describe_steps(case, n_loading, n_unloading)
    set_elements(case)
    case.set("Refinement", "Strategy", "none")
    if is_following:
        case.set("Refinement", "Elements over contact radius", fineness.n_following)
    set_output(case, history_times(history))
    case.kind_of_time = "finite strains, plane" if is_finite else "small strains, plane"
    return radius


def history_times(history):
    return ", ".join(row.partition(":")[0].strip() for row in history.split("|"))


def set_friction(case, given, unless_told=0.):
    """given.friction, unless_told: coefficients, or STICK."""
    chosen = unless_told if given.friction is None else given.friction
    if chosen != 0.:
        text = chosen if chosen == STICK else text_of(chosen)
        case.set("Contact", "Friction coefficient", text)
        case.chosen["friction"] = f"{text}{'' if given.friction is not None else ', unless told'}"


def brinell(given):
    """A Brinell test by force."""
    diameter = 1e4 if given.ball is None else given.ball
    tip = Tip(0.5 * diameter)
    force = given.force if given.force is not None else brinell_force(tip, given.material)
    case = Case(f"A Brinell test of {given.material.name}: a ball of {text_of(1e-3 * diameter)} mm and "
                f"{text_of(1e-3 * force)} N", MILLIMETRES)
    ratio = 1e-3 * force / STANDARD_GRAVITY / (1e-3 * diameter) ** 2
    reason = ", the largest of ISO 6506-1 whose imprint stays within " + text_of(LARGEST_IMPRINT) + " diameters"
    case.chosen["force"] = (f"{text_of(1e-3 * force)} N, {ratio:.3g} kgf/mm² times the square of the diameter" +
                            (reason if given.force is None else ""))
    radius = indentation(case, tip, given, force=force,
                         goal="--force" if given.force is not None else "the standard force")
    estimate = 2. * 1e-3 * force / STANDARD_GRAVITY / (
        math.pi * 2e-3 * tip.radius * (2e-3 * tip.radius - 2e-3 * math.sqrt(tip.radius ** 2 - radius ** 2)))
    case.remarks += ["Brinell hardness: HBW = 0.102 * 2 F / (pi D (D - sqrt(D^2 - d^2))), d = 2 contact_radius of "
                     "history.csv at t = 1,",
                     f"  D = {text_of(1e-3 * diameter)}, F = {text_of(1e-3 * force)}; about {estimate:.3g} is expected "
                     "(mean pressure = 2.8 times the stress at 0.2 d/D)."]
    return case


def brinell_force(tip, material):
    """The largest of the standard ones whose imprint is not too large, in mN. Raises UserError if there is none."""
    largest = force_at(tip, material, LARGEST_IMPRINT * tip.radius)
    forces = [newtons(ratio * (2e-3 * tip.radius) ** 2) for ratio in BRINELL_RATIOS]
    fitting = [force for force in forces if force <= largest]
    if not fitting:
        raise UserError(f"no force of ISO 6506-1 leaves an imprint within {text_of(LARGEST_IMPRINT)} diameters of the "
                        f"ball in {material.name}: the least one is {text_of(1e-3 * forces[-1])} N, and "
                        f"{1e-3 * largest:.3g} N are enough. Give --force")
    return max(fitting)


def rockwell_ball(given):
    """Rockwell with a ball: preliminary force, total force, and the preliminary one again."""
    scale = given.scale or "B"
    diameter, total = ROCKWELL_SCALES[scale]
    case = Case(f"A Rockwell test of {given.material.name}, scale {scale}: a ball of {diameter} mm, 10 and {total:g} "
                "kgf", MILLIMETRES)
    preliminary, force = (text_of(case.units.force(newtons(value))) for value in (PRELIMINARY_FORCE, total))
    case.chosen["force"] = f"{preliminary} N, {force} N, {preliminary} N (ISO 6508-1, scale {scale})"
    indentation(case, Tip(500. * diameter), given, force=newtons(total), goal=f"the force of the scale {scale}",
                rows=f"0.2: force {preliminary} | 1: force {force} | {UNLOADED}: force {preliminary}")
    case.remarks += [f"Rockwell hardness: HR{scale}W = 130 - (depth at t = {UNLOADED} - depth at t = 0.2) / 0.002, depths of "
                     "history.csv in mm."]
    return case


def sphere(given):
    """A sphere, by depth or force, and its unloading."""
    tip = Tip(given.tip_radius)
    case = Case(f"A sphere of the radius {text_of(units_for(given.tip_radius).length(given.tip_radius))} "
                f"{units_for(given.tip_radius).length_unit} pressed into {given.material.name} and unloaded",
                units_of(given, tip))
    indentation(case, tip, given, depth=given.depth, force=given.force)
    add_indentation_remarks(case)
    return case


def units_of(given, tip):
    """Those of the depth, or of the contact radius under a force."""
    if given.depth is not None:
        return units_for(given.depth)
    return units_for(0.1 * expected_radius(tip, [given.material], force=given.force))


def add_indentation_remarks(case):
    case.remarks += ["Results: force, depth and contact radius in history.csv; hardness and modulus in",
                     "  indentation.csv; the imprint in surface_profile.csv."]


def cone_test(given):
    """A cone, sharp or with a spherical cap, by depth or force, and its unloading."""
    angle = BERKOVICH_CONE if given.angle is None else given.angle
    tip = Tip(given.tip_radius, cone(angle).slope)
    case = Case(f"A cone of {text_of(angle)} degrees pressed into {given.material.name} and unloaded",
                units_of(given, tip))
    indentation(case, tip, given, depth=given.depth, force=given.force)
    add_indentation_remarks(case)
    return case


def coating(given):
    """A film on a substrate under a cone, whose angle is that of Berkovich's pyramid unless told, or a sphere."""
    if given.ball is not None and (given.angle is not None or given.tip_radius is not None):
        raise UserError("--ball has neither --angle nor --tip-radius, which are those of a cone: leave these out, or "
                        "--ball")
    if given.ball is not None:
        tip, name = Tip(0.5 * given.ball), "a ball"
    else:
        angle = BERKOVICH_CONE if given.angle is None else given.angle
        tip, name = Tip(given.tip_radius, cone(angle).slope), f"a cone of {text_of(angle)} degrees"
    units = units_of(given, tip)
    case = Case(f"A film of {text_of(units.length(given.film.thickness))} {units.length_unit} on {given.material.name} "
                f"under {name}", units)
    indentation(case, tip, given, depth=given.depth, force=given.force)
    law = ("linear elastic, as --film names no yield stress ('2 um, 400 GPa, 8 GPa' would); "
           if given.film.material.is_elastic else "")
    case.chosen["film"] = (f"{law}its lower side is a line of the mesh; farther out, where cells are larger than it, the film "
                           "is left out")
    add_indentation_remarks(case)
    return case

