# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nominal stress and strain of a run without indenter: a box with one end that
is displaced along its axis as a function of time."""

import math
import re
import sys

import numpy

# The ends of a box: the axis they are normal to, and the sign of their normal.
ENDS = {"left": (0, -1.), "right": (0, 1.), "front": (1, -1.), "back": (1, 1.)}
# What muParser and deal.II know, by their names.
FUNCTIONS = {name: getattr(numpy, name) for name in (
    "sin", "cos", "tan", "sinh", "cosh", "tanh", "exp", "log", "log2", "log10", "sqrt", "abs", "sign", "rint",
    "floor", "ceil")}
FUNCTIONS |= {f"a{name}": getattr(numpy, f"arc{name}") for name in (
    "sin", "cos", "tan", "tan2", "sinh", "cosh", "tanh")}
FUNCTIONS |= {
    "ln": numpy.log, "pow": numpy.power, "erf": math.erf, "erfc": math.erfc,
    "cot": lambda x: 1. / numpy.tan(x), "csc": lambda x: 1. / numpy.sin(x), "sec": lambda x: 1. / numpy.cos(x),
    "int": lambda x: numpy.copysign(numpy.floor(abs(x) + 0.5), x), "if_": numpy.where,
    "min": min, "max": max, "sum": lambda *x: sum(x), "avg": lambda *x: sum(x) / len(x),
    "pi": math.pi, "_pi": math.pi, "e": math.e, "_e": math.e,
}


def evaluate(expression, times):
    """An expression of muParser in t; None, and a remark, if it depends on anything else, or is beyond
    what is understood here ("condition ? a : b")."""
    text = re.sub(r"\bif\s*\(", "if_(", expression)
    for theirs, ours in (("^", "**"), ("&&", " and "), ("||", " or ")):
        text = text.replace(theirs, ours)
    try:
        with numpy.errstate(all="ignore"):  # (if() evaluates both of its values)
            return numpy.array([float(eval(text.strip(), {"__builtins__": {}}, {**FUNCTIONS, "t": time}))
                                for time in times])  # pylint: disable=eval-used
    except (SyntaxError, NameError, TypeError, ValueError):
        print(f"no stress over strain: '{expression}' cannot be evaluated here", file=sys.stderr)
        return None


def displaced_ends(run):
    """Name and components of the boundaries with a prescribed displacement."""
    text = run.parameters.get("Boundary conditions/Prescribed displacement", "")
    for boundary in filter(None, (part.strip() for part in text.split("|"))):
        name, _, components = boundary.partition(":")
        yield name.strip(), [component.strip() for component in components.split(";")]


def cross_section(run, lower, upper, axis):
    """The area of the box at right angles to an axis."""
    if run.is_axisymmetric and axis == 1:
        return math.pi * (upper[0] ** 2 - lower[0] ** 2)
    return math.prod(b - a for i, (a, b) in enumerate(zip(lower, upper)) if i != axis)


def stress_strain(run):
    """Strain and stress, beginning with zero, of the end of a box that is displaced
    along its axis; None if this is another kind of test."""
    dim = int(run.number("Dimension"))
    lower = run.numbers("Geometry/Lower corner") or dim * [0.]
    upper = run.numbers("Geometry/Upper corner") or dim * [1.]
    if run.parameters.get("Geometry/Type") != "box" or not run.has("reactions.csv"):
        return None
    table = run.reactions
    ends = {**ENDS, "bottom": (dim - 1, -1.), "top": (dim - 1, 1.)}
    for name, components in displaced_ends(run):
        axis, sign = ends[name]
        column = f"{name}_{'xyz'[axis]}"
        if components[axis] == "free" or column not in table.dtype.names:
            continue
        displacement = evaluate(components[axis], table["time"])
        if displacement is None:
            continue
        strain = sign * displacement / (upper[axis] - lower[axis])
        stress = sign * table[column] / cross_section(run, lower, upper, axis)
        return numpy.append(0., strain), numpy.append(0., stress)
    return None
