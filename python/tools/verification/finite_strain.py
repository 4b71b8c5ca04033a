# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Verification of finite strains; see verify."""

import math
import pathlib
import random
import tempfile

from elasto_plastic_contact.program import command_line
from elasto_plastic_contact.tables import read_tables
from .homogeneous_strain import bar, simple_shear
from .imprint import largest_difference
from .runner import E, EULER, NU

BAR = ("verification/uniaxial_stress.prm", "Strain=logarithmic")
CONE = "indentation/cone_finite_strain.prm"
PYRAMID = "indentation/vickers_finite_strain.prm"
BERKOVICH = "indentation/berkovich_finite_strain.prm"
SPHERE = "indentation/sphere_finite_strain.prm"
CONE_IN_SPACE = ("Indenter/Type=cone", "Indenter/Semi-apex angle=70")
# Few cells and steps, for what does not depend on them.
COARSE = ("Geometry/Local refinements=5", "Geometry/Local radius=1", "Loading/History=1: depth 0.1 | 1.2: force 0",
          "Loading/Number of steps=48", "Nonlinear solver/Tolerance=1e-12")


def finite_strain(runner):
    """A bar and simple shear at large strains (exact); small strains as the limit."""
    for stretch in (2.0, 0.4):
        tension_and_compression(runner, stretch)
    for degree in (1, 2):
        large_shear(runner, degree)
    small_strains_as_limit(runner)


def tension_and_compression(runner, stretch):
    """Nominal and true stress of a bar, in space, as a body of revolution and as a sheet."""
    nominal, true, across = bar(E, NU, 400, 2000, stretch)
    change = f"{stretch - 1}*t"
    plane = ("Dimension=2", "Boundary conditions/Roller=left, bottom", "Boundary conditions/Free=right",
             f"Boundary conditions/Prescribed displacement=top: free; {change}", "Output/Probe points=rim: 1, 0.5")
    for name, axis, area, entries in (
            ("space", "z", 1, (f"Boundary conditions/Prescribed displacement=top: free; free; {change}",
                               "Output/Probe points=rim: 1, 0.5, 0.5")),
            ("axisymmetric", "y", math.pi, (*plane, "Kinematics=axisymmetric")),
            ("plane stress", "y", 1, (*plane, "Kinematics=plane stress"))):
        tables = runner.tables(*BAR, "Loading/Number of steps=20", *entries)
        probes = tables["probes"][-1]
        name = f"{name}, stretch {stretch}"
        runner.compare(f"{name}: nominal stress", tables["reactions"][-1][f"top_{axis}"] / area, nominal, 1e-9)
        runner.compare("true stress", probes[f"rim_stress_{axis * 2}"], true, 1e-9)
        runner.compare("stretch across", 1 + probes["rim_displacement_x"], across, 1e-9)
        runner.compare("logarithmic strain", probes[f"rim_strain_{axis * 2}"], math.log(stretch), 1e-9)


def large_shear(runner, degree):
    """Simple shear by 2, perfectly plastic, in 40 steps."""
    n_steps = 40
    steps = simple_shear(E / (2 * (1 + NU)), 400, [2 * step / n_steps for step in range(1, n_steps + 1)])
    sides = " | ".join(f"{side}: 2*t*y; 0" for side in ("left", "right", "bottom", "top"))
    probes = runner.tables(
        *BAR, "Dimension=2", "Kinematics=plane strain", "Boundary conditions/Roller=", "Boundary conditions/Free=",
        f"Boundary conditions/Prescribed displacement={sides}", "Material/Law=perfectly plastic",
        f"Discretization/Polynomial degree={degree}", f"Loading/Number of steps={n_steps}",
        "Output/Probe points=inside: 0.3, 0.6")["probes"]
    errors = [abs(row[f"inside_stress_{entry}"] - stress)
              for row, (normal, shear) in zip(probes, steps)
              for entry, stress in (("xx", normal), ("yy", -normal), ("xy", shear))]
    runner.compare(f"simple shear, Q{degree}: stresses of all steps over the yield stress", max(errors) / 400, 0, 1e-9,
                   absolute=True)


