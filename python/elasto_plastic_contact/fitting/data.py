# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What was measured, from the files and numbers that the problem of a fit names."""

from dataclasses import dataclass, replace

import numpy

from .predictions import FITTED_SLOPES, QUANTITIES, column_at, curve_at, hold_at, imprint_at
from .problem import Block
from .values import number, texts
from ..errors import UserError
from ..measured.corrections import from_zero_point
from ..measured.evaluation import hold_at_end
from ..measured.readers import read_curve
from ..measured.segments import find_segments
from ..measured.units import FACTORS, differ, factor, value_with_unit
from ..study.execution import look_up
from ..study.plan import check, check_keys, choice, read_columns, read_numbers
from ..tables import read_table

# Keys of all kinds of data, and those of each.
COMMON = ("noise", "weight", "independent points")
KINDS = {"curve": ("columns", "units", "indents", "cycle", "zero point", "segments", "compare", "above", "points"),
         "imprint": ("columns", "unit", "points"), "table": ("columns", "computed", "points"),
         "quantity": ("value", "unit", "fit")}

# What is compared of a curve unless told: depth and force; a hold is depth over time.
CURVES = ("load", "unload")

# A measured force that turns back by less than this share of its largest value begins no new segment.
TURN = 0.05

# Points at forces below this share of the largest one are left out unless told.
LOWEST = 0.05

# The weights of data without noise: so many of their largest value.
NOMINAL = 0.01

# Units of named quantities by their powers of force and length.
UNIT_KINDS = {(1, -2): "stress", (1, -1): "stiffness", (1, 0): "force", (0, 1): "length"}
POWERS = {"depth": (0, 1), "force": (1, 0)}

NOISES = ("absolute", "relative", "of largest")


@dataclass(frozen=True)
class CaseUnits:
    """Length and force of a case in µm and mN, None if they are not known, and its time in s. place: the experiment,
    for messages."""
    length: float
    force: float
    time: float
    place: str

    def of(self, powers):
        """The unit of force^a length^b of the case, in those of measured curves."""
        if powers != (0, 0) and None in (self.length, self.force):
            raise UserError(f"'{self.place}' does not say the units of its case, and its data have some: give them, "
                            'such as "units": {"length": "mm", "force": "N"}')
        return 1. if powers == (0, 0) else self.force ** powers[0] * self.length ** powers[1]


def read_units(given, entries, place):
    """Of an experiment: what it says, else the entries of its case, and a time in s."""
    check_keys(given, f"{place}/units", (), ("length", "force", "time"))
    found = []
    for kind, default in (("length", ""), ("force", ""), ("time", "s")):
        entry = f"Output/{kind.capitalize()} unit"
        stands = entries.get(entry, default)
        unit = given.get(kind, stands)
        if unit and factor(kind, str(unit)) is None:
            raise UserError(f"'{place}/units/{kind}' is '{unit}', but must be one of {', '.join(FACTORS[kind])}")
        if entry in entries and differ(kind, str(unit), stands):
            raise UserError(f"'{place}/units/{kind}' is '{unit}', and the case says '{entry} = {stands}': leave one of "
                            "them out")
        found.append(factor(kind, unit) if unit else None)
    return CaseUnits(*found, place)


def read_blocks(data, place, folder, units):
    """The Blocks of an item of 'data'. folder: where names of files begin."""
    if not isinstance(data, dict) or sum(kind in data for kind in KINDS) != 1:
        raise UserError(f"'{place}' must be an object with one of the keys {', '.join(KINDS)}, which says what was "
                        "measured")
    kind = next(kind for kind in KINDS if kind in data)
    check_keys(data, f"'{place}'", (kind,), (*COMMON, *KINDS[kind]))
    read = {"curve": read_curves, "imprint": read_imprint, "table": read_columns_of_table,
            "quantity": read_quantity}[kind]
    try:
        return read(data, place, folder, units)
    except OSError as error:
        raise UserError(f"'{place}': '{error.filename}' cannot be read: {error.strerror}") from None


def read_curves(data, place, folder, units):
    blocks = []
    for name in texts(data, "curve", place):
        curves = read_curve(folder / name, data.get("columns"), data.get("units"))
        for number_of in chosen_indents(data, place, len(curves)):
            suffix = f", indent {number_of}" if len(curves) > 1 else ""
            curve, remark = with_zero_point(curves[number_of - 1], data, place, f"{name}{suffix}")
            blocks += [replace(block, remark=remark)
                       for block in blocks_of_curve(curve, data, place, f"{name}{suffix}", units)]
    return blocks


