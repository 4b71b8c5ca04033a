# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of the advice on steps and meshes; see command."""

from ..verification.contact_edge import CASE as CONE, deviation_from_polynomial, deviation_from_similarity
from ..verification.finite_strain import CONE as DEEP_CONE, SPHERE as DEEP_SPHERE
from ..verification.load_steps import ADAPTIVE, force_at
from ..verification.runner import EULER, TWO_STEPS
from ..verification.smooth_curves import at_place
from .finite_strain import curvature_in_gpa, loading_of, plastic_share, unloading_slope
from .recipe import Content, count, hundredths, measured_table, percent, signed_percent, table

STEPS = "Loading/Number of steps={}"


@table(85)
def adaptive_steps(runs):
    """Fixed and adaptive load steps under a cone with finite strains, against 400 fixed ones."""
    loading = "Loading/History=1: depth 0.02"
    reference = runs.history(DEEP_CONE, EULER, loading, STEPS.format(400))
    rows, numbers = [], {}
    for entries in (STEPS.format(100),), (STEPS.format(60),), (STEPS.format(40),), (STEPS.format(100), ADAPTIVE):
        steps = runs.history(DEEP_CONE, EULER, loading, *entries)
        error = max(abs(step["force"] - force_at(step["depth"], reference)) for step in steps) / reference[-1]["force"]
        rows.append([None, count(sum(step["newton_iterations"] for step in steps)), percent(error),
                     signed_percent(curvature_in_gpa(steps) / curvature_in_gpa(reference) - 1)])
        numbers = {"adaptive": count(len(steps))}
    return Content(rows, numbers)


@table(35)
def following_cone(runs):
    """The same on a mesh that follows the contact: the curvature in 50 steps, and how many of them there are if none is halved."""
    loading = "Loading/History=1: depth 0.02"
    exact = curvature_in_gpa(runs.history(DEEP_CONE, EULER, loading, STEPS.format(400)))
    mesh = ("Geometry/Local refinements=3", "Refinement/Elements over contact radius=10", STEPS.format(50))
    two_steps, fixed, adaptive = (runs.history(DEEP_CONE, way, loading, *mesh, *control) for way, control in
                                  ((TWO_STEPS, ()), (EULER, ()), (EULER, (ADAPTIVE,))))
    return Content(numbers={"missing": hundredths(1 - curvature_in_gpa(two_steps) / exact),
                            "fixed": count(len(fixed)), "adaptive": count(len(adaptive))})


@table(110)
def two_step_integration(runs):
    """The force at the largest depth in so many steps, against 400 with two-step integration."""
    cells = {25: [], 50: [], 100: [], 400: []}
    for case, depth in ((DEEP_CONE, 0.02), (DEEP_SPHERE, 0.1)):
        histories = {(n, method): runs.history(case, f"Loading/History=1: depth {depth}", STEPS.format(n), method)
                     for n in cells for method in (EULER, TWO_STEPS)}
        reference = histories[400, TWO_STEPS][-1]["force"]
        for (n, method), steps in histories.items():
            cells[n].append("" if (n, method) == (400, TWO_STEPS) else
                            signed_percent(steps[-1]["force"] / reference - 1, 2))
            if case == DEEP_CONE:
                cells[n].append(count(sum(step["newton_iterations"] for step in steps)))
    return Content([[None, *row] for row in cells.values()])


@table(60)
def curves_by_steps(runs):
    """Loading and unloading of the ready cases in fewer or more steps, against 400 and 160 with two-step integration."""
    rows = []
    for case, depth in ((DEEP_CONE, 0.02), (DEEP_SPHERE, 0.1)):
        exact, *others = [runs.tables(case, f"Loading/History=1: depth {depth} | {end}: force 0", STEPS.format(n), method)
                          for method, end, n in ((TWO_STEPS, 1.4, 560), (EULER, 1.2, 120), (TWO_STEPS, 1.4, 28),
                                                 (TWO_STEPS, 1.4, 42), (TWO_STEPS, 1.4, 56))]
        rows += [[None, *compared(run, exact)] for run in others]
    return Content(rows)


@table(110)
def pyramid_steps(runs):
    """Loading and unloading of a sixth of Berkovich's pyramid, coarse, against 160 and 32 steps with two-step integration."""
    def pressed(n, n_unloading, method):
        end = 1 + n_unloading / n
        return runs.tables("indentation/berkovich_sector.prm", "Geometry/Initial refinements=2", STEPS.format(n + n_unloading),
                           f"Loading/History=0.2: depth 0.002 | 0.5: depth 0.007 | 1: depth 0.02 | {end}: force 0", method)

    exact = pressed(160, 32, TWO_STEPS)
    return Content([compared(pressed(*steps), exact) for steps in
                    ((80, 8, EULER), (40, 8, EULER), (20, 8, TWO_STEPS), (40, 8, TWO_STEPS))])


