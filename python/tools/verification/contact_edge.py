# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Verification of the edge of the contact, which moves through the faces of the mesh; see verify."""

import math

from .contact_law_bodies import SHAPES, uniform_mesh
from .runner import TWO_STEPS
from .smooth_curves import waves

CASE = "indentation/cone_smooth_curve.prm"


def deviation_from_similarity(depths, values):
    """By how much a quantity deviates from C depth^2 in the last two thirds of the loading.

    A cone has no length: without hardening, force and area are in proportion to depth^2. Relative to the
    largest value."""
    squares, values = zip(*((depth ** 2, value) for depth, value in zip(depths, values) if depth > 0.008))
    factor = sum(v * s for v, s in zip(values, squares)) / sum(s * s for s in squares)
    return max(abs(v - factor * s) for v, s in zip(values, squares)) / max(values)


def deviation_from_polynomial(places, values, degree=6):
    """The largest deviation from the polynomial that is next in the mean square, relative to the largest value."""
    middle, half = (places[0] + places[-1]) / 2, (places[-1] - places[0]) / 2
    rest, basis = list(values), []
    for power in range(degree + 1):
        direction = [((x - middle) / half) ** power for x in places]
        for other in basis:
            part = sum(a * b for a, b in zip(direction, other))
            direction = [a - part * b for a, b in zip(direction, other)]
        length = sum(a * a for a in direction) ** 0.5
        basis.append([a / length for a in direction])
        part = sum(a * b for a, b in zip(rest, basis[-1]))
        rest = [a - part * b for a, b in zip(rest, basis[-1])]
    return max(abs(a) for a in rest) / max(values)


def mean_forces(steps):
    """The depths and forces of the columns mean_depth and mean_force, where there are some."""
    means = [(step["mean_depth"], step["mean_force"]) for step in steps if not math.isnan(step["mean_force"])]
    return [list(values) for values in zip(*means)]


def contact_mesh(runner):
    """Sphere and cone on meshes that follow the edge of the contact: smooth curves, and the area of a finer, uniform mesh."""
    for case, shape in SHAPES.items():
        depth = shape.depth
        steps, finer = (runner.history(shape.case, f"Loading/History=1: depth {depth}", *entries) for entries in (
            ("Refinement/Elements over contact radius=20", "Loading/Number of steps=30"),
            (*uniform_mesh(case, 40), "Loading/Number of steps=24")))
        last = [step for step in steps if step["depth"] > depth / 3]
        for name, allowed in (("force", 0.003), ("contact_area", 0.01)):
            deviation = deviation_from_polynomial([step["depth"] for step in last], [step[name] for step in last])
            runner.compare(f"{case}: waves of {name}", deviation, 0, allowed, absolute=True)
            runner.compare(f"{case}: {name} against 40 elements", steps[-1][name], finer[-1][name], 0.01)
        runner.verify(f"{case}: cells do not become more ({steps[0]['cells']:.0f} to {steps[-1]['cells']:.0f})",
                      steps[-1]["cells"] < 1.2 * steps[0]["cells"])


def contact_edge(runner):
    """A cone in a perfectly plastic body: waves of force and area, with the edge within faces and at nodes."""
    # (Large waves need many points.)
    for edge, steps, limits in (("within faces", (TWO_STEPS, "Loading/Number of steps=60"), {"force": 0.01, "contact_area": 0.025}),
                                ("at nodes", ("Loading/Number of steps=120",), {})):
        # (20 elements over the final contact radius, two thirds of which are in the curve)
        tables = runner.tables(CASE, f"Contact/Edge={edge}", "Geometry/Local refinements=6",
                               "Loading/History=1: depth 0.024", *steps)
        loading = tables["history"]
        for name in ("force", "contact_area"):
            deviation = deviation_from_similarity([step["depth"] for step in loading], [step[name] for step in loading])
            if name in limits:
                runner.compare(f"edge {edge}: waves of {name}", deviation, 0, limits[name], absolute=True)
            else:
                runner.verify(f"edge {edge}: waves of {name} {deviation:.3f}, above 0.03", deviation > 0.03)
        runner.compare(f"edge {edge}: waves of mean_force", waves(*mean_forces(loading[len(loading) // 3:]), (1, 2)), 0,
                       0.001, absolute=True)
        smallest = min(row["min_pressure"] / max(row["max_pressure"], 1e-300) for row in tables["statistics"])
        runner.verify(f"edge {edge}: no tension, smallest pressure {smallest:.1e} of the largest", smallest >= 0)
