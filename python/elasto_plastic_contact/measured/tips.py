# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tip of a measured curve: its shape, an area function from coefficients or a file, or that of the instrument."""

import itertools
import re

import numpy

from ..errors import UserError
from ..oliver_pharr import Tip, fit_unloading
from .formats import reading_of_marks
from .texts import decode, is_number, lines_of, read_bytes, to_number

# The section of a sharp tip over the square of its height, of which a rounded one differs by a shift of the depth.
SHARP = 24.5

COEFFICIENT = re.compile(r"\s*(?:.*\b[Cc](\d)\s*[=:\t,; ]\s*)([-+0-9.,eE]+)\s*$")


def polynomial(coefficients, length):
    """Of coefficients in this unit of length (in µm)."""
    exponents = [2.] + [0.5 ** n for n in range(len(coefficients) - 1)]
    return Tip.polynomial([c * length ** (2. - p) for c, p in zip(coefficients, exponents)])


def read_area(path, length):
    """The Tip of a file: coefficients 'C0 = 24.5', one a line, or a table of depths and areas; with a sentence.
    Raises UserError."""
    text = decode(read_bytes(path))
    lines = [line for line in lines_of(text or "") if line.strip() and not line.lstrip().startswith("#")]
    coefficients = coefficients_of(lines, path)
    if coefficients:
        if sorted(coefficients) != list(range(len(coefficients))):
            raise UserError(f"'{path}' has the coefficients {', '.join(f'C{i}' for i in sorted(coefficients))}, but "
                            "they must be C0, C1 and so on without a gap")
        values = [coefficients[i] for i in sorted(coefficients)]
        return polynomial(values, length), f"coefficients {', '.join(f'{value:g}' for value in values)} of '{path}'"
    rows = rows_of(lines, path)
    if len(rows) < 3:
        raise UserError(f"'{path}' holds no area function: that is coefficients, one a line, such as 'C0 = 24.5', or a "
                        "table of depth and area with three rows at least; its first line is "
                        f"'{(lines or [''])[0].strip()[:60]}'")
    depth, area = numpy.array(rows).T * [[length], [length ** 2]]
    if (numpy.diff(depth) <= 0.).any() or (area < 0.).any():
        raise UserError(f"'{path}' is a table of depth and area, but its depths do not grow, or an area is negative")
    # (the square root of the area is nearly linear)
    return Tip(lambda height: float(numpy.interp(height, depth, numpy.sqrt(area), numpy.nan, numpy.nan)) ** 2, 0.75), (
        f"table of '{path}', depths from {depth[0]:g} to {depth[-1]:g} µm")


def coefficients_of(lines, path):
    """By their numbers. Raises UserError."""
    texts = {int(match[1]): match[2] for line in lines if (match := COEFFICIENT.match(line))}
    reading = reading_of_marks(texts.values(), decimal_comma=not any("." in text for text in texts.values()))
    for i, text in texts.items():
        if not reading.is_number(text):
            raise UserError(f"'{path}' has the coefficient C{i} '{text}', which is no number: write it as 'C0 = 24.5'")
    return {i: reading.number(text) for i, text in texts.items()}


def rows_of(lines, path):
    """Depths and areas. Raises UserError: a line of other numbers below the first row."""
    rows = list(itertools.dropwhile(lambda row: row[0] is None, ((row_of(line), line) for line in lines)))
    for row, line in rows:
        if row is None and re.search(r"\d", line):
            raise UserError(f"'{path}' is a table of depth and area, but one of its lines is '{line.strip()[:60]}': "
                            "mend or remove it")
    return [row for row, _ in rows if row is not None]


def row_of(line):
    """Depth and area; None if the line is no such row."""
    for separator in ("\t", ";", ",", None):
        cells = line.split(separator)
        decimal_comma = separator != "," and "," in line
        if len(cells) >= 2 and all(is_number(cell, decimal_comma) for cell in cells[:2]):
            return [to_number(cell, decimal_comma) for cell in cells[:2]]
    return None


def tip_of_instrument(curves, cycles, epsilon):
    """The Tip that the files of the curves know, and a sentence; None if they know none. Either coefficients, or, from
    the instrument's own hardness, the section at the contact depth of the last unloading of each indent: the shift of
    the depth that a rounded tip has then."""
    notes = curves[0].notes
    if notes.area_function:
        terms = ", ".join(f"{value:.6g}" for value in notes.area_function)
        return Tip.polynomial(notes.area_function), f"coefficients of the file, {terms} (areas in µm², depths in µm)"
    shifts = []
    for curve, of_curve in zip(curves, cycles):
        if curve.notes.hardness and of_curve:
            unload = of_curve[-1].unload
            part = numpy.column_stack([curve.depth, curve.force])[unload.begin:unload.end + 1]
            with numpy.errstate(all="ignore"):
                fit = fit_unloading(part)
            if fit is not None and numpy.isfinite(fit).all():
                contact_depth = part[0, 0] - epsilon * part[0, 1] / fit[0]
                shifts.append((part[0, 1] / curve.notes.hardness / SHARP) ** 0.5 - contact_depth)
    if not shifts:
        return None
    shift = float(numpy.mean(shifts))
    scatter = f" ± {1e3 * numpy.std(shifts, ddof=1):.2g}" if len(shifts) > 1 else ""
    return Tip(lambda height: SHARP * (height + shift) ** 2, 0.75), (
        f"{SHARP:g} (h + {1e3 * shift:.1f}{scatter} nm)², from largest force over hardness as the instrument gives it, "
        f"of {len(shifts)} indent{'s' if len(shifts) > 1 else ''}")
