# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nominal stress and strain of a run without indenter: a box that is loaded along one of its axes, by
displacements or tractions."""

import math

import numpy

# The lower and the upper end along each axis, by the dimension.
ENDS = {2: (("left", "right"), ("bottom", "top")),
        3: (("left", "right"), ("front", "back"), ("bottom", "top"))}


def cross_section(run, lower, upper, axis):
    """The area of the box at right angles to an axis."""
    if run.is_axisymmetric and axis == 1:
        return math.pi * (upper[0] ** 2 - lower[0] ** 2)
    return math.prod(b - a for i, (a, b) in enumerate(zip(lower, upper)) if i != axis)


def force_along(reactions, ends, axis):
    """That pulls at both ends of the box, read off a support at one of them; None if there is none. (What
    tractions do at one end, the support of the other one feels.)"""
    for end, sign in zip(reversed(ends), (1., -1.)):
        if f"{end}_{axis}" in reactions.dtype.names:
            return sign * reactions[f"{end}_{axis}"]
    return None


def stress_strain(run):
    """Strain and stress, beginning with zero, along the axis on which most work is done; None if this is
    another kind of test."""
    if run.parameters.get("Geometry/Type") != "box" or not run.has("probes.csv"):
        return None
    dim = int(run.number("Dimension"))
    lower = run.numbers("Geometry/Lower corner") or dim * [0.]
    upper = run.numbers("Geometry/Upper corner") or dim * [1.]
    probes, curves = run.table("probes"), []
    for axis in range(1 if run.is_axisymmetric else 0, dim):
        name, ends = "xyz"[axis], ENDS[dim][axis]
        force = force_along(run.reactions, ends, name)
        if force is not None:
            begin, end = (probes[f"{boundary}_displacement_{name}"] for boundary in ends)
            curves.append((numpy.append(0., (end - begin) / (upper[axis] - lower[axis])),
                           numpy.append(0., force / cross_section(run, lower, upper, axis))))
    return max(curves, key=work, default=None)


def work(curve):
    """What the stress does while the strain grows and shrinks, all of it positive."""
    strain, stress = curve
    return (numpy.abs(stress[1:] + stress[:-1]) * numpy.abs(numpy.diff(strain))).sum()
