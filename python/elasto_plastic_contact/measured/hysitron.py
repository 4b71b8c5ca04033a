# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hysitron and Bruker: TriboScan's texts (.txt), and HighLoad's files (.hld), whose head holds the calibration."""

import itertools
import re
from dataclasses import replace

from ..errors import UserError
from .blocks import text_blocks
from .columns import curves_of_blocks
from .curve import Notes, numbered
from .formats import reading_of_marks
from .units import factor

FORMAT = "Hysitron"

N_POINTS = re.compile(r"^(?:Number of Points\s*=|Test Data Points:)\s*(\d+)")


def knows(lines):
    return lines[0].startswith("File Version: Hysitron") or any(N_POINTS.match(line) for line in lines[:8])


def read(path, lines, chosen):
    """Each block that announces its points is an indent, if it has rows; those before the first are the approach and the
    measurement of the drift. Raises UserError."""
    starts = [number for number, line in enumerate(lines) if N_POINTS.match(line)]
    if not starts:
        raise UserError(f"'{path}' is a file of Hysitron without 'Test Data Points': it holds no curve. Export the "
                        "test again")
    curves = numbered([
        (start, read_indent(path, lines[start:end], start + 1, [*lines[:starts[0]], *lines[before:start]], chosen))
        for before, start, end in zip([0, *starts], starts, [*starts[1:], len(lines)])])
    if not curves:
        raise UserError(f"'{path}' announces {n_points(lines[starts[0]])} points in line {starts[0] + 1}, and holds none. "
                        "Export the test again")
    return curves


def n_points(line):
    return int(N_POINTS.match(line)[1])


def read_indent(path, lines, first_line, head, chosen):
    """The curves of one indent, whose first line announces its points; none if it has no rows. head: the lines that
    hold for it. Raises UserError."""
    blocks = text_blocks([part for line in lines for part in heading_and_numbers(line)], path, first_line)
    if not blocks:
        return []
    curves = curves_of_blocks(blocks, path, chosen, notes_of(head, blocks[0].reading.decimal_comma))
    n_rows = sum(len(block.rows) for block in blocks)
    if n_rows == n_points(lines[0]):
        return curves
    return [curve.with_remark(f"the file announces {n_points(lines[0])} points, and holds {n_rows}") for curve in curves]


def heading_and_numbers(line):
    """Two lines of a heading that is not ended before the first row, as in '... Force Voltage(V)0.065324 2.459056'."""
    found = re.match(r"(\D.*\))(-?\d+\.\d+\t.*)", line)
    return found.groups() if found and "Time" in line else (line,)


def notes_of(lines, decimal_comma):
    """From 'key: value unit' of the head. decimal_comma: that of the columns."""
    entries = dict(line.split(": ", 1) for line in lines if ": " in line)
    reading = reading_of_marks([value.strip().partition(" ")[0] for value in entries.values()], decimal_comma)
    coefficients = (area_coefficient(entries.get(f"Tip C{i}", ""), reading) for i in range(9))
    known = tuple(itertools.takewhile(lambda coefficient: coefficient is not None, coefficients))
    return Notes(area_function=known if any(known) else None,
                 usable_depth=with_unit(entries.get("Tip Usable Depth"), "length", reading),
                 frame_compliance=with_unit(entries.get("Machine Comp"), "compliance", reading),
                 drift_rate=with_unit(entries.get("Drift Rate"), "rate", reading),
                 others={key: entries[key].strip() for key in ("Time Stamp", "Tip ID", "Test Temp") if key in entries})


def with_unit(text, kind, reading):
    """A value such as '0.00663947 nm/µN'; None if it is none."""
    value, _, unit = (text or "").strip().partition(" ")
    scale = factor(kind, unit)
    return reading.number(value) * scale if scale is not None and reading.is_number(value) else None


def area_coefficient(text, reading):
    """One such as '-329697 nm^2/nm^0.5', of a power of the depth, in µm; None if it is none."""
    found = re.match(r"(\S+) nm\^2/nm(?:\^([012](?:\.\d+)?))?$", text.strip())
    if not found or not reading.is_number(found[1]):
        return None
    return reading.number(found[1]) * 1e-3 ** (2. - float(found[2] or 1.))