def small_strains_as_limit(runner):
    """The force of an elastic bar with either strain: the difference falls with the square of the amplitude."""
    differences = []
    for amplitude in (1e-3, 5e-4, 2.5e-4):
        forces = [runner.history(
            BAR[0], f"Strain={strain}", "Material/Law=linear elastic",
            f"Boundary conditions/Prescribed displacement=top: free; free; {amplitude}")[-1]["top_z"]
            for strain in ("small", "logarithmic")]
        differences.append(forces[0] - forces[1])
        runner.compare(f"amplitude {amplitude}: difference of the forces", differences[-1],
                       E * (amplitude - math.log1p(amplitude) / (1 + amplitude)), 1e-6)
    for coarse, fine in zip(differences, differences[1:]):
        runner.compare("half the amplitude", coarse / fine, 4, 2e-3)


def finite_strain_ranks(runner):
    """A cone with finite strains: the same on 1 and 2 ranks, with every linear solver."""
    loading = ("Loading/History=1: depth 0.05 | 1.1: force 0", "Loading/Number of steps=22")
    tables = {}
    for solver, n in (("direct", 1), ("direct", 2), ("multigrid", 2)):
        with runner.on_ranks(n):
            tables[solver, n] = runner.tables(CONE, *COARSE, *loading, f"Linear solver/Type={solver}")["history"]
    reference = tables["direct", 1]
    for (solver, n), rows in tables.items():
        runner.compare(f"{solver}, {n} rank(s): force, depth and contact area",
                       largest_difference(of_curve(reference), of_curve(rows)), 0, 1e-8, absolute=True)


def of_curve(rows):
    """What does not depend on the solver."""
    return [{name: row[name] for name in ("depth", "force", "contact_area", "plastic_work")} for row in rows]


def finite_strain_resume(runner):
    """A cone with finite strains: stopped at the largest depth and resumed, as in one run."""
    entries = {"Output/Fields": "never", **dict(entry.split("=", 1) for entry in COARSE)}
    loading = entries | {"Loading/History": "1: depth 0.1", "Loading/Number of steps": "40"}
    with tempfile.TemporaryDirectory() as folder:
        def run(changes, name, *options):
            directory = pathlib.Path(folder) / name
            runner.start(command_line(runner.program, runner.case(CONE), changes, directory, *options, ranks=runner.ranks))
            return of_curve(read_tables(directory)["history"])
        whole = run(entries, "whole")
        run(loading, "stopped")
        runner.compare("force, depth and contact area", largest_difference(whole, run(entries, "stopped", "--resume")),
                       0, 1e-10, absolute=True)


# Young's modulus, sigma_0, n of sigma_0 (1 + E e_p / sigma_0)^n (MPa); published C (MPa), with what is allowed,
# dP/dh over depth (MPa), W_p / W_t (Lu et al. 2020); contact radius and pile-up over depth of an independent program.
CONES = (
    ((210000, 300, 0), (29236, 0.025), 336838 / 0.2, 0.9718, (3.46, 0.25)),
    ((50000, 600, 0), (39269, 0.015), 65181 / 0.2, 0.8092, (2.81, 0.02)),
    ((210000, 300, 0.5), (110190, 0.015), 237229 / 0.2, 0.8460, (2.38, 0)),
)


def finite_cone(runner):
    """A cone of 70 degrees with finite strains, two materials, 7 elements over the contact radius (published)."""
    for cone in CONES[:2]:
        check_cone(runner, cone, 7, "Geometry/Local refinements=5")


def published_cones(runner):
    """A cone of 70 degrees with finite strains, all materials (published; minutes)."""
    for cone in CONES:
        check_cone(runner, cone, 14)


