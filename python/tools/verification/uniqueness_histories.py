# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Load histories of coarse bodies that are computed in several ways; see contact_uniqueness.

Entries are numbers and tuples of them as long as they have to be scaled or mirrored; as_entries() makes text of them."""

import random
from dataclasses import dataclass, field

from .contact_law_bodies import mesh

HARDENING = {"Material/Law": "isotropic hardening", "Material/Isotropic hardening modulus": 2000}
PERFECT = {"Material/Law": "perfectly plastic"}
RECOVERING = {"Material/Law": "nonlinear hardening", "Material/Isotropic hardening modulus": 0,
              "Material/Back stress moduli": 30000, "Material/Recovery rates": 150}
FINITE = {"Strain": "logarithmic"}
QUADRATIC = {"Discretization/Polynomial degree": 2, "Discretization/Volumetric treatment": "standard"}
FRICTION = {"Contact/Friction coefficient": 0.3}
STICK = {"Contact/Friction coefficient": "stick"}
CYLINDER = {"Indenter/Type": "cylinder", "Indenter/Radius": 1}
SPHERE = {"Indenter/Type": "sphere", "Indenter/Radius": 1}
CONE = {"Indenter/Type": "cone", "Indenter/Semi-apex angle": 70.3}
WEDGE = {"Indenter/Type": "wedge", "Indenter/Semi-apex angle": 75}
TIP = {"Indenter/Type": "spheroconical tip", "Indenter/Semi-apex angle": 70.3, "Indenter/Radius": 0.1}
VICKERS = {"Indenter/Type": "pyramid", "Indenter/Number of faces": 4, "Indenter/Face angle": 68, "Indenter/Rotation": 0}
BERKOVICH = VICKERS | {"Indenter/Number of faces": 3, "Indenter/Face angle": 65.27}
FOLLOWED = {"Geometry/Initial refinements": 3, "Geometry/Local refinements": 0, "Geometry/Repetitions": (1, 1),
            "Refinement/Elements over contact radius": 6}
ALL = {
    "Strain": "small", "Material/Young's modulus": 200000, "Material/Poisson's ratio": 0.3, "Material/Yield stress": 400,
    "Discretization/Polynomial degree": 1, "Discretization/Volumetric treatment": "B-bar", "Refinement/Strategy": "none",
    "Nonlinear solver/Tolerance": 1e-12, "Loading/Maximum number of cuts": 6,
    "Loading/Integration": "backward Euler",
}


@dataclass(frozen=True)
class History:
    """kind: plane, revolution or space. heights: those of a height matrix, from the largest y on."""
    name: str
    kind: str
    entries: dict
    heights: tuple = ()
    case: str = field(init=False)

    def __post_init__(self):
        space = self.kind == "space"
        object.__setattr__(self, "case", f"indentation/{'sphere_3d' if space else 'sphere_axisymmetric'}.prm")


def pressed(depth, n_steps, part=0.04):
    """Pressed, unloaded by a part of the depth, pressed to the same depth and beyond it."""
    return {"Loading/History": ((1, "depth", depth), (1.2, "depth", (1 - part) * depth), (1.4, "depth", depth),
                                (1.6, "depth", 1.2 * depth)), "Loading/Number of steps": n_steps}


def pressed_by_force(force, n_steps):
    """The same by a force, and unloaded."""
    return {"Loading/History": ((1, "force", force), (1.2, "force", 0.5 * force), (1.4, "force", force),
                                (1.6, "force", 1.2 * force), (2, "force", 0)), "Loading/Number of steps": n_steps}


def body(radius, kind, n_elements, full=False):
    """A box around a contact of this radius; full: on both sides of x = 0."""
    dim = 3 if kind == "space" else 2
    entries = mesh(radius, n_elements, dim, side=16, n_local=4)
    # (no centre of a cell lies on the circles)
    entries["Geometry/Local radius"] *= 1.013
    left = {"Boundary conditions/Roller": ("left", "front")[:dim - 1], "Boundary conditions/Free": ("right", "back")[:dim - 1]}
    if full:
        lower, upper = entries["Geometry/Lower corner"], entries["Geometry/Upper corner"]
        entries["Geometry/Lower corner"] = (-upper[0], *lower[1:])
        first, *others = entries["Geometry/Repetitions"]
        entries["Geometry/Repetitions"] = (2 * first, *others)
        left = {"Boundary conditions/Roller": ("front",)[:dim - 2], "Boundary conditions/Free": ("left", "right", "back")[:dim]}
    kinematics = "axisymmetric" if kind == "revolution" else "plane strain"
    return ALL | entries | left | {"Kinematics": kinematics}


def history(name, kind, radius, loading, *parts, n_elements=None, full=False):
    """On the mesh for a contact radius."""
    entries = body(radius, kind, n_elements or (4 if kind == "space" else 8), full) | loading
    for part in parts:
        entries = entries | part
    return History(name, kind, entries)


def rough(name, kind, loading, *parts, seed=3):
    """A rough surface on a flat body with rollers on all sides."""
    generator, dim, n = random.Random(seed), 3 if kind == "space" else 2, 9
    heights = tuple(tuple(generator.random() for _ in range(n)) for _ in range(n if dim == 3 else 1))
    sides = ("left", "right", "front", "back")[:2 * (dim - 1)]
    entries = ALL | {
        "Geometry/Lower corner": (*((0,) * (dim - 1)), -0.5), "Geometry/Upper corner": (*((1,) * (dim - 1)), 0),
        "Geometry/Repetitions": (*((2,) * (dim - 1)), 1), "Geometry/Initial refinements": 3 if dim == 3 else 5,
        "Geometry/Local refinements": 0, "Refinement/Elements over contact radius": 0, "Kinematics": "plane strain",
        "Boundary conditions/Roller": sides, "Boundary conditions/Free": (), "Indenter/Type": "height matrix",
        "Indenter/Size": (1,) * (dim - 1), "Indenter/Position": (0.5,) * (dim - 1), "Indenter/Height scale": 0.01} | loading
    for part in parts:
        entries = entries | part
    return History(name, kind, entries, heights)


def histories():
    """All of them, by name."""
    plane, revolution, space = "plane", "revolution", "space"
    deep = pressed(0.01, 16)
    shallow = pressed(0.002, 16)
    coarse = pressed(0.004, 8)
    found = [
        history("cylinder", plane, 0.12, deep, CYLINDER, HARDENING),
        history("cylinder, no hardening", plane, 0.12, deep, CYLINDER, PERFECT),
        history("cylinder, quadratic", plane, 0.12, deep, CYLINDER, HARDENING, QUADRATIC),
        history("cylinder, friction", plane, 0.12, deep, CYLINDER, HARDENING, FRICTION),
        history("cylinder, finite strain", plane, 0.12, deep, CYLINDER, HARDENING, FINITE),
        history("cylinder, finite strain, friction", plane, 0.12, deep, CYLINDER, HARDENING, FINITE, FRICTION),
        history("cylinder, force", plane, 0.12, pressed_by_force(150, 16), CYLINDER, HARDENING),
        history("cylinder beside the middle", plane, 0.12, deep, CYLINDER, HARDENING, {"Indenter/Position": (0.031,)},
                full=True),
        history("wedge", plane, 0.05, deep, WEDGE, PERFECT),
        history("wedge, finite strain, stick", plane, 0.05, deep, WEDGE, HARDENING, FINITE, STICK),
        rough("rough profile", plane, pressed(0.004, 16), HARDENING),
        rough("rough profile, friction", plane, pressed(0.004, 16), HARDENING, FRICTION),
        history("sphere", revolution, 0.06, shallow, SPHERE, PERFECT),
        history("sphere, quadratic", revolution, 0.06, shallow, SPHERE, PERFECT, QUADRATIC),
        history("sphere, friction", revolution, 0.06, shallow, SPHERE, HARDENING, FRICTION),
        history("sphere, finite strain", revolution, 0.06, shallow, SPHERE, HARDENING, FINITE),
        history("sphere, force", revolution, 0.06, pressed_by_force(10, 16), SPHERE, PERFECT),
        history("sphere, recovering back stress", revolution, 0.06, shallow, SPHERE, RECOVERING),
        history("sphere, mesh that follows", revolution, 0.06, shallow, SPHERE, HARDENING, FOLLOWED),
        history("cone", revolution, 0.07, pressed(0.02, 16, 0.015), CONE, PERFECT),
        history("cone, force", revolution, 0.07, pressed_by_force(15, 16), CONE, HARDENING),
        history("cone, finite strain, stick", revolution, 0.07, pressed(0.02, 16, 0.015), CONE, HARDENING, FINITE, STICK),
        history("rounded cone", revolution, 0.07, pressed(0.015, 16), TIP, HARDENING),
        history("sphere in space", space, 0.09, coarse, SPHERE, HARDENING),
        history("sphere in space, no hardening", space, 0.09, coarse, SPHERE, PERFECT),
        history("sphere in space, friction", space, 0.09, coarse, SPHERE, HARDENING, FRICTION),
        history("sphere in space, finite strain", space, 0.09, coarse, SPHERE, HARDENING, FINITE),
        history("sphere in space, force", space, 0.09, pressed_by_force(4, 10), SPHERE, HARDENING),
        history("sphere in space, beside the middle", space, 0.09, coarse, SPHERE, HARDENING,
                {"Indenter/Position": (0.013, 0)}, full=True),
        history("cone in space", space, 0.07, pressed(0.02, 8, 0.015), CONE, HARDENING),
        history("Vickers' pyramid", space, 0.07, pressed(0.02, 8, 0.015), VICKERS, HARDENING),
        history("Vickers' pyramid, finite strain", space, 0.07, pressed(0.02, 8, 0.015), VICKERS, HARDENING, FINITE),
        history("Berkovich's pyramid", space, 0.07, pressed(0.02, 8, 0.015), BERKOVICH, HARDENING, full=True),
        rough("rough surface", space, pressed(0.004, 8), HARDENING),
        rough("rough surface, finite strain, friction", space, pressed(0.004, 8), HARDENING, FINITE, FRICTION),
    ]
    return {one.name: one for one in found}
