# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves of blocks of numbers: which columns are depth, force, time and stiffness, and which blocks belong together."""

import itertools
import re
from dataclasses import replace

import numpy

from ..errors import UserError
from .blocks import FEWEST_ROWS
from .curve import MeasuredCurve, Notes
from .headings import columns_of, indent_column, key, unit_of
from .order import check_time, check_work
from .units import KINDS, split_name

# The time begins again if it falls below that share of the largest one so far.
RESTART = 0.1

DAY = 86400.

# A depth that falls from one row to the next by more than that share of the largest one is that of another indent.
FALL = 0.5

# The titles of parts of an indent and comments between its rows, and how far a part may begin from the end of the one
# before, relative to the largest depth and force.
PART = re.compile(r"^[#%]|\b(un)?load(ing)?\b|\b(hold|dwell)(ing)?\b|\bpause\b|\bsegment\b|\b(be|ent)last(en|ung)\b|\bhalte",
                  re.IGNORECASE)
CLOSE = 0.1

HOW_TO_SAY = "Say which columns they are, by their numbers or names: --columns depth=1,force=2,time=3"


def given_columns(text):
    """Number (from 1) or name of the column by quantity, of 'depth=2,force=3'. Raises UserError."""
    return checked_columns(pair.partition("=")[::2] for pair in text.split(","))


def checked_columns(pairs):
    """A dictionary of pairs of quantity and column. Raises UserError."""
    chosen = {}
    for quantity, column in pairs:
        quantity, column = quantity.strip(), str(column).strip()
        if quantity not in KINDS or not column:
            raise UserError(f"--columns is '{quantity}={column}', but must be like depth=2,force=3, of "
                            f"{', '.join(KINDS)}, with the number of the column, from 1, or its name")
        chosen[quantity] = column
    return chosen


def place(block, column, path):
    """The number, from 0, of a column that is given by number or name."""
    if column.isdecimal():
        if not 1 <= int(column) <= block.width:
            raise UserError(f"'{path}' has {block.width} columns in line {block.first_line}, and none with the number "
                            f"{column}: choose another one by --columns")
        return int(column) - 1
    headings = block.headings or []
    for number, heading in enumerate(headings):
        if key(column) in (key(heading), key(split_name(heading)[0])):
            return number
    raise UserError(f"'{path}' has no column '{column}'; it has "
                    f"{', '.join(filter(None, headings)) or 'no names of columns'}. Choose by --columns")


def layouts(block, chosen, path):
    """For each indent that stands in the block: the number of the column of each quantity. None if depth or force are
    not found."""
    if "depth" in chosen and "force" in chosen:
        return [{quantity: place(block, column, path) for quantity, column in chosen.items()}]
    headings = block.headings or []
    found = {quantity: columns_of(headings, quantity) for quantity in KINDS}
    found |= {quantity: [place(block, column, path)] for quantity, column in chosen.items()}
    if not found["depth"] or not found["force"]:
        return None
    check_width(block, path)
    n_indents = min(len(found["depth"]), len(found["force"]))
    for quantity, columns in found.items():
        if len(columns) not in (0, 1, n_indents):
            names = ", ".join(f"'{headings[column]}' ({column + 1})" for column in columns)
            raise UserError(f"'{path}' has several columns for {quantity} in line {block.heading_line}: {names}. "
                            f"Choose by --columns {quantity}={columns[0] + 1}")
    return [{quantity: columns[min(i, len(columns) - 1)] for quantity, columns in found.items() if columns}
            for i in range(n_indents)]


def check_width(block, path):
    """Refuses more columns than values, and values of columns without a heading."""
    n_columns = len(block.headings)
    if n_columns > block.width or n_columns < block.width and any(numpy.isfinite(row[n_columns]) for row in block.rows):
        raise UserError(f"'{path}' has {len(block.headings)} columns by its heading in line {block.heading_line}, but "
                        f"{block.width} values in line {block.first_line}: decimal commas between commas? Save it with "
                        "';' or tabs between columns")


def curve_of_block(block, layout, name):
    table = numpy.array(block.rows)
    headings = (block.headings or []) + [""] * block.width
    units = [*(block.units or []), *[""] * block.width]
    arrays = {quantity: table[:, column] for quantity, column in layout.items()}
    curve = MeasuredCurve(name, **arrays, columns={quantity: headings[column] or str(column + 1)
                                                   for quantity, column in layout.items()},
                          units={quantity: unit_of(headings[column], units[column], quantity)
                                 for quantity, column in layout.items()})
    return with_clock(curve) if layout.get("time") in block.clocks else curve


