# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a run says about the quantities that are measured: its curve between its steps, its imprint, its numbers."""

import types

import numpy
from scipy.integrate import trapezoid
from scipy.interpolate import PchipInterpolator

from ..errors import UserError
from ..measured.evaluation import of_loading
from ..oliver_pharr import fit_unloading, points_of

# The initial slope of an unloading is that of a parabola through its points above this share of the largest force.
SLOPE_SHARE = 0.7

# Forces and depths of a hold differ by less than this, relatively.
SAME = 1e-6

# How far measured points may lie beyond the computed curve, relative to its length.
BEYOND = 0.05


class Curve:
    """Depth from the first contact and force of the whole indenter of a run: the loading up to the largest force, with
    the point (0, 0), and what is unloaded then, after a hold of force or depth if there is one."""

    def __init__(self, run):
        history = run.history
        depth = numpy.append(0., history["depth"] - run.number("Indenter/Initial gap"))
        force = numpy.append(0., history["force"] / run.modelled_part)
        points = points_of(depth, force)
        touched = points[:, 0] > 0.
        touched[0] = True
        points = points[touched]
        top = int(points[:, 1].argmax())
        begin = end_of_hold(points, top)
        rises = numpy.flatnonzero(numpy.diff(points[begin:, 1]) >= 0.)
        end = begin + int(rises[0]) + 1 if len(rises) else len(points)
        self.load, self.unload = points[:top + 1], points[begin:end]

    def segment(self, kind):
        """Rows of depth and force, 'load' or 'unload'. Raises UserError without two steps of it."""
        rows = getattr(self, kind)
        if len(rows) < 3:
            raise UserError(f"the run has no {kind}ing of two steps or more, which is to be compared: say so in "
                            "'Loading/History' and 'Loading/Number of steps', or choose 'segments'")
        return rows


def end_of_hold(points, top):
    """The last of the points from 'top' on at which force or depth are still those there."""
    is_held = (numpy.abs(points[top:] - points[top]) <= SAME * points[top]).any(axis=1)
    return top + int(is_held.argmin()) - 1 if not is_held.all() else len(points) - 1


def interpolated(x, y, places, what):
    """y at the places, from monotone cubics between points and their last slopes beyond them. x: growing or falling."""
    if x[0] > x[-1]:
        x, y = x[::-1], y[::-1]
    if (numpy.diff(x) <= 0.).any():
        raise UserError(f"the {what} of the run turns back, so that nothing can be interpolated over it")
    smooth = PchipInterpolator(x, y)
    inside = places.clip(x[0], x[-1])
    slopes = (y[1] - y[0]) / (x[1] - x[0]), (y[-1] - y[-2]) / (x[-1] - x[-2])
    return smooth(inside) + (places - inside) * numpy.where(places < x[0], *slopes)


def curve_at(run, segment, compared, places):
    """The force at these depths (compared: 'force'), or the depth at these forces ('depth')."""
    rows = Curve(run).segment(segment)
    known, values = (rows[:, 0], rows[:, 1]) if compared == "force" else (rows[:, 1], rows[:, 0])
    other = "depth" if compared == "force" else "force"
    if segment == "load" and places.max() > (1. + BEYOND) * known.max():
        raise UserError(f"the measured curve reaches the {other} {places.max():.6g} (in units of the case), and the "
                        f"run only {known.max():.6g}: press further by 'Loading/History', or give "
                        f"\"load to\": \"{other}\"")
    return interpolated(known, values, places, other)


def hold_at(run, places):
    """The depth at these times since the beginning of the hold at the largest force."""
    history, force = run.history, run.history["force"]
    is_held = force >= (1. - SAME) * force.max()
    first = int(is_held.argmax())
    length = len(force) - first if is_held[first:].all() else int(is_held[first:].argmin())
    held = slice(first, first + length)
    time, depth = history["time"][held] - history["time"][first], history["depth"][held]
    if len(time) < 3:
        raise UserError("the run has no hold of two steps or more at its largest force, which is to be compared: say "
                        "so in 'Loading/History', such as '10: force 2 | 70: hold', and 'Loading/Number of steps'")
    if places.max() > (1. + BEYOND) * time[-1]:
        raise UserError(f"the measured hold lasts {places.max():.6g} (in units of the case), and that of the run only "
                        f"{time[-1]:.6g}: hold longer by 'Loading/History'")
    return interpolated(time, depth - run.number("Indenter/Initial gap"), places, "time")


