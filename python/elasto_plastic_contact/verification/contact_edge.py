# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Verification of the edge of the contact, which moves through the faces of the mesh; see verify."""

CASE = "indentation/cone_smooth_curve.prm"


def deviation_from_similarity(steps, name):
    """By how much a quantity deviates from C depth^2 in the last two thirds of the loading.

    A cone has no length: without hardening, force and area are in proportion to depth^2. Relative to the
    largest value."""
    loading = [step for step in steps if step["time"] <= 1 and step["depth"] > 0.008]
    squares = [step["depth"] ** 2 for step in loading]
    values = [step[name] for step in loading]
    factor = sum(v * s for v, s in zip(values, squares)) / sum(s * s for s in squares)
    return max(abs(v - factor * s) for v, s in zip(values, squares)) / max(values)


def contact_edge(runner):
    """A cone in a perfectly plastic body: waves of force and area, with the edge within faces and at nodes."""
    for edge, limits in (("within faces", {"force": 0.015, "contact_area": 0.025}), ("at nodes", {})):
        tables = runner.tables(CASE, f"Contact/Edge={edge}")
        for name in ("force", "contact_area"):
            deviation = deviation_from_similarity(tables["history"], name)
            if name in limits:
                runner.compare(f"edge {edge}: waves of {name}", deviation, 0, limits[name], absolute=True)
            else:
                runner.verify(f"edge {edge}: waves of {name} {deviation:.3f}, above 0.03", deviation > 0.03)
        smallest = min(row["min_pressure"] / max(row["max_pressure"], 1e-300) for row in tables["statistics"])
        runner.verify(f"edge {edge}: no tension, smallest pressure {smallest:.1e} of the largest", smallest >= 0)