def with_clock(curve):
    """Of times of the day: seconds since the first one, also across midnight."""
    known = numpy.isfinite(curve.time)
    if not known.any():
        return curve
    time = curve.time.copy()
    time[known] = numpy.unwrap(time[known], period=DAY)
    return replace(curve, time=time - time[known][0], units=curve.units | {"time": "s"}).with_remark(
        f"the time is that of the day in the column '{curve.columns['time']}'")


def curves_of_blocks(blocks, path, chosen, notes=Notes()):
    """All curves of the blocks that have depth and force. Raises UserError if none has."""
    found, others = [], []
    for block in blocks:
        layout = layouts(block, chosen, path)
        others += [block] if layout is None else []
        for part, columns in itertools.product(by_indent(block), layout or []):
            curve = curve_of_block(part, columns, part.title)
            if found and (part.after_blank and goes_on(found[-1], curve) or is_next_part(found[-1], curve)):
                found[-1] = joined(found[-1], curve)
            else:
                found.append(curve)
    if not found:
        raise UserError(why_no_curve(blocks, path))
    found = [part for curve in found for part in split_where_it_restarts(curve)]
    found[0] = found[0].with_remarks(what_is_left_out(blocks, others))
    named = [replace(curve, name=own_name(curve.name, i, found), notes=notes) for i, curve in enumerate(found)]
    return [tidied(curve, path) for curve in named]


def what_is_left_out(blocks, others):
    """Remarks on numbers that are in no curve. others: the Blocks without depth and force."""
    if others:
        names = ", ".join(filter(None, others[0].headings or [])) or "without names"
        yield (f"tables whose columns are not known as depth and force, and left out: {len(others)}, the first one has "
               f"{len(others[0].rows)} rows from line {others[0].first_line} on, and the columns {names}")
    unread = [line for block in blocks for line in block.unread]
    if unread:
        yield (f"lines of numbers that are in no table of {FEWEST_ROWS} rows, and left out: {len(unread)}, the first one "
               f"is line {unread[0]}")


def by_indent(block):
    """The Blocks of the indents that a column of it numbers."""
    column = indent_column(block.headings or [])
    numbers = [] if column is None or column >= block.width else [row[column] for row in block.rows]
    groups = [list(rows) for _, rows in itertools.groupby(block.rows, key=lambda row: row[column])] if numbers else []
    if len(groups) < 2 or min(map(len, groups)) < FEWEST_ROWS or not numpy.isfinite(numbers).all():
        return [block]
    return [replace(block, rows=rows, after_blank=False, title=f"{block.headings[column]} {rows[0][column]:g}")
            for rows in groups]


def why_no_curve(blocks, path):
    block = max(blocks, key=lambda block: len(block.rows))
    if block.headings is None:
        row = ", ".join(f"{value:g}" for value in block.rows[0])
        return f"'{path}' does not say what its columns are; line {block.first_line} holds {row}. {HOW_TO_SAY}"
    missing = " and ".join(quantity for quantity in ("depth", "force") if not columns_of(block.headings, quantity))
    return (f"'{path}' has no column that is known as {missing}; line {block.heading_line} names "
            f"{', '.join(filter(None, block.headings))}. {HOW_TO_SAY}")


def goes_on(before, after):
    """Whether the time goes on, so that empty lines between rows do not begin another indent."""
    return before.time is not None and after.time is not None and after.time[0] >= before.time[-1]


def is_next_part(before, after):
    """Whether a block with a title such as 'Unloading', or a comment, goes on where the one before it ends."""
    if not PART.search(after.name) or before.quantities() != after.quantities():
        return False
    ends = [(getattr(before, quantity), getattr(after, quantity)) for quantity in ("depth", "force")]
    return (before.time is None or goes_on(before, after)) and all(
        abs(second[0] - first[-1]) <= CLOSE * numpy.nanmax(numpy.abs(first)) for first, second in ends)


def split_where_it_restarts(curve):
    """Of indents one below the other, without anything between them."""
    what, begins = ("depth", falls(curve.depth)) if curve.time is None else ("time", restarts(curve.time))
    parts = split_at(curve, begins)
    return parts if len(parts) == 1 else [part.with_remark(f"another indent begins where the {what} begins again")
                                          for part in parts]


