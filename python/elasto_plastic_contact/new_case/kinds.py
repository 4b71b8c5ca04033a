# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The kinds of tests, what each needs to know and may be told, and how a text becomes what is given."""

import functools
import pathlib
from dataclasses import dataclass, field

from . import others, pyramids, revolution, space
from .contact import STICK
from .materials import Material, chosen_material, of_library
from .units import plain_number, quantity
from ..errors import UserError


@dataclass(frozen=True)
class Film:
    """thickness in µm."""
    thickness: float
    material: Material


@dataclass(frozen=True)
class Kind:
    """make: from what is given to a case. needs: options without which there is no case, of which a tuple is a choice;
    takes: further options, beside those of the material."""
    what: str
    make: object
    needs: tuple = ()
    takes: tuple = ()


DEPTH_OR_FORCE = ("depth", "force")

KINDS = {
    "brinell": Kind("Brinell's test: a ball, by force", revolution.brinell, takes=("force", "ball", "film",
                                                                                   "friction")),
    "rockwell-ball": Kind("Rockwell's test with a ball: three forces", revolution.rockwell_ball, takes=("scale",
                                                                                                        "film",
                                                                                                        "friction")),
    "sphere": Kind("a sphere, by depth or force", revolution.sphere, ("tip_radius", DEPTH_OR_FORCE), ("film",
                                                                                                      "friction")),
    "berkovich": Kind("Berkovich's pyramid: a sixth of the body", functools.partial(pyramids.indentation, "berkovich"),
                      (DEPTH_OR_FORCE,), ("tip_radius", "friction")),
    "vickers": Kind("Vickers' pyramid: an eighth of the body", functools.partial(pyramids.indentation, "vickers"),
                    (DEPTH_OR_FORCE,), ("tip_radius", "friction")),
    "cube-corner": Kind("the corner of a cube: a sixth of the body", functools.partial(pyramids.indentation,
                                                                                       "cube-corner"),
                        ("tip_radius", DEPTH_OR_FORCE), ("friction",)),
    "cone": Kind("a cone, sharp or rounded: seconds in place of a pyramid's minutes", revolution.cone_test,
                 (DEPTH_OR_FORCE,),
                 ("angle", "tip_radius", "film", "friction")),
    "scratch": Kind("a scratch: a tip drawn along the surface", space.scratch, ("tip_radius", "depth"), ("angle",
                                                                                                         "length",
                                                                                                         "friction")),
    "coating": Kind("a film on a substrate under a cone or a ball", revolution.coating, ("film", DEPTH_OR_FORCE),
                    ("angle", "tip_radius", "ball", "friction")),
    "rough": Kind("a rough surface, random or measured, pressed onto a block", space.rough,
                  (("rms", "surface"), "size"), ("depth", "seed", "height_scale", "friction")),
    "material-test": Kind("tension or cycles of the material alone", others.material_test, takes=("strain", "cycles")),
    "limit-load": Kind("the limit load of a flat punch between two bounds", others.limit_load, ("half_width",),
                       ("punch",)),
}

MATERIAL_OPTIONS = ("material", "young_modulus", "poisson_ratio", "yield_stress", "hardening", "strain_rate")


@dataclass(frozen=True)
class Option:
    """question: what it is, for help and to ask; example: a value; read: from the text, or None: as it is."""
    question: str
    example: str
    read: object = None


def length_option(question, example):
    return Option(question, example, lambda text, name: quantity(text, "length", example, name))


def read_film(text, name):
    """'2 um, 400 GPa': thickness and Young's modulus of an elastic film; a third part is its yield stress; or a
    material of the library in place of numbers."""
    thickness, *rest = [part.strip() for part in text.split(",")]
    if not 1 <= len(rest) <= 2:
        raise UserError(f"{name} is '{text}', but must be thickness and Young's modulus, such as '2 um, 400 GPa', also "
                        "a yield stress "
                        "after them, or thickness and a material of the library, such as '2 um, tungsten'")
    thickness = quantity(thickness, "length", "2 um", name)
    if len(rest) == 1 and not rest[0][:1].isdigit():
        return Film(thickness, of_library(rest[0]))
    modulus = quantity(rest[0], "stress", "400 GPa", name)
    yield_stress = quantity(rest[1], "stress", "8 GPa", name) if len(rest) == 2 else None
    return Film(thickness, Material("film", "by its numbers, with Poisson's ratio 0.25, which matters little", modulus,
                                    0.25, yield_stress))


def read_friction(text, name):
    """A coefficient, or 'stick'. Raises UserError."""
    return text if text == STICK else plain_number(text, f"{name}, unless it is '{STICK}',", above=0., below=2.)


def read_surface(text, name):
    """The path of a height map, and whether it is an image. Raises UserError."""
    path = pathlib.Path(text)
    try:
        with path.open("rb") as file:
            return space.Surface(path, file.read(8).startswith(IMAGES))
    except OSError as error:
        raise UserError(f"{name} is '{text}', which cannot be read: {error.strerror}") from None