def chosen_indents(data, place, n_curves):
    chosen = data.get("indents", list(range(1, n_curves + 1)))
    if not isinstance(chosen, list) or not chosen or any(i not in range(1, n_curves + 1) for i in chosen):
        raise UserError(f"'{place}/indents' is {chosen}, but must be a list of numbers from 1 to {n_curves}")
    return chosen


def blocks_of_curve(curve, data, place, name, units):
    """Load and unload of one cycle, or its hold, in units of the case."""
    if data.get("segments") in ("hold", ["hold"]):
        return [block_of_hold(curve, data, place, name, units)]
    compared = choice(data.get("compare", "force"), f"{place}/compare", ["force", "depth"])
    scales = {quantity: units.of(powers) for quantity, powers in POWERS.items()}
    segments = segments_of(curve, data, place)
    wanted = texts(data, "segments", place) if "segments" in data else [kind for kind in CURVES if kind in segments]
    lowest = number(data, "above", place, LOWEST, least=0., below=1.) * curve.force.max()
    unit = factor(UNIT_KINDS[POWERS[compared]], curve.units_of_file[compared])
    noisy = with_noise_of_case(data, place, unit / scales[compared])
    blocks = []
    for kind in wanted:
        if kind == "hold":
            raise UserError(f"'{place}/segments': the depths of a hold are compared over time: give it an item of "
                            "'data' of its own")
        choice(kind, f"{place}/segments", [*CURVES, "hold"])
        if kind not in segments:
            raise UserError(f"'{place}': the curve '{name}' has no unloading; leave 'unload' out of 'segments'")
        rows = slice(segments[kind].begin, segments[kind].end + 1)
        depth, force = curve.depth[rows], curve.force[rows]
        used = (force >= lowest) & (depth > 0.)
        if used.sum() < 3:
            raise UserError(f"'{place}': the {kind} of the curve '{name}' has fewer than 3 points above {lowest:.4g} "
                            "mN")
        columns = {"depth": depth[used] / scales["depth"], "force": force[used] / scales["force"]}
        other = "depth" if compared == "force" else "force"
        blocks.append(block_of(noisy, place, f"{name}, {kind}", kind, columns[other], columns[compared],
                               lambda run, x, kind=kind: curve_at(run, kind, compared, x), (other, compared)))
    return blocks


def block_of_hold(curve, data, place, name, units):
    """The depth over the time since the beginning of the hold at the largest force, in units of the case."""
    if data.get("compare", "depth") != "depth" or "above" in data:
        raise UserError(f"'{place}' compares the depths of a hold over time: leave out 'compare' and 'above'")
    if curve.time is None:
        raise UserError(f"'{place}': the curve '{name}' has no time, which its hold takes: say which column it is by "
                        "'columns', and its unit by 'units'")
    hold = segments_of(curve, data, place).get("hold")
    if hold is None:
        raise UserError(f"'{place}': the curve '{name}' has no hold at its largest force")
    rows = slice(hold.begin, hold.end + 1)
    length = units.of(POWERS["depth"])
    noisy = with_noise_of_case(data, place, factor("length", curve.units_of_file["depth"]) / length)
    return block_of(noisy, place, f"{name}, hold", "hold", (curve.time[rows] - curve.time[hold.begin]) / units.time,
                    curve.depth[rows] / length, hold_at, ("time", "depth"))


def with_zero_point(curve, data, place, name):
    """The curve from its zero point, and a sentence on one that is fitted, else an empty one."""
    chosen = data.get("zero point")
    if chosen is not None and chosen != "fit":
        try:
            chosen = value_with_unit(str(chosen), "length", "nm")
        except ValueError as error:
            raise UserError(f"'{place}/zero point': {error}, or \"fit\"") from None
    curve, sentence = from_zero_point(curve, chosen, TURN)
    return curve, f"'{name}': {sentence}. Errors and regions take it for exact" if chosen == "fit" else ""