def restarts(time):
    """The points at which a time begins again."""
    latest = numpy.fmax.accumulate(time)
    begins = numpy.flatnonzero(time[1:] - time[0] < RESTART * (latest[:-1] - time[0])) + 1
    return [begin for begin in begins if time[begin] < time[begin - 1]]


def falls(depth):
    """The points at which a depth has fallen at once."""
    return numpy.flatnonzero(numpy.diff(numpy.abs(depth)) < -FALL * numpy.nanmax(numpy.abs(depth), initial=0.)) + 1


def split_at(curve, begins):
    """The parts of a curve; one, if some would be too short."""
    parts = [slice(int(begin), int(end)) for begin, end in zip([0, *begins], [*begins, len(curve.depth)])]
    if min(part.stop - part.start for part in parts) < FEWEST_ROWS:
        return [curve]
    return [replace(curve, **{quantity: getattr(curve, quantity)[part] for quantity in curve.quantities()})
            for part in parts]


def joined(before, after):
    return replace(before, **{quantity: numpy.append(getattr(before, quantity), getattr(after, quantity))
                              for quantity in before.quantities()})


def own_name(title, i, curves):
    """The title if no other curve has it, else the number."""
    titles = [curve.name for curve in curves]
    return title[:40] if title and titles.count(title) == 1 and len(curves) > 1 else str(i + 1)


def tidied(curve, path):
    """Without rows that lack a number, or a stiffness that is nowhere, and with depth and force that grow into the
    body. Raises UserError, also of rows that are not in the order of time."""
    if curve.stiffness is not None and not (curve.stiffness > 0.).any():
        curve = replace(curve, stiffness=None)
    if curve.time is not None and not numpy.isfinite(curve.time).any():
        curve = replace(curve, time=None).with_remark(f"the column '{curve.columns['time']}' holds no numbers, so that "
                                                      "there are no rates")
    complete = numpy.isfinite(curve.depth) & numpy.isfinite(curve.force)
    if curve.time is not None:
        complete &= numpy.isfinite(curve.time)
    if complete.sum() < 3:
        raise UserError(f"'{path}' has {complete.sum()} complete rows of depth and force in the indent '{curve.name}', "
                        f"of the columns '{curve.columns['depth']}' and '{curve.columns['force']}': that is no curve. "
                        "Are these the right columns, and numbers alone in them? Choose by --columns")
    if not complete.all():
        curve = replace(curve, **{quantity: getattr(curve, quantity)[complete] for quantity in curve.quantities()})
        curve = curve.with_remark(f"{(~complete).sum()} rows without a depth, force or time are left out")
    if not curve.force.any():
        raise UserError(f"'{path}' has the force 0 in all rows of the indent '{curve.name}', in the column "
                        f"'{curve.columns['force']}': that is no curve. Choose by --columns")
    return in_order(with_right_signs(without_zeros_at_end(curve)), path)


def without_zeros_at_end(curve):
    """Some instruments end a curve by rows of zeros."""
    if curve.time is None:
        return curve
    holds = (curve.depth != 0.) | (curve.force != 0.) | (curve.time != 0.)
    n = len(holds) - 1 - int(numpy.flatnonzero(holds)[-1])
    if n == 0:
        return curve
    curve = replace(curve, **{quantity: getattr(curve, quantity)[:-n] for quantity in curve.quantities()})
    return curve.with_remark(f"{n} rows of zeros at the end are left out")


def in_order(curve, path):
    what = f"'{path}', indent '{curve.name}',"
    if curve.time is not None:
        check_time(curve.time, curve.columns["time"], what)
    check_work(curve.depth, curve.force, what)
    return curve


def with_right_signs(curve):
    """Depth and force of most instruments grow into the body; those of some fall."""
    peak = int(numpy.abs(curve.force).argmax())
    for quantity, start in (("force", 0.), ("depth", curve.depth[:max(peak, 1)].max() if peak else 0.)):
        values = getattr(curve, quantity)
        if values[peak] < start and values[peak] <= values.min() + 0.2 * numpy.ptp(values):
            curve = replace(curve, **{quantity: -values}).with_remark(
                f"the {quantity} is negative into the body, and its sign has been turned")
    return curve
