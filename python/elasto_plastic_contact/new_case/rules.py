# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mesh, steps and strains that suit a contact: the rules of doc/lookup/new_cases.md, which gives their reasons and the
errors that they leave."""

import math
from dataclasses import dataclass

from .units import text_of
from ..errors import UserError

# Up to this slope of the surface at the edge of the contact, small strains are good for the force to 3 %.
LARGEST_SLOPE_OF_SMALL_STRAINS = 0.25

# The body reaches at least so many contact radii down and outwards.
BODY_OVER_CONTACT = 100

# The part with the smallest cells reaches so many expected contact radii far, since pile-up widens contacts.
FINE_OVER_CONTACT = 1.5

# A film so thin that its cells are more over the expected contact radius takes hours, and bears nothing that counts.
MOST_OVER_CONTACT = 400


@dataclass(frozen=True)
class Fineness:
    """n_over_radius: elements over the contact radius of meshes made beforehand (finite strains); n_following: of
    those that follow the contact (small strains), which have four times as many at its edge; steps of the loading with
    small strains and, of second order, with finite ones; sector_refinements: of the sectors of pyramids, with 2^n to
    2^(n+1) elements over the radius; scratch_over_radius: elements over the radius of a scratch."""
    n_over_radius: int
    n_following: int
    small_steps: int
    finite_steps: int
    sector_refinements: int
    sector_steps: int
    scratch_over_radius: int


FINENESS = {
    "coarse": Fineness(8, 10, 20, 20, 2, 20, 3),
    "usual": Fineness(16, 20, 40, 30, 3, 40, 4),
    "fine": Fineness(32, 40, 80, 60, 4, 80, 6),
}


def rounded(value, digits=2):
    """With so many digits that count."""
    return float(f"{value:.{digits - 1}e}")


def needs_finite_strains(slope):
    return slope > LARGEST_SLOPE_OF_SMALL_STRAINS


def set_half_section(case, width):
    """The body of revolution, as wide as deep; width as in the file."""
    case.set("Geometry", "Type", "box")
    case.set("Geometry", "Lower corner", f"0, -{text_of(width)}", "r and the height; the body ends at this depth")
    case.set("Geometry", "Upper corner", f"{text_of(width)}, 0", "the top is at the height 0")


def set_supports_of_section(case):
    case.set("Boundary conditions", "Fixed", "bottom")
    case.set("Boundary conditions", "Roller", "left", "the axis")
    case.set("Boundary conditions", "Free", "right")
    case.set("Boundary conditions", "Contact", "top")


def following_mesh(case, radius, fineness):
    """For small strains: a coarse mesh, refined where the contact is as it grows. radius: of the contact, in µm."""
    width = rounded(case.units.length(2 * BODY_OVER_CONTACT * radius))
    set_half_section(case, width)
    case.set("Geometry", "Initial refinements", 4, "the mesh that follows the contact begins with these cells")
    case.chosen["mesh"] = (f"follows the contact with {fineness.n_following} elements over its radius and four times "
                           "as many per length at its edge")
    case.chosen["body"] = (f"{text_of(width)} {case.units.length_unit} wide and deep, about {2 * BODY_OVER_CONTACT} "
                           "contact radii")


def parts_of_film(film, radius, size):
    """How many of the smallest cells a film is thick, at least film / size: a multiple of four of the cells that are
    there at its lower side, so that it ends at a line of the mesh also farther out. Lengths in the same unit."""
    doublings = max(0, math.ceil(math.log2(film / (FINE_OVER_CONTACT * radius))))
    multiple = 4 * 2 ** doublings
    return multiple * math.ceil(film / (multiple * size))


def check_film(case, film, radius, size):
    """Refuses one whose cells are too small for the contact. Lengths in µm."""
    if radius / size > MOST_OVER_CONTACT:
        unit = case.units.length_unit
        raise UserError(f"--film is {case.units.length(film):.3g} {unit} thick, and the radius of the contact about "
                        f"{case.units.length(radius):.3g} {unit}: {radius / size:.0f} cells would lie over it, where "
                        f"at most {MOST_OVER_CONTACT} are allowed. Leave --film out, since so thin a film hardly "
                        "counts, or give a thicker one, or a smaller depth, force or ball")


def fixed_mesh(case, radius, fineness, film=None):
    """For finite strains and films: square cells of one size up to 1.5 contact radii, outside of that twice as large
    with each
    doubling of the distance. radius: of the contact, in µm; film: its thickness in µm, of which cells are a whole
    part. Raises UserError: of too thin a film."""
    n = fineness.n_over_radius
    size = radius / n
    if film is not None:
        size = film / parts_of_film(film, radius, size)
        check_film(case, film, radius, size)
    size = case.units.length(size)
    size = rounded(size) if film is None else float(f"{size:.6g}")
    contact = case.units.length(radius)
    n_refinements = math.ceil(math.log2(BODY_OVER_CONTACT * contact / size))
    n_initial = 4
    n_local = n_refinements - n_initial
    width = size * 2 ** n_refinements
    set_half_section(case, width)
    case.set("Geometry", "Initial refinements", n_initial)
    case.set("Geometry", "Local refinements", n_local, f"the smallest cells measure {text_of(size)}")
    case.set("Geometry", "Local radius", text_of(rounded(FINE_OVER_CONTACT * contact * 2 ** (n_local - 1), 3)),
             f"they reach {FINE_OVER_CONTACT} contact radii far")
    unit = case.units.length_unit
    case.chosen["mesh"] = (f"square cells of {text_of(size)} {unit} up to {FINE_OVER_CONTACT} contact radii, "
                           f"{contact / size:.0f} over the radius")
    case.chosen["body"] = f"{text_of(width)} {unit} wide and deep, {width / contact:.0f} contact radii"


def set_strain(case, is_finite, slope):
    if is_finite:
        case.set("", "Strain", "logarithmic")
    limit = LARGEST_SLOPE_OF_SMALL_STRAINS
    case.chosen["strain"] = (f"{'finite' if is_finite else 'small'}: the tip has the slope {slope:.2g} at the edge of "
                             "the contact, "
                             f"{'more' if is_finite else 'less'} than {limit}")


def set_elements(case):
    case.set("Discretization", "Polynomial degree", 1)
    case.set("Discretization", "Volumetric treatment", "B-bar", "linear elements lock without it")


def set_output(case, field_times):
    case.set("Output", "Fields", "at times")
    case.set("Output", "Field times", field_times)
    case.set("Output", "Length unit", case.units.length_unit)
    case.set("Output", "Force unit", case.units.force_unit)


def describe_steps(case, n_loading, n_unloading):
    case.chosen["steps"] = f"{n_loading} to load, {n_unloading} to unload"
