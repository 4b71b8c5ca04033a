# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Other ways to compute the same load history; see contact_uniqueness."""

import dataclasses
import functools
import pathlib
import random

TINY = 1e-12
LENGTHS = ("Geometry/Lower corner", "Geometry/Upper corner", "Geometry/Local radius", "Indenter/Radius", "Indenter/Size",
           "Indenter/Position", "Indenter/Height scale")
STRESSES = ("Material/Young's modulus", "Material/Yield stress", "Material/Isotropic hardening modulus",
            "Material/Back stress moduli")
SHAPES = ("Indenter/Radius", "Indenter/Semi-apex angle", "Indenter/Face angle")
OTHER_SIDES = {"left": "right", "right": "left"}


@dataclasses.dataclass(frozen=True)
class Variant:
    """change: makes another History of one, or None where that is impossible; units: of length and of stress, by which
    results are larger."""
    change: callable = staticmethod(lambda history: history)
    ranks: int = 1
    environment: tuple = ()
    length: float = 1
    stress: float = 1


def with_entries(history, entries):
    return dataclasses.replace(history, entries=history.entries | entries)


def times(value, factor):
    """A number or a tuple of numbers."""
    return tuple(part * factor for part in value) if isinstance(value, tuple) else value * factor


def scaled_loading(history, depth_factor, force_factor):
    """The table of the loading."""
    factors = {"depth": depth_factor, "force": force_factor}
    return {"Loading/History": tuple((time, kind, value * factors[kind])
                                     for time, kind, value in history.entries["Loading/History"])}


def other_shape(history):
    """Each length or angle of the indenter a little larger; heights by parts of that."""
    generator = random.Random(1)
    heights = tuple(tuple(height * (1 + TINY * generator.uniform(-1, 1)) for height in row) for row in history.heights)
    changed = {name: history.entries[name] * (1 + TINY) for name in SHAPES if name in history.entries}
    return dataclasses.replace(with_entries(history, changed), heights=heights)


def other_load(history):
    """Depth or force a little larger."""
    return with_entries(history, scaled_loading(history, 1 + TINY, 1 + TINY))


def solved_by(entries, history):
    """With other entries of the solvers."""
    return with_entries(history, entries)


def force_factor(kind, length, stress):
    """In the plane, forces are per unit of length."""
    return stress * length ** (1 if kind == "plane" else 2)


def other_units(length, stress, history):
    """Lengths and stresses in other units."""
    entries = history.entries
    return with_entries(history, {name: times(entries[name], length) for name in LENGTHS if name in entries} |
                        {name: times(entries[name], stress) for name in STRESSES if name in entries} |
                        scaled_loading(history, length, force_factor(history.kind, length, stress)))


def mirrored(history):
    """x becomes -x; None in revolution."""
    if history.kind == "revolution":
        return None
    entries = history.entries
    lower, upper = entries["Geometry/Lower corner"], entries["Geometry/Upper corner"]
    changed = {"Geometry/Lower corner": (-upper[0], *lower[1:]), "Geometry/Upper corner": (-lower[0], *upper[1:])}
    for name in ("Boundary conditions/Roller", "Boundary conditions/Free"):
        changed[name] = tuple(OTHER_SIDES.get(side, side) for side in entries[name])
    if "Indenter/Position" in entries:
        first, *others = entries["Indenter/Position"]
        changed["Indenter/Position"] = (-first, *others)
    if "Indenter/Rotation" in entries:
        changed["Indenter/Rotation"] = 180 - entries["Indenter/Rotation"]
    return dataclasses.replace(with_entries(history, changed), heights=tuple(row[::-1] for row in history.heights))


def in_units(length, stress):
    return Variant(functools.partial(other_units, length, stress), length=length, stress=stress)


def with_solver(entry, value):
    return Variant(functools.partial(solved_by, {entry: value}))


def with_kernels(name):
    """Of OpenBLAS, which the factorisation uses."""
    return dataclasses.replace(with_solver("Linear solver/Type", "direct"), environment=(("OPENBLAS_CORETYPE", name),))


VARIANTS = {
    "shape": Variant(other_shape),
    "load": Variant(other_load),
    "direct": with_solver("Linear solver/Type", "direct"),
    "mirrored": Variant(mirrored),
    "length 1e-3": in_units(1e-3, 1),
    "accurate": with_solver("Nonlinear solver/Loosest linear reduction", 1e-8),
    "length 1e6": in_units(1e6, 1),
    "Nehalem": with_kernels("Nehalem"),
    "tolerance": with_solver("Nonlinear solver/Tolerance", 1e-13),
    "length 1e-3 and stress 1e6": in_units(1e-3, 1e6),
    "length 1e6 and stress 1e-12": in_units(1e6, 1e-12),
    "Haswell": with_kernels("Haswell"),
    "Prescott": with_kernels("Prescott"),
    "2 ranks": Variant(ranks=2),
    "3 ranks": Variant(ranks=3),
}


def as_entries(history, folder):
    """The entries as the program reads them; the height matrix lies in the folder."""
    entries = dict(history.entries)
    entries["Loading/History"] = " | ".join(f"{time!r}: {kind} {value!r}"
                                            for time, kind, value in history.entries["Loading/History"])
    if history.heights:
        file = pathlib.Path(folder) / "heights.txt"
        file.write_text("\n".join(" ".join(map(repr, row)) for row in history.heights) + "\n", encoding="utf-8")
        entries["Indenter/File"] = file
    return entries