def imprint_at(run, places):
    """The height of the surface at the last step of surface_profile.csv, over its present distance from the axis."""
    profile = run.table("surface_profile")
    rows = profile[profile["step"] == profile["step"].max()]
    if "y" in (rows.dtype.names or ()):
        rows = rows[rows["y"] == rows["y"].min()]
    vertical = "displacement_z" if "displacement_z" in rows.dtype.names else "displacement_y"
    x = rows["x"] + rows["displacement_x"]
    order = numpy.argsort(x)
    height = rows["height"] + rows[vertical] - rows["height"].max()
    return interpolated(numpy.asarray(x[order]), numpy.asarray(height[order]), places, "surface")


def column_at(run, table, x, y, places):
    """A column of a table over another one."""
    rows = run.table(table)
    return interpolated(numpy.asarray(rows[x]), numpy.asarray(rows[y]), places, f"column '{x}' of {table}.csv")


def loading_curvature(run):
    """C of force = C depth^2 (as evaluate does for measured curves)."""
    depth, force = Curve(run).segment("load").T
    return of_loading(types.SimpleNamespace(depth=depth, force=force), len(depth) - 1)["loading_curvature"]


def unloading_slope(run):
    """dF/dh at the largest depth: of the parabola through the first points of the unloading."""
    depth, force = Curve(run).segment("unload").T
    first = force >= SLOPE_SHARE * force[0]
    if first.sum() < 3:
        raise UserError(f"the unloading of the run has fewer than three points above {100. * SLOPE_SHARE:g} % of the "
                        "largest force, which its slope takes: more 'Loading/Number of steps'")
    fall, way = force[0] - force[first][1:], depth[0] - depth[first][1:]
    terms = numpy.column_stack([way, way ** 2])
    return numpy.linalg.lstsq(terms / way.max(), fall / way.max(), rcond=None)[0][0]


def unloading_slope_between(run, shares):
    """dF/dh at the largest depth as laboratories evaluate it: of Oliver and Pharr's power law through the points between
    these shares of the largest force. It is steeper than the initial slope, by some per cent."""
    found = fit_unloading(Curve(run).segment("unload"), shares)
    if found is None:
        low, high = (100. * share for share in shares)
        raise UserError(f"the unloading of the run has fewer than three points between {low:g} and {high:g} % of the "
                        "largest force, which 'fit' takes: more 'Loading/Number of steps'")
    return found[0]


def plastic_work_share(run):
    """W_p / W_t: the part of the work of the loading that the unloading does not give back."""
    curve = Curve(run)
    work = [abs(trapezoid(rows[:, 1], rows[:, 0])) for rows in (curve.segment("load"), curve.segment("unload"))]
    return 1. - work[1] / work[0]


def largest_depth(run):
    return Curve(run).segment("load")[:, 0].max()


def of_unloading(column):
    def first(run):
        values = run.unloadings[column]
        if not len(values):
            raise UserError(f"no unloading of the run in '{run.directory}' can be evaluated: it takes three load steps "
                            "between 95 and 50 % of the largest force")
        return values[0]
    return first


# Numbers by their names: how to find them in a run, and what they are measured in: powers of force and length.
QUANTITIES = {
    "hardness": (of_unloading("hardness"), (1, -2)),
    "tip hardness": (of_unloading("tip_hardness"), (1, -2)),
    "loading curvature": (loading_curvature, (1, -2)),
    "unloading slope": (unloading_slope, (1, -1)),
    "unloading slope over depth": (lambda run: unloading_slope(run) / largest_depth(run), (1, -2)),
    "plastic work share": (plastic_work_share, (0, 0)),
    "largest force": (lambda run: Curve(run).segment("load")[:, 1].max(), (1, 0)),
    "largest depth": (largest_depth, (0, 1)),
    "residual depth": (lambda run: Curve(run).segment("unload")[-1, 0], (0, 1)),
}

# Of the numbers with a slope, how to find them with that of a power law.
FITTED_SLOPES = {
    "unloading slope": unloading_slope_between,
    "unloading slope over depth": lambda run, shares: unloading_slope_between(run, shares) / largest_depth(run),
}
