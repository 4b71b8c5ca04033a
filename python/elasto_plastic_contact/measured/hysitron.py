# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hysitron and Bruker: TriboScan's texts (.txt), and HighLoad's files (.hld), whose head holds the calibration."""

import itertools
import re
from dataclasses import replace

from ..errors import UserError
from .blocks import text_blocks
from .columns import curves_of_blocks
from .curve import Notes
from .texts import is_number
from .units import factor

FORMAT = "Hysitron"

N_POINTS = re.compile(r"^(?:Number of Points\s*=|Test Data Points:)\s*(\d+)")


def knows(lines):
    return lines[0].startswith("File Version: Hysitron") or any(N_POINTS.match(line) for line in lines[:8])


def read(path, lines, chosen):
    """Each block that announces its points is an indent; those before the first are the approach and the measurement of
    the drift. Raises UserError."""
    starts = [number for number, line in enumerate(lines) if N_POINTS.match(line)]
    if not starts:
        raise UserError(f"'{path}' is a file of Hysitron without 'Test Data Points': it holds no curve. Export the "
                        "test again")
    curves = [curve for start, end in zip(starts, [*starts[1:], len(lines)])
              for curve in read_indent(path, lines[:end], start, chosen)]
    return [replace(curve, name=str(number)) for number, curve in enumerate(curves, 1)]


def read_indent(path, lines, start, chosen):
    """The curves behind the line that announces the points of one. Raises UserError."""
    n_points = int(N_POINTS.match(lines[start])[1])
    numbers = [part for line in lines[start:] for part in heading_and_numbers(line)]
    blocks = text_blocks([""] * start + numbers, path)
    if not blocks:
        raise UserError(f"'{path}' announces {n_points} points in line {start + 1}, and holds none. Export the test "
                        "again")
    curves = curves_of_blocks(blocks, path, chosen, notes_of(lines[:start]))
    n_rows = sum(len(block.rows) for block in blocks)
    if n_rows == n_points:
        return curves
    return [curve.with_remark(f"the file announces {n_points} points, and holds {n_rows}") for curve in curves]


def heading_and_numbers(line):
    """Two lines of a heading that is not ended before the first row, as in '... Force Voltage(V)0.065324 2.459056'."""
    found = re.match(r"(\D.*\))(-?\d+\.\d+\t.*)", line)
    return found.groups() if found and "Time" in line else (line,)


def notes_of(lines):
    """From 'key: value unit' of the head."""
    entries = dict(line.split(": ", 1) for line in lines if ": " in line)
    coefficients = (area_coefficient(entries.get(f"Tip C{i}", "")) for i in range(9))
    known = tuple(itertools.takewhile(lambda coefficient: coefficient is not None, coefficients))
    return Notes(area_function=known if any(known) else None,
                 usable_depth=with_unit(entries.get("Tip Usable Depth"), "length"),
                 frame_compliance=with_unit(entries.get("Machine Comp"), "compliance"),
                 drift_rate=with_unit(entries.get("Drift Rate"), "rate"),
                 others={key: entries[key].strip() for key in ("Time Stamp", "Tip ID", "Test Temp") if key in entries})


def with_unit(text, kind):
    """A value such as '0.00663947 nm/µN'; None if it is none."""
    value, _, unit = (text or "").strip().partition(" ")
    scale = factor(kind, unit)
    return float(value) * scale if scale is not None and is_number(value, False) else None


def area_coefficient(text):
    """One such as '-329697 nm^2/nm^0.5', of a power of the depth, in µm; None if it is none."""
    found = re.match(r"(\S+) nm\^2/nm(?:\^([012](?:\.\d+)?))?$", text.strip())
    return float(found[1]) * 1e-3 ** (2. - float(found[2] or 1.)) if found and is_number(found[1], False) else None
