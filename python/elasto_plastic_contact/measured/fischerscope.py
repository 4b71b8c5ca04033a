# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""FischerScope (WIN-HCU): a text with all indents of a job, each with the instrument's results and columns F, h, t."""

import re
from dataclasses import replace

from ..errors import UserError
from .blocks import text_blocks
from .columns import curves_of_blocks
from .curve import Notes
from .texts import is_number, to_number

FORMAT = "FischerScope"

# A name, and date and time in the way of some country.
HEAD_OF_INDENT = re.compile(r"^\S.*\s(\d{1,2}[./-]\d{1,2}[./-]\d{4}|\d{4}-\d\d-\d\d)\s+\d{1,2}:\d\d:\d\d(\s*[AaPp]\.?[Mm]\.?)?\s*$")
LARGEST_FORCE = re.compile(r"^F = .*?([\d.,]+)\s*mN")

# What the format measures in, without saying it at the columns.
UNITS = {"force": "mN", "depth": "µm", "time": "s"}

# How far the largest force may be from that of the head.
TOLERANCE = 0.1


def knows(lines):
    return "Name of the application" in lines[0] or any(line.startswith("Indenter shape correction:")
                                                        for line in lines[:200])


def read(path, lines, chosen):
    """Raises UserError."""
    starts = [number for number, line in enumerate(lines) if HEAD_OF_INDENT.match(line)]
    announced = next((to_number(found[1].replace(",", "."), False) for line in lines[:starts[0] if starts else 50]
                      if (found := LARGEST_FORCE.match(line))), None)
    curves = []
    for start, end in zip(starts, [*starts[1:], len(lines)]):
        blocks = text_blocks([""] * start + lines[start:end], path)
        for found in curves_of_blocks(blocks[-1:], path, chosen) if blocks else []:
            units = {quantity: unit or UNITS.get(quantity, "") for quantity, unit in found.units.items()}
            curve = replace(found, name=str(len(curves) + 1), units=units, notes=notes_of(lines[start:end]))
            curves.append(checked(curve, announced))
    if not curves:
        raise UserError(f"'{path}' is a file of FischerScope with results, but without curves (columns F, h, t): "
                        "export it with the single values of each measurement")
    return curves


def checked(curve, announced):
    """Whether the units can be those of the format."""
    largest = curve.force.max()
    if announced and abs(largest / announced - 1.) > TOLERANCE:
        return curve.with_remark("F, h, t are taken for mN, µm and s, as FischerScope writes, but the largest F is "
                                 f"{largest:g}, and the head says {announced:g} mN")
    return curve.with_remark("F, h, t are in mN, µm and s, as FischerScope writes them"
                             + (f" (the largest F is that of the head, {announced:g} mN)" if announced else ""))


def notes_of(lines):
    """From lines such as 'HIT [N/mm²] 8553.6' between the head and the columns."""
    values = {}
    for line in lines[:40]:
        name, _, rest = line.partition("\t")
        words = rest.split("\t")
        number = words[1].replace(",", ".").strip() if len(words) > 1 else ""
        if words[0].startswith("[") and is_number(number, False):
            values[name.strip()] = float(number)
    scaled = {name: values[name] * scale for name, scale in (("HIT", 1e-3), ("EIT/(1-vs^2)", 1.)) if name in values}
    return Notes(hardness=scaled.get("HIT"), plane_strain_modulus=scaled.get("EIT/(1-vs^2)"), others=values)
