# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of finite strains; see command."""

from ..verification.finite_strain import (BERKOVICH, CONE, CONE_IN_SPACE, CONES, PYRAMID, curvature, excess_of_small_strains,
                                          hardening, near_radius, sphere_loading, work)
from ..verification.runner import EULER
from .recipe import Content, count, signed_percent, table

# Half and twice the elements over the contact radius of the file.
COARSER = ("Geometry/Local radius=1.28", "Geometry/Local refinements=5")
FINER = ("Geometry/Local radius=4", "Geometry/Local refinements=7")
LOADING = ("Loading/History=1: depth 0.02", "Loading/Number of steps=40")
RADII = (0.05, 0.1, 0.2, 0.25, 0.3, 0.35, 0.4, 0.44, 0.5)


def loading_of(steps):
    """The rows until the largest depth, from the undeformed state on."""
    return [{"depth": 0, "force": 0}, *(step for step in steps if step["time"] <= 1)]


def curvature_in_gpa(steps):
    return curvature(loading_of(steps)) / 1e3


def unloading_slope(steps):
    """Of its first step, at the depth 0.2 micrometres, in N/m."""
    top = len(loading_of(steps)) - 2
    deepest, after = steps[top:top + 2]
    return (deepest["force"] - after["force"]) / (deepest["depth"] - after["depth"]) / deepest["depth"] * 0.2


def plastic_share(steps):
    """Plastic over total work."""
    loading = loading_of(steps)
    return 1 + work(steps[len(loading) - 2:]) / work(loading)


@table(220)
def published_cones(runs):
    """Cones of 70 degrees in three metals."""
    columns = []
    for material, (published, _), slope, _, (radius, pile_up) in CONES:
        file, fine = (runs.history(CONE, *hardening(*material), *entries) for entries in ((), FINER))
        radii = [top["contact_radius"] / top["depth"] for top in (loading_of(file)[-1], loading_of(fine)[-1])]
        top = loading_of(fine)[-1]
        columns.append([
            None, *(f"{value:.2f} ({signed_percent(1e3 * value / published - 1)})" for value in
                    (curvature_in_gpa(file), curvature_in_gpa(fine))), None,
            None, *(f"{value:.0f} ({signed_percent(value / slope / 0.2 - 1)})" for value in
                    (unloading_slope(file), unloading_slope(fine))),
            None, *(f"{plastic_share(steps):.4f}" for steps in (file, fine)),
            f"{radii[0]:.2f} ({radius})", f"{radii[1]:.2f}",
            f"{top['pile_up'] / top['depth']:.2f} ({pile_up or 'none'})"])
    return Content([[None, *row] for row in zip(*columns)])


@table(240)
def cone_elements(runs):
    """The same cones with half, the file's and twice the number of elements."""
    unknowns, values = [None], [None]
    for entries in (COARSER, (), FINER):
        metals = [runs.history(CONE, *hardening(*material), *entries) for material, *_ in CONES]
        unknowns.append(count(metals[0][-1]["dofs"]))
        values.append(", ".join(f"{curvature_in_gpa(steps):.2f}" for steps in metals))
    return Content([unknowns, values])


@table(25)
def sphere_strains(runs):
    """By how much the force of small strains deviates under a sphere."""
    rows = []
    for yield_stress in (400, 2000):
        finite, small = (sphere_loading(runs, strain, yield_stress) for strain in ("logarithmic", "small"))
        excess = excess_of_small_strains(finite, small)
        steps = [near_radius(finite, radius) for radius in RADII]
        rows.append([None, *("" if step is None else signed_percent(excess[step]) for step in steps)])
    return Content(rows)


@table(900)
def pyramids(runs):
    """Pyramids and cones in space, and the axisymmetric cone."""
    bodies = [(4, runs.history(PYRAMID, *LOADING)),
              (4, runs.history(PYRAMID, CONE_IN_SPACE[0], "Indenter/Semi-apex angle=70.3", *LOADING)),
              (4, runs.history(PYRAMID, *CONE_IN_SPACE, *LOADING)),
              (1, runs.history(CONE, EULER, *LOADING, "Geometry/Lower corner=0, -6", "Geometry/Upper corner=6, 0",
                               "Geometry/Initial refinements=2", "Geometry/Local refinements=8",
                               "Geometry/Local radius=10.24"))]
    extensive = ("force", "contact_area", "external_work")
    whole = [[step | {name: parts * step[name] for name in extensive} for step in steps] for parts, steps in bodies]
    ends = [steps[-1] for steps in whole]
    means = [second_half(steps) for steps in whole]
    rows = [[f"{curvature_in_gpa(steps):.2f}" for steps in whole],
            [f"{end['force'] / end['depth'] ** 2 / 1e3:.2f}" for end in ends], against_neighbour(means),
            *(against_neighbour([end[name] for end in ends]) for name in ("external_work", "contact_area")),
            [f"{end['pile_up'] / end['depth']:.3f}" for end in ends]]
    half = [{**step, "force": 2 * step["force"]} for step in runs.history(BERKOVICH, *LOADING)]
    area = 2 * half[-1]["contact_area"]
    return Content([[None, *row] for row in rows], {
        "berkovich": f"{curvature_in_gpa(half):.2f}",
        "berkovich_force": signed_percent(second_half(half) / means[1] - 1).removesuffix(" %"),
        "berkovich_area": signed_percent(area / ends[1]["contact_area"] - 1).removesuffix(" %"),
        "berkovich_pile_up": f"{half[-1]['pile_up'] / half[-1]['depth']:.2f}"})


def against_neighbour(values):
    """The first of four against the second, the third against the fourth."""
    return [signed_percent(values[0] / values[1] - 1), "", signed_percent(values[2] / values[3] - 1), ""]


def second_half(steps):
    """The sum of the forces over the second half of the steps."""
    return sum(step["force"] for step in steps[len(steps) // 2:])


@table(35)
def vertical_or_present(runs):
    """C of the first metal with small strains and the vertical gap, with finite ones and the present gap."""
    material = hardening(*CONES[0][0])
    return Content(numbers={strain: f"{curvature_in_gpa(runs.history(CONE, *material, f'Strain={strain}')):.1f}"
                            for strain in ("small", "logarithmic")})
