# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Units as instruments write them, and those in which measured curves are evaluated: depth in µm, force in mN, time in
s, so that stresses are in GPa, stiffnesses in mN/µm and works in nJ."""

import re

from ..errors import UserError

# What each quantity of a curve is measured in, and its unit here.
KINDS = {"time": "time", "depth": "length", "force": "force", "stiffness": "stiffness"}
OWN_UNITS = {"time": "s", "depth": "µm", "force": "mN", "stiffness": "mN/µm"}

# Units of each kind, in those of this module.
FORCES = {"nN": 1e-6, "µN": 1e-3, "mN": 1., "cN": 10., "N": 1e3, "kN": 1e6, "mgf": 9.80665e-3, "gf": 9.80665, "kgf": 9806.65,
          "lbf": 4448.2216}
LENGTHS = {"pm": 1e-6, "Å": 1e-4, "nm": 1e-3, "µm": 1., "mm": 1e3, "cm": 1e4, "m": 1e6, "in": 25400.}
FACTORS = {
    "force": FORCES,
    "length": LENGTHS,
    "time": {"µs": 1e-6, "ms": 1e-3, "s": 1., "min": 60., "h": 3600.},
    "stiffness": {f"{force}/{length}": FORCES[force] / LENGTHS[length] for force in FORCES for length in LENGTHS},
    "compliance": {f"{length}/{force}": LENGTHS[length] / FORCES[force] for force in FORCES for length in LENGTHS},
    "rate": {f"{length}/s": scale for length, scale in LENGTHS.items()},
    "stress": {"Pa": 1e-9, "kPa": 1e-6, "MPa": 1e-3, "N/mm²": 1e-3, "GPa": 1., "N/m²": 1e-9},
}

# Units of columns that no curve consists of.
OTHER_UNITS = {"%", "°C", "°", "K", "V", "mV", "Hz"}

# A number with something behind it.
VALUE = re.compile(r"(.*\d[.,]?)\s*([^\W\d_]\S*|%|°C?)\s*")

# Other ways to write a unit: with another mu, without µ, and words, in small letters and without the s of a plural.
SPELLINGS = {"um": "µm", "uN": "µN", "us": "µs", "A": "Å", "S": "s"}
WORDS = {"micron": "µm", "angstrom": "Å", "sec": "s", "msec": "ms", "second": "s", "sekunde": "s", "millisecond": "ms",
         "minute": "min", "hour": "h", "newton": "N", "millinewton": "mN", "micronewton": "µN", "nanonewton": "nN"} | {
    f"{prefix}{metre}": f"{letter}m" for metre in ("meter", "metre")
    for prefix, letter in (("nano", "n"), ("micro", "µ"), ("mikro", "µ"), ("milli", "m"), ("", ""))}


def tidy(text):
    """A unit as the tables above write it."""
    text = text.strip().replace("μ", "µ").replace("^2", "²").replace(" ", "")
    return "/".join(SPELLINGS.get(part) or WORDS.get(part.lower().removesuffix("s"), part) for part in text.split("/"))


def factor(kind, unit):
    """What to multiply numbers of this kind by; None if there is no such unit."""
    return FACTORS[kind].get(tidy(unit))


def differ(kind, first, second):
    """Whether both are units of this kind, and not the same one."""
    return len({factor(kind, first), factor(kind, second)} - {None}) == 2


def is_unit(text):
    """Whether the text is a unit of any kind, also in brackets."""
    unit = tidy(text.strip().strip("()[]"))
    return any(unit in units for units in FACTORS.values())


def split_value(cell):
    """The number and the unit of a cell such as '12.3 nm', as texts; the unit is empty if there is none."""
    found = VALUE.fullmatch(cell.strip().strip('"'))
    if found and (is_unit(found[2]) or found[2] in OTHER_UNITS):
        return found[1], tidy(found[2])
    return cell, ""


def split_name(text):
    """Name and unit of the heading of a column: 'Depth (nm)', 'Depth [nm]', 'Depth (h, nm)', 'Depth_nm', 'Depth, nm',
    'Depth in nm', 'F/mN'; the unit is empty if there is none."""
    text = text.strip().strip('"').strip()
    for pattern in (r"(.*?)\s*[(\[](?:[^()\[\]]*[,，]\s*)?([^()\[\],，]*)[)\]]\s*$", r"(.*?)\s+in\s+(\S+)$",
                    r"(.*?)\s*[,，]\s*(\S+)$", r"(.*)_([^_\s]+)$", r"([^/]*?)\s*/\s*(\S+)$", r"(.*?)\s+(\S+)$"):
        found = re.match(pattern, text)
        if found and found[1] and is_unit(found[2]):
            return found[1].strip(), tidy(found[2])
    return text, ""


def value_with_unit(text, kind, unit):
    """A number with a unit, such as '0.3 nm/mN', in the units of this module. Raises ValueError: what is wrong with it.
    unit: an example of one for the message."""
    found = re.fullmatch(r"\s*([-+0-9.eE]+)\s*(\S+)\s*", text)
    try:
        number, scale = float(found[1]), factor(kind, found[2])
    except (TypeError, ValueError):
        number, scale = 0., None
    if scale is None:
        raise ValueError(f"it is '{text}', but must be a number with a unit, such as '0.3 {unit}'")
    return number * scale


def given_units(pairs):
    """Units by quantity from texts such as 'depth=nm'. Raises UserError."""
    units = {}
    for pair in pairs:
        quantity, _, unit = pair.partition("=")
        if quantity not in KINDS:
            raise UserError(f"--unit is '{pair}', but must begin with one of {', '.join(KINDS)} and '=', such as "
                            "depth=nm")
        if factor(KINDS[quantity], unit) is None:
            raise UserError(f"--unit is '{pair}', but units of {quantity} are "
                            f"{', '.join(list(FACTORS[KINDS[quantity]])[:12])} and the like")
        units[quantity] = tidy(unit)
    return units
