# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Verification of the contact pressures that are put out; see verify."""

import math

from .contact_law_bodies import uniform_mesh
from .runner import E_STAR, EULER, TWO_STEPS

SPHERE = "indentation/sphere_axisymmetric.prm"
# With two-step integration, the marks of the steps are larger.
LOADING = ("Loading/History=1: depth 0.002", "Loading/Number of steps=20", EULER, "Output/Surface profile=every step")
DEGREES = ("linear", "quadratic")


def contact_pressure(runner):
    """Under a sphere, 20 nodes and more over the contact radius: Hertz' pressures (exact); scatter when the body yields."""
    for degree, name in enumerate(DEGREES, 1):
        tables = runner.tables(SPHERE, *LOADING, f"Discretization/Polynomial degree={degree}",
                               "Material/Law=linear elastic", "Loading/Number of steps=6",
                               "Refinement/Elements over contact radius=20")
        runner.compare(f"{name}, elastic: pressures against Hertz', over the largest", largest_error(tables), 0, 0.01,
                       absolute=True)
    tables = runner.tables(SPHERE, *LOADING, "Discretization/Polynomial degree=2", "Loading/Number of steps=9",
                           "Refinement/Elements over contact radius=10")
    runner.compare("quadratic, plastic, 10 elements: scatter over the mean pressure", scatter(tables), 0, 0.03, absolute=True)
    # (On the ready mesh, whose smallest elements follow the edge, large steps and changes of the mesh leave marks.)
    tables = runner.tables(SPHERE, *LOADING, TWO_STEPS)
    runner.compare("linear, plastic, the ready case: scatter over the mean pressure", scatter(tables), 0, 0.06, absolute=True)
    for degree, name in enumerate(DEGREES, 1):
        tables = runner.tables(SPHERE, *LOADING, *uniform_mesh("sphere", 20 // degree),
                               f"Discretization/Polynomial degree={degree}")
        runner.compare(f"{name}, plastic, uniform mesh: scatter over the mean pressure", scatter(tables), 0, 0.03,
                       absolute=True)


def late(tables):
    """Of the last third of the steps: rows of the history and those of the surface, by x."""
    steps = tables["history"]
    for step in steps[2 * len(steps) // 3:]:
        rows = [row for row in tables["surface_profile"] if row["step"] == step["step"]]
        yield step, sorted(rows, key=lambda row: row["x"])


def largest_error(tables):
    """Of the pressures up to 0.95 of the contact radius, over the largest pressure."""
    errors = []
    for step, rows in late(tables):
        radius = (3 * step["force"] / (4 * E_STAR)) ** (1 / 3)
        peak = 1.5 * step["force"] / (math.pi * radius**2)
        errors += [abs(row["contact_pressure"] / peak - math.sqrt(1 - (row["x"] / radius) ** 2))
                   for row in rows if row["x"] < 0.95 * radius]
    return max(errors)


def scatter(tables):
    """Half of the largest difference from the mean of both neighbours, within 0.9 of the contact radius, over the mean
    pressure."""
    largest = 0
    for step, rows in late(tables):
        inside = [row["contact_pressure"] for row in rows if row["x"] < 0.9 * step["contact_radius"]]
        mean = step["force"] / step["contact_area"]
        for before, value, after in zip(inside, inside[1:], inside[2:]):
            largest = max(largest, abs(value - (before + after) / 2) / 2 / mean)
    return largest
