# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""FischerScope (WIN-HCU): a text with all indents of a job, each with the instrument's results and columns F, h, t."""

import re
from dataclasses import replace

from ..errors import UserError
from .blocks import text_blocks
from .columns import curves_of_blocks
from .curve import Notes, numbered
from .formats import reading_of_marks

FORMAT = "FischerScope"

# A name, and date and time in the way of some country.
HEAD_OF_INDENT = re.compile(r"^\S.*\s(\d{1,2}[./-]\d{1,2}[./-]\d{4}|\d{4}-\d\d-\d\d)\s+\d{1,2}:\d\d:\d\d(\s*[AaPp]\.?[Mm]\.?)?\s*$")
LARGEST_FORCE = re.compile(r"^F = .*?([\d.,\u00a0\u2009\u202f'’]+)\s*mN")

# What the format measures in, without saying it at the columns.
UNITS = {"force": "mN", "depth": "µm", "time": "s"}

# What the largest force is called.
LARGEST = "the largest F"

# How far the largest force may be from that of the head.
TOLERANCE = 0.1


def knows(lines):
    return "Name of the application" in lines[0] or any(line.startswith("Indenter shape correction:")
                                                        for line in lines[:200])


def read(path, lines, chosen):
    """Raises UserError."""
    starts = [number for number, line in enumerate(lines) if HEAD_OF_INDENT.match(line)]
    forces = [found[1] for line in lines[:starts[0] if starts else 0] if (found := LARGEST_FORCE.match(line))]
    curves = numbered([(start, read_indent(path, lines[start:end], start + 1, forces[:1], chosen))
                       for start, end in zip(starts, [*starts[1:], len(lines)])])
    if not curves:
        raise UserError(f"'{path}' is a file of FischerScope with results, but without curves (columns F, h, t): "
                        "export it with the single values of each measurement")
    return curves


def read_indent(path, lines, first_line, forces, chosen):
    """The curves of one indent; none if it has no rows. forces: the largest force, if the head of the file says it.
    Raises UserError."""
    blocks = text_blocks(lines, path, first_line)
    if not blocks:
        return []
    texts = {LARGEST: force for force in forces} | results_of(lines)
    reading = reading_of_marks(texts.values(), blocks[0].reading.decimal_comma)
    values = {name: reading.number(text) for name, text in texts.items() if reading.is_number(text)}
    remarks = [f"the head says '{text}' for {name}, which is no number" for name, text in texts.items()
               if name not in values and re.search(r"\d", text)]
    announced = values.pop(LARGEST, None)
    curves = [checked(curve.with_remarks(remarks), announced) for curve in curves_of_blocks(blocks, path, chosen)]
    return [replace(curve, notes=notes_of(values)) for curve in curves]


def checked(curve, announced):
    """In the units of the format, with a remark on whether they can be those."""
    units = {quantity: unit or UNITS.get(quantity, "") for quantity, unit in curve.units.items()}
    curve, largest = replace(curve, units=units), curve.force.max()
    if announced and abs(largest / announced - 1.) > TOLERANCE:
        return curve.with_remark("F, h, t are taken for mN, µm and s, as FischerScope writes, but the largest F is "
                                 f"{largest:g}, and the head says {announced:g} mN")
    return curve.with_remark("F, h, t are in mN, µm and s, as FischerScope writes them"
                             + (f" (the largest F is that of the head, {announced:g} mN)" if announced else ""))


def results_of(lines):
    """The texts of the numbers, from lines such as 'HIT [N/mm²] 8553.6' between the head and the columns."""
    rows = (line.split("\t") for line in lines[:40])
    return {cells[0].strip(): cells[2].strip() for cells in rows if len(cells) > 2 and cells[1].startswith("[")}


def notes_of(values):
    scaled = {name: values[name] * scale for name, scale in (("HIT", 1e-3), ("EIT/(1-vs^2)", 1.)) if name in values}
    return Notes(hardness=scaled.get("HIT"), plane_strain_modulus=scaled.get("EIT/(1-vs^2)"), others=values)
