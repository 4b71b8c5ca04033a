# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A test of the material alone, and limit loads of punches."""

import math

from .case import Case
from .revolution import set_materials
from .rules import set_supports_of_section
from .units import MILLIMETRES, text_of, units_for
from ..errors import UserError

STEPS_OF_TENSION = 40
STEPS_OF_RAMP = 20
BODY_OVER_PUNCH = 10  # a block so many times as wide as the punch bears as much as a half space
MESHES_OF_PUNCH = {"coarse": 6, "usual": 9, "fine": 11}


def material_test(given):
    """A bar under uniaxial stress, in tension, or cycles of the strain. One cell: stress and strain are the same
    everywhere."""
    strain = 0.1 if given.strain is None else given.strain
    cycles = given.cycles or 0
    case = Case(f"A bar of {given.material.name} in {'cycles of' if cycles else 'tension, to'} the strain "
                f"{text_of(strain)}", MILLIMETRES)
    final_time = 4 * cycles if cycles else 1
    # (The second is a wave of triangles: 0, 1, 0, -1, 0 at t = 0, 1, 2, 3, 4.)
    way = "2/pi*asin(sin(pi/2*t))" if cycles else "t"
    case.set("", "Dimension", 3)
    case.set("", "Strain", "logarithmic", "true stresses over logarithmic strains, as hardening laws are measured")
    case.set("Geometry", "Type", "box", "a cube of the side 1: one cell")
    case.set("Boundary conditions", "Roller", "left, front, bottom", "free to become thinner")
    case.set("Boundary conditions", "Free", "right, back")
    case.set("Boundary conditions", "Prescribed displacement", f"top: free; free; exp({text_of(strain)}*({way})) - 1",
             "the logarithmic strain goes with the time")
    set_materials(case, [given.material], None)
    case.set("Indenter", "Type", "none")
    case.set("Loading", "Final time", final_time)
    n_steps = STEPS_OF_RAMP * final_time if cycles else STEPS_OF_TENSION
    case.set("Loading", "Number of steps", n_steps)
    case.set("Output", "Fields", "never")
    case.set("Output", "Probe points", "bar: 1, 1, 1")
    case.set("Output", "Length unit", "mm")
    case.set("Output", "Force unit", "N")
    case.chosen["mesh"] = "one cell, in which uniaxial stress is exact"
    case.chosen["strain"] = (f"finite (logarithmic), "
                             f"{'between -' + text_of(strain) + ' and ' if cycles else 'to '}{text_of(strain)}")
    case.chosen["steps"] = f"{n_steps}; the stress of isotropic hardening does not depend on their number"
    case.remarks += ["Stress over strain: bar_stress_zz and bar_strain_zz of probes.csv, or 'epc plot stress_strain "
                     "DIRECTORY'.",
                     "  Nominal stress: top_z of reactions.csv."]
    case.kind_of_time = "one cell"
    return case


def limit_load(given):
    """A flat punch on a perfectly plastic body, between two rigorous bounds."""
    material = given.material
    if material.is_elastic:
        raise UserError(f"'{material.name}' has no yield stress, and a limit load is what a material yields at: give "
                        "--yield-stress")
    punch = given.punch or "strip"
    radius = given.half_width
    units = units_for(0.1 * radius)
    case = Case(f"The limit load of a flat {punch} punch on {material.name}, between two bounds", units)
    size = BODY_OVER_PUNCH * units.length(radius)
    case.set("", "Dimension", 2)
    case.set("", "Kinematics", "plane strain" if punch == "strip" else "axisymmetric")
    case.set("", "Analysis", "limit load")
    case.set("Geometry", "Type", "box")
    case.set("Geometry", "Lower corner", f"0, -{text_of(size)}")
    case.set("Geometry", "Upper corner", f"{text_of(size)}, 0")
    case.set("Geometry", "Repetitions", f"{BODY_OVER_PUNCH}, {BODY_OVER_PUNCH}",
             "a vertex lies at the edge of the punch")
    set_supports_of_section(case)
    set_perfectly_plastic(case, material)
    width = text_of(units.length(radius))
    if punch == "strip":
        case.set("Indenter", "Type", "strip punch")
        case.set("Indenter", "Half width", width)
    else:
        case.set("Indenter", "Type", "circular punch")
        case.set("Indenter", "Radius", width)
    case.set("Indenter", "Position", 0)
    case.set("Indenter", "Surface", "smooth", "or rough: the body does not slide along it")
    set_refinement_of_bounds(case, MESHES_OF_PUNCH[given.mesh])
    exact = ((2. + math.pi) / math.sqrt(3.) if punch == "strip" else 3.014) * units.stress(material.yield_stress)
    case.chosen["body"] = (f"{text_of(size)} {units.length_unit} wide and deep, {BODY_OVER_PUNCH} times the punch: it "
                           "bears as much as a half space")
    case.chosen["mesh"] = f"{MESHES_OF_PUNCH[given.mesh]} meshes, refined where the bounds disagree"
    known = (f"{exact:.5g} {units.stress_unit}, "
             f"{'2 + pi times the shear yield stress (Prandtl)' if punch == 'strip' else '3.014 yield stresses'}")
    half = " (on this half model, per unit of thickness)" if punch == "strip" else ""
    case.remarks += [f"Known for a half space: the mean pressure {known}.",
                     f"limit_load.csv has a lower and an upper bound of the force{half}."]
    case.kind_of_time = f"{punch} punch, {given.mesh}"
    return case


def set_perfectly_plastic(case, material):
    """With the yield stress alone: a limit load knows no hardening."""
    case.set("Material", "Law", "perfectly plastic")
    for name in ("Young's modulus", "Poisson's ratio", "Yield stress"):
        case.set("Material", name, material.entries(case.units)[name])
    case.remarks += [f"Material: {material.name}, {material.description}; its hardening is left out.",
                     f"  yield stress: {material.plastic_source}"]


def set_refinement_of_bounds(case, n_meshes):
    case.set("Refinement", "Strategy", "adaptive")
    case.set("Refinement", "Number of cycles", n_meshes)
    case.set("Refinement", "Refinement fraction", 0.1)
    case.set("Refinement", "Coarsening fraction", 0)
    case.set("Output", "Length unit", case.units.length_unit)
    case.set("Output", "Force unit", case.units.force_unit)