def whole_number(text, name):
    if not text.isdigit() or not 1 <= int(text) <= 10 ** 6:
        raise UserError(f"{name} is '{text}', but must be a whole number from 1 to 1000000")
    return int(text)


def word_of(allowed):
    def read(text, name):
        if text not in allowed:
            raise UserError(f"{name} is '{text}', but must be one of {', '.join(allowed)}")
        return text
    return read


# What images of height maps begin with: PNG, PBM and PGM.
IMAGES = (b"\x89PNG\r\n\x1a\n", b"P1", b"P2", b"P4", b"P5")

OPTIONS = {
    "depth": length_option("the largest depth", "500 nm"),
    "force": Option("the largest force", "10 mN", lambda text, name: quantity(text, "force", "10 mN", name)),
    "tip_radius": length_option("the radius of the sphere, or of the rounding of a tip", "50 nm"),
    "ball": length_option("the diameter of the ball", "10 mm"),
    "scale": Option("Rockwell's scale: B, E, F, G, H or K", "B", word_of(tuple(revolution.ROCKWELL_SCALES))),
    "angle": Option("the angle between axis and flank of the cone in degrees", "70.3",
                    lambda text, name: plain_number(text, name, above=20., below=90.)),
    "film": Option("thickness and Young's modulus of a film, also its yield stress, or a material of the library",
                   "2 um, 400 GPa", read_film),
    "friction": Option("the coefficient of friction, or 'stick': what touches does not slide", "0.1", read_friction),
    "length": length_option("the length of the scratch (default: three contact radii)", "5 um"),
    "rms": length_option("the root mean square of the heights", "100 nm"),
    "surface": Option("a measured height map: an image (PNG, PGM, PBM), or a text with a matrix of numbers; its peaks "
                      "touch first", "heights.txt", read_surface),
    "height_scale": length_option("of --surface: the height of the number 1 of a matrix, or of white above black",
                                  "1 nm"),
    "size": length_option("the side of the square", "10 um"),
    "seed": Option("of the random surface (default: 1978)", "7", whole_number),
    "strain": Option("the largest strain (default: 0.1)", "0.1", lambda text, name: plain_number(text, name, above=0.,
                                                                                                 below=2.)),
    "cycles": Option("how often the strain goes there and back (default: tension alone)", "3", whole_number),
    "half_width": length_option("half the width of the punch, or its radius", "1 mm"),
    "punch": Option("strip or circular (default: strip)", "strip", word_of(("strip", "circular"))),
}

MATERIAL_QUESTIONS = {
    "material": Option("the material, one of --list-materials", "steel"),
    "young_modulus": Option("Young's modulus", "210 GPa"),
    "poisson_ratio": Option("Poisson's ratio (default: that of the material, or 0.3)", "0.3"),
    "yield_stress": Option("the yield stress; without one, a material of numbers is linear elastic", "400 MPa"),
    "hardening": Option("the hardening law: none, linear H, power n, Ludwik B, n or Voce Q, b", "power 0.1"),
    "strain_rate": Option("the strain rate in 1/s of the stress-strain curve of the library, where its source says how "
                          "it depends on that (default: as it was measured)", "0.01"),
}


def dashed(name):
    return "--" + name.replace("_", "-")


@dataclass
class Given:
    """What has been read: the material, the fineness of the mesh, and each option, None where it is not given."""
    material: Material
    mesh: str
    options: dict = field(default_factory=dict)

    def __getattr__(self, name):
        if name in OPTIONS:
            return self.options.get(name)
        raise AttributeError(name)


def missing(kind, texts):
    """What a kind needs and has not got: names of options, of a choice the first."""
    needed = [need if isinstance(need, str) else need[0] for need in KINDS[kind].needs
              if not any(texts.get(name) for name in ((need,) if isinstance(need, str) else need))]
    return ([] if texts.get("material") or texts.get("young_modulus") else ["material"]) + needed


def read_given(kind, texts, mesh):
    """From the texts of the options. Raises UserError."""
    record = KINDS[kind]
    allowed = [name for need in record.needs for name in ((need,) if isinstance(need, str)
                                                          else need)] + list(record.takes)
    for name, text in texts.items():
        if text and name not in (*allowed, *MATERIAL_OPTIONS):
            raise UserError(f"{dashed(name)} has no effect for '{kind}', which takes {', '.join(map(dashed, allowed))}")
    for need in record.needs:
        if not isinstance(need, str) and all(texts.get(name) for name in need):
            raise UserError(f"{' and '.join(map(dashed, need))} are given, but only one of them can be the "
                            f"{'surface' if 'surface' in need else 'goal of the loading'}")
    material = chosen_material(*(texts.get(name) for name in MATERIAL_OPTIONS))
    options = {name: OPTIONS[name].read(text, dashed(name)) for name, text in texts.items() if text and name in OPTIONS}
    return Given(material, mesh, options)


def make_case(kind, given):
    return KINDS[kind].make(given)