def compared(run, exact):
    """Cells of a row: Newton steps, and the errors of QUANTITIES and of the curve."""
    return [None, count(sum(step["newton_iterations"] for step in run["history"])),
            *(signed_percent(quantity(run) / quantity(exact) - 1, 2) for quantity in QUANTITIES),
            *(percent(error, 2) for error in errors_of_curve(run["history"], exact["history"]))]


# The slope of the root of the force over the second half of the depth, squared; initial slope of the unloading, plastic
# over total work, hardness.
QUANTITIES = (lambda run: curvature_in_gpa(run["history"]), lambda run: unloading_slope(run["history"]),
              lambda run: plastic_share(run["history"]), lambda run: run["indentation"][0]["hardness"])


def errors_of_curve(steps, exact):
    """The largest errors of the force at the end of a step, loading and unloading, over the largest force."""
    def branches(rows):
        n = len(loading_of(rows)) - 1
        return loading_of(rows), rows[n - 1:][::-1]

    return [max(abs(step["force"] - at_place(*zip(*((row["depth"], row["force"]) for row in fine)), step["depth"]))
                for step in coarse) / max(step["force"] for step in exact)
            for coarse, fine in zip(branches(steps), branches(exact))]


@measured_table(150)
def sphere_curve(runs):
    """A curve of indentation with small strains, in and out and in again: fewer steps of second order, fewer elements."""
    def curve(method, n_steps, n_elements):
        tables, time = runs.timed("indentation/sphere_axisymmetric.prm", "Output/Fields=never", method, STEPS.format(n_steps),
                                  f"Refinement/Elements over contact radius={n_elements}")
        return [(0, 0, 0), *((step["time"], step["depth"], step["force"]) for step in tables["history"])], time

    def branch(rows, begin):
        """Force over depth, which grows."""
        return sorted((depth, force) for time, depth, force in rows if begin <= time <= begin + 1)

    exact, _ = curve(TWO_STEPS, 240, 40)
    largest = max(force for _, _, force in exact)
    rows, as_it_is = [], None
    for method, n_steps, n_elements in ((EULER, 60, 20), (TWO_STEPS, 60, 20), (TWO_STEPS, 60, 10),
                                        (TWO_STEPS, 60, 8), (TWO_STEPS, 48, 6)):
        (found, *_), times = zip(*(curve(method, n_steps, n_elements) for _ in range(3)))
        time = min(times)
        as_it_is = as_it_is or time
        errors = (max(abs(force - at_place(*zip(*branch(exact, begin)), depth)) for depth, force in branch(found, begin)) / largest
                  for begin in range(3))
        rows.append([None, None, None, *(percent(error, 2) for error in errors), f"{time / as_it_is:.2f}"])
    return Content(rows)


def of_cone(steps):
    """The waves of the force under a cone."""
    return deviation_from_similarity(*zip(*((step["depth"], step["force"]) for step in steps if step["time"] <= 1)))


def of_sphere(steps):
    """The same under a sphere."""
    last = [step for step in steps if step["depth"] > steps[-1]["depth"] / 3]
    return deviation_from_polynomial([step["depth"] for step in last], [step["force"] for step in last])


@table(50)
def waves(runs):
    """Waves of the force as the contact grows over the nodes of the mesh."""
    sphere = ("Indenter/Type=sphere", "Indenter/Radius=1")
    rows = []
    for deviation, depth, entries in ((of_cone, 0.02, ()), (of_sphere, 0.003, sphere)):
        for edge in ("at nodes", "within faces"):
            loading = (*entries, f"Contact/Edge={edge}", f"Loading/History=1: depth {depth}")
            curves = (runs.history(CONE, *loading, f"Geometry/Local refinements={refinements}", STEPS.format(n_steps))
                      for refinements, n_steps in ((5, 60), (6, 120)))
            rows.append([None, *(percent(deviation(steps)) for steps in curves)])
    return Content(rows)


@table(35)
def element_quality(runs):
    """Quality of the elements under sharp cones, and force over depth squared, at quarters of the depth."""
    rows = []
    for angle in (70, 60, 45):
        steps = runs.history(DEEP_CONE, f"Indenter/Semi-apex angle={angle}", "Loading/History=1: depth 0.02",
                             STEPS.format(80), EULER, ADAPTIVE, "Geometry/Local refinements=8")
        chosen = [min(steps, key=lambda step, part=part: abs(step["depth"] - 0.005 * part)) for part in (1, 2, 3, 4)]
        rows.append([None, *(f"{step['min_scaled_jacobian']:.2g} ({step['force'] / step['depth'] ** 2:.0f})"
                             for step in chosen)])
    return Content(rows)