def check_cone(runner, cone, n_elements, *entries):
    """Curvature of the loading, initial slope of the unloading, plastic work, and the contact radius up to a quarter of
    one of the elements over it."""
    material, published_curvature, slope, plastic_share, others = cone
    steps = runner.history(CONE, *hardening(*material), *entries)
    top = next(i for i, step in enumerate(steps) if step["time"] == 1)
    deepest, after = steps[top], steps[top + 1]
    loading, unloading = [{"depth": 0, "force": 0}, *steps[:top + 1]], steps[top:]
    runner.compare("E = {:g}, sigma_0 = {:g}, n = {:g}: C".format(*material), curvature(loading), *published_curvature)
    runner.compare("dP/dh over depth", (deepest["force"] - after["force"]) / (deepest["depth"] - after["depth"])
                   / deepest["depth"], slope, 0.03)
    runner.compare("W_p / W_t", 1 + work(unloading) / work(loading), plastic_share, 0.01, absolute=True)
    runner.compare("contact radius over depth, other program", deepest["contact_radius"] / deepest["depth"], others[0],
                   0.25 / n_elements)
    print(f"  pile-up over depth {deepest['pile_up'] / deepest['depth']:.2f} (other program {others[1]})")


def symmetric_bodies(runner):
    """Finite strains: a quarter and a half of a body under a cone and a pyramid: the same."""
    coarse = ("Geometry/Local refinements=5", "Geometry/Local radius=5.12", "Loading/History=1: depth 0.04",
              "Loading/Number of steps=4", "Contact/Edge=at nodes")
    half = ("Geometry/Lower corner=-6, 0, -6", "Geometry/Repetitions=2, 1, 1", "Boundary conditions/Roller=front",
            "Boundary conditions/Free=left, right, back")
    for name, shape in (("cone", CONE_IN_SPACE), ("edges on the diagonals", ("Indenter/Rotation=0",)),
                        ("edges on the planes of symmetry", ("Indenter/Rotation=45",))):
        parts = [runner.history(PYRAMID, *coarse, *shape, *body)[-1] for body in ((), half)]
        for column in ("force", "contact_area", "plastic_work"):
            runner.compare(f"{name}: {column}", 2 * parts[1][column], 4 * parts[0][column], 1e-7)