def segments_of(curve, data, place):
    """Load, unload and hold of the cycle that is chosen, as far as they are there, by name."""
    segments, cycles = find_segments(curve, TURN)
    if not cycles:
        held = hold_at_end(segments)
        return {segment.kind: segment for segment in segments if segment.kind == "load" or segment is held}
    cycle = cycles[number(data, "cycle", place, 1, convert=int, least=1, most=len(cycles)) - 1]
    if cycle.hold is not None:
        return {"load": cycle.load, "unload": cycle.unload, "hold": cycle.hold}
    top = deepest(curve, cycle)
    return {"load": replace(cycle.load, end=top), "unload": replace(cycle.unload, begin=top)}


def deepest(curve, cycle):
    """Where a load without a hold ends: the deepest point around the largest force. (A force with noise is largest
    somewhere near; a point of the loading taken for one of the unloading, which is steep, would be far from it.)"""
    force = curve.force[cycle.load.begin:cycle.unload.end + 1]
    peak, low = cycle.unload.begin - cycle.load.begin, numpy.flatnonzero(force < (1. - TURN) * force.max())
    first, last = low[low < peak].max(initial=-1) + 1, low[low > peak].min(initial=len(force))
    return int(cycle.load.begin + first + curve.depth[cycle.load.begin:][first:last].argmax())


def read_imprint(data, place, folder, units):
    """Heights over distances from the axis; a free surface far away has the height 0."""
    x, height = columns_of_file(data, "imprint", ("x", "height"), place, folder)
    if "unit" in data:
        if factor("length", str(data["unit"])) is None:
            raise UserError(f"'{place}/unit' is '{data['unit']}', but must be one of {', '.join(FACTORS['length'])}")
        scale = factor("length", data["unit"]) / units.of((0, 1))
        x, height, data = scale * x, scale * height, with_noise_of_case(data, place, scale)
    return [block_of(data, place, data["imprint"], "imprint", x, height, imprint_at, ("distance", "height"))]


def read_columns_of_table(data, place, folder, _):
    """Any column over another one, in units of the case."""
    check_keys(data.get("computed"), f"'{place}/computed'", ("table", "x", "y"), ())
    names = read_columns(data["computed"], f"{place}/computed", "x", "y")
    x, y = columns_of_file(data, "table", names[1:], place, folder)
    return [block_of(data, place, data["table"], "columns", x, y, lambda run, at: column_at(run, *names, at),
                     names[1:])]


def columns_of_file(data, key, default, place, folder):
    """Two columns of a table."""
    name = check(data[key], f"{place}/{key}", str, "the name of a file")
    chosen = data.get("columns", list(default))
    if not isinstance(chosen, list) or len(chosen) != 2:
        raise UserError(f"'{place}/columns' is {chosen}, but must be a list of two names of columns")
    rows = read_table(folder / name)
    for column in chosen:
        if not rows or column not in rows[0]:
            raise UserError(f"'{place}': '{folder / name}' has no column '{column}'; it has "
                            f"{', '.join(rows[0]) if rows else 'no rows'}. Choose by \"columns\": [..., ...]")
    found = [numpy.array([row[column] for row in rows]) for column in chosen]
    if not numpy.isfinite(found).all():
        raise UserError(f"'{place}': '{folder / name}' has values that are not finite")
    return found


def read_quantity(data, place, _, units):
    """A number with a name, or of a table; several values are those of several indents, whose mean is taken."""
    quantity = data["quantity"]
    if isinstance(quantity, dict):
        found, = read_numbers({"quantity": quantity}).values()
        name, scale = f"{found.table}: {found.column}", 1.
        if "unit" in data:
            raise UserError(f"'{place}/unit' is for quantities with a name; give the value in units of the case")
        if "fit" in data:
            raise UserError(f"'{place}/fit' is for unloading slopes with a name: leave it out")

        def find(run):
            value = look_up(found, run.directory, f"{place}/quantity")
            if value is None:
                raise UserError(f"'{place}': the run has no such row of {found.table}.csv")
            return value
    else:
        name, find = named_quantity(data, place)
        scale = scale_of(data, place, QUANTITIES[name][1], units)
    values = numpy.array(numbers_of(data, place)) * scale
    data = with_noise_of_case(data, place, scale)
    if len(values) > 1 and not {"noise", "weight"} & set(data):
        data = data | {"noise": {"absolute": values.std(ddof=1) / len(values) ** 0.5}}
    return [block_of(data, place, name, "quantity", numpy.empty(0), numpy.atleast_1d(values.mean()),
                     lambda run, _: numpy.atleast_1d(find(run)), ("", name))]