def cone_in_space(runner):
    """Finite strains: a cone in a quarter of a body and in an axisymmetric one, cells of the same size (minutes)."""
    loading = ("Loading/History=1: depth 0.02", "Loading/Number of steps=40")
    quarter = runner.history(PYRAMID, *CONE_IN_SPACE, *loading)
    whole = runner.history(CONE, EULER, *loading, "Geometry/Lower corner=0, -6", "Geometry/Upper corner=6, 0",
                           "Geometry/Initial refinements=2", "Geometry/Local refinements=8",
                           "Geometry/Local radius=10.24")
    for name, allowed in (("force", 0.01), ("external_work", 0.01), ("contact_area", 0.05)):
        runner.compare(name, 4 * quarter[-1][name], whole[-1][name], allowed)
    second_halves = [sum(step["force"] for step in steps[len(steps) // 2:]) for steps in (quarter, whole)]
    runner.compare("mean force over the second half", 4 * second_halves[0], second_halves[1], 0.01)


def pyramids(runner):
    """Finite strains: Vickers' and Berkovich's pyramids and the cone of the same area, 70.3 degrees (long)."""
    loading = ("Loading/History=1: depth 0.02", "Loading/Number of steps=40")
    cone = runner.history(PYRAMID, CONE_IN_SPACE[0], "Indenter/Semi-apex angle=70.3", *loading)
    for case, n_parts in ((PYRAMID, 4), (BERKOVICH, 2)):
        pyramid = runner.history(case, *loading)
        forces = [parts * sum(step["force"] for step in steps[len(steps) // 2:])
                  for parts, steps in ((n_parts, pyramid), (4, cone))]
        runner.compare(f"{case}: mean force over the second half", *forces, 0.03)
        runner.compare("contact area", n_parts * pyramid[-1]["contact_area"], 4 * cone[-1]["contact_area"], 0.05)


def hardening(young, yield_stress, exponent):
    """The entries of sigma = sigma_0 (1 + E e_p / sigma_0)^n, which is Swift's law."""
    return (f"Material/Young's modulus={young}", f"Material/Yield stress={yield_stress}",
            "Material/Law=nonlinear hardening", "Material/Isotropic hardening modulus=0",
            f"Material/Power law exponent={exponent}",
            f"Material/Power law reference strain={yield_stress / young!r}")


def curvature(steps):
    """C of F = C depth^2: the square of the slope of sqrt(F) over the second half of the depth, by least squares."""
    points = [(step["depth"], math.sqrt(step["force"])) for step in steps
              if step["depth"] >= 0.5 * steps[-1]["depth"]]
    x, y = (sum(values) / len(points) for values in zip(*points))
    return (sum((a - x) * (b - y) for a, b in points) / sum((a - x) ** 2 for a, _ in points)) ** 2


def work(steps):
    """The area under the curve of force over depth, negative while the depth decreases."""
    return sum(0.5 * (a["force"] + b["force"]) * (b["depth"] - a["depth"]) for a, b in zip(steps, steps[1:]))


def sphere_loading(runner, strain, yield_stress):
    """The loading of a sphere to a/R = 0.5."""
    return runner.history(SPHERE, f"Strain={strain}", f"Material/Yield stress={yield_stress}", EULER,
                          "Loading/History=1: depth 0.1", "Loading/Number of steps=100")


def excess_of_small_strains(finite, small):
    """By how much the force of small strains is larger, step by step, over that of finite ones.

    Means over five steps: nodes that come into contact make waves."""
    excess = [other["force"] / step["force"] - 1 for step, other in zip(finite, small)]
    return [sum(near) / len(near) for near in (excess[max(0, i - 2):i + 3] for i in range(len(excess)))]


def near_radius(finite, radius):
    """The number of the step whose contact radius, over that of the sphere, is next; none if it is beyond 0.01."""
    i = min(range(len(finite)), key=lambda step: abs(finite[step]["contact_radius"] - radius))
    return i if abs(finite[i]["contact_radius"] - radius) < 0.01 else None


def rough_finite_strain(runner):
    """Heights of 17 x 17 random points: the nodes that slide along them pass their kinks; mirrored heights, the same force."""
    generator = random.Random(1)
    rows = [[0.01 * generator.random() for _ in range(17)] for _ in range(17)]
    body = ("rough_surface_3d.prm", "Strain=logarithmic", "Contact/Geometry=present", "Geometry/Lower corner=0, 0, -0.5",
            "Geometry/Upper corner=1, 1, 0", "Geometry/Repetitions=8, 8, 4", "Geometry/Initial refinements=0",
            "Indenter/Type=height matrix", "Indenter/Size=1, 1", "Indenter/Position=0.5, 0.5", "Refinement/Number of cycles=1")
    materials = {"elastic": ("Material/Law=linear elastic", "Loading/Depth=0.01"),
                 "perfectly plastic": ("Material/Law=perfectly plastic", "Material/Yield stress=2000", "Loading/Depth=0.03")}
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "heights.txt"
        for name, entries in materials.items():
            forces = []
            for heights in (rows, [row[::-1] for row in rows]):
                file.write_text("\n".join(" ".join(map(str, row)) for row in heights), encoding="utf-8")
                steps = runner.history(*body, *entries, f"Indenter/File={file}", "Loading/Number of steps=20")
                forces.append(steps[-1]["force"])
            runner.compare(f"{name}, force under mirrored heights", forces[1], forces[0], 1e-8)