def named_quantity(data, place):
    """The name, and how to find the number in a run."""
    name = choice(data["quantity"], f"{place}/quantity", list(QUANTITIES))
    if "fit" not in data:
        return name, QUANTITIES[name][0]
    shares = data["fit"]
    if name not in FITTED_SLOPES:
        raise UserError(f"'{place}/fit' is for {' and '.join(FITTED_SLOPES)}, not for '{name}': leave it out")
    if (not isinstance(shares, list) or len(shares) != 2 or any(not isinstance(share, (int, float)) for share in shares)
            or not 0. < shares[0] < shares[1] <= 1.):
        raise UserError(f"'{place}/fit' is {shares}, but must be two shares of the largest force, the lower one first, "
                        "such as [0.5, 0.95]")
    return name, lambda run: FITTED_SLOPES[name](run, shares)


def numbers_of(data, place):
    values = data.get("value", [])
    values = values if isinstance(values, list) else [values]
    if not values or any(isinstance(value, bool) or not isinstance(value, (int, float)) for value in values):
        raise UserError(f"'{place}/value' is {data.get('value')}, but must be a number, or a list of those of several "
                        "indents")
    return values


def scale_of(data, place, powers, units):
    """What makes the value one in units of the case, in which it is without a unit."""
    if "unit" not in data:
        return 1.
    if powers == (0, 0):
        raise UserError(f"'{place}/unit' is '{data['unit']}', but '{data['quantity']}' has none")
    scale = factor(UNIT_KINDS[powers], str(data["unit"]))
    if scale is None:
        allowed = list(FACTORS[UNIT_KINDS[powers]])[:12]
        raise UserError(f"'{place}/unit' is '{data['unit']}', but must be one of {', '.join(allowed)}")
    return scale / units.of(powers)


def block_of(data, place, name, kind, x, y, predict, labels):
    """With its noise, of so many points as are wanted or independent."""
    sigma = deviations(data, place, y)
    if "points" in data and len(y):
        x, y, sigma = averaged(x, y, sigma, number(data, "points", place, convert=int, least=3))
    independent = number(data, "independent points", place, len(y), above=0.)
    sigma = sigma * max(1., len(y) / independent) ** 0.5
    return Block(name, kind, x, y, sigma, lambda run: predict(run, x), labels)


def with_noise_of_case(data, place, scale):
    """With the absolute noise in units of the case, which is given in that of the data. scale: a unit of the data in
    those of the case."""
    noise = data.get("noise")
    if not isinstance(noise, dict) or "absolute" not in noise:
        return data
    return data | {"noise": noise | {"absolute": scale * number(noise, "absolute", f"{place}/noise", least=0.)}}


def deviations(data, place, y):
    """The standard deviation of each value, or what stands for it if there is a weight or nothing."""
    if "noise" not in data:
        return numpy.full(len(y), NOMINAL * numpy.abs(y).max() / number(data, "weight", place, 1., above=0.) ** 0.5)
    noise = data["noise"]
    if not isinstance(noise, dict) or not noise or set(noise) - set(NOISES) or "weight" in data:
        raise UserError(f"'{place}/noise' is {noise}, but must be an object with one or more of the numbers "
                        f"{', '.join(NOISES)}, without 'weight'")
    absolute, relative, share = (number(noise, key, f"{place}/noise", 0., least=0.) for key in NOISES)
    sigma = numpy.sqrt(absolute ** 2 + (relative * y) ** 2 + (share * numpy.abs(y).max()) ** 2)
    if not (sigma > 0.).all():
        raise UserError(f"'{place}/noise' is zero for some values: a relative noise of values at 0 takes another one "
                        "beside it")
    return sigma


def averaged(x, y, sigma, n_points):
    """Means of so many parts with equal numbers of points, one after the other."""
    parts = [part for part in numpy.array_split(numpy.arange(len(y)), n_points) if len(part)]
    return (numpy.array([x[part].mean() for part in parts]), numpy.array([y[part].mean() for part in parts]),
            numpy.array([numpy.sqrt((sigma[part] ** 2).sum()) / len(part) for part in parts]))
