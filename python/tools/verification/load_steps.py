# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Verification of load steps: how they adapt to Newton's iterations, and what is saved of them; see verify."""

import math
import pathlib
import subprocess

from elasto_plastic_contact.tables import read_tables
from .finite_strain import COARSE, CONE
from .runner import EULER, TWO_STEPS

LOADING = "Loading/History=1: depth {}"
ADAPTIVE = "Loading/Step control=adaptive"


def adaptive_steps(runner):
    """Adaptive load steps under a cone with finite strains against fixed ones."""
    elastic_body(runner)
    loading_curve(runner)
    too_long_steps(runner)


def elastic_body(runner):
    """The state of an elastic body does not depend on the steps."""
    rows = [runner.history(CONE, *COARSE, "Material/Law=linear elastic", "Contact/Edge=at nodes", LOADING.format(0.1),
                           "Loading/Number of steps=12", *control)[-1] for control in ((), (ADAPTIVE,))]
    runner.verify("other steps", rows[0]["step"] != rows[1]["step"])
    for column in ("force", "contact_area", "elastic_energy"):
        runner.compare(f"elastic: {column}", rows[1][column], rows[0][column], 1e-9)


def loading_curve(runner):
    """With at most twice the length, about half the Newton iterations, and a similar curve."""
    fixed, adaptive = (runner.history(CONE, "Geometry/Local refinements=4", LOADING.format(0.02), "Loading/Number of steps=60", *control)
                       for control in ((), (ADAPTIVE,)))
    n_fixed, n_adaptive = (sum(step["newton_iterations"] for step in steps) for steps in (fixed, adaptive))
    runner.verify(f"{n_adaptive:.0f} Newton iterations in {len(adaptive)} steps, fixed {n_fixed:.0f} in {len(fixed)}",
                  n_adaptive < 0.7 * n_fixed)
    differences = [abs(step["force"] - force_at(step["depth"], fixed)) / fixed[-1]["force"] for step in adaptive]
    runner.compare("largest difference of the forces over the largest force", max(differences), 0, 0.02, absolute=True)


def two_step_integration(runner):
    """Steps of second order under a cone with finite strains: force, plastic work and energy balance."""
    def last(n_steps, *method):
        return runner.history(CONE, "Geometry/Local refinements=4", LOADING.format(0.02),
                              f"Loading/Number of steps={n_steps}", *method)[-1]

    stiffness = "Evaluation/Continuous stiffness=true"
    exact, euler = last(120, TWO_STEPS), last(40, EULER, stiffness)
    coarse, fine = last(24, TWO_STEPS), last(40, TWO_STEPS, stiffness)
    for column in ("force", "plastic_work"):
        errors = [abs(row[column] / exact[column] - 1) for row in (fine, euler)]
        runner.verify(f"{column} in 40 steps: error {100 * errors[0]:.3f} %, backward Euler {100 * errors[1]:.3f} %, "
                      "at least four times as much", errors[0] < errors[1] / 4)
    missing = [abs(row["external_work"] - row["elastic_energy"] - row["plastic_work"]) / row["external_work"]
               for row in (coarse, fine)]
    order = math.log(missing[0] / missing[1]) / math.log(40 / 24)
    runner.verify(f"of the work, {100 * missing[0]:.2f} % are missing in 24, {100 * missing[1]:.2f} % in 40 steps: "
                  f"order {order:.2f}, at least 1.6", order > 1.6)
    runner.compare("contact stiffness", fine["contact_stiffness"], euler["contact_stiffness"], 0.01)


def rows_that_go_on(runner):
    """Where the indenter goes on in the same direction, the rows of its history do not matter, nor do their times."""
    n_steps, depth = 12, 0.02
    # (So many steps give each of the short rows one.)
    histories = {"two rows": (f"0.5: depth {depth / 2} | 1: depth {depth}", n_steps),
                 "a row for each step, long and short ones": (" | ".join(
                     f"{i + 0.2 * (i % 2)}: depth {depth * i / n_steps}" for i in range(1, n_steps + 1)), 9)}
    for strain in ("logarithmic", "small"):
        def run(history, n, strain=strain):
            return runner.history(CONE, *COARSE, TWO_STEPS, f"Strain={strain}", f"Loading/History={history}",
                                  f"Loading/Number of steps={n}")

        expected = run(f"1: depth {depth}", n_steps)
        for name, history in histories.items():
            rows = run(*history)
            runner.verify(f"{name}: {len(rows)} steps", len(rows) == n_steps)
            for column in ("force", "plastic_work"):
                runner.compare(f"{strain}, {name}: {column}", rows[-1][column], expected[-1][column], 1e-8)


def contact_of_a_hold(runner):
    """In a hold, rounding errors of the contact area do not decide when the mesh follows: it does so at once."""
    n_steps, load, hold = 24, 1, 2
    tables = runner.tables("indentation/sphere_axisymmetric.prm", f"Loading/History={load}: depth 0.01 | {load + hold}: hold",
                           f"Loading/Number of steps={n_steps}", "Refinement/Elements over contact radius=8")
    first = load + (load + hold) / n_steps
    times = [row["time"] for row in tables["mesh_changes"] if row["time"] > load]
    runner.verify(f"changes of the mesh in the hold at {times}, its first step ends at {first}", times == [first])


def force_at(depth, steps):
    """From linear interpolation of its root."""
    points = [(0, 0)] + [(step["depth"], math.sqrt(step["force"])) for step in steps]
    for (x, a), (y, b) in zip(points, points[1:]):
        if depth <= y * (1 + 1e-12):
            return (a + (b - a) * (depth - x) / (y - x)) ** 2
    raise ValueError(f"no step is as deep as {depth}")


def too_long_steps(runner):
    """Where steps of a fixed length fail, adaptive ones go through."""
    entries = (*COARSE, EULER, LOADING.format(0.1), "Loading/Number of steps=6")
    try:
        runner.history(CONE, *entries, "Loading/Maximum number of cuts=0")
        failure = 0
    except subprocess.CalledProcessError as error:
        failure = error.returncode
    runner.verify("6 fixed steps fail", failure == 3)
    runner.verify("adaptive ones reach the depth", runner.history(CONE, *entries, ADAPTIVE)[-1]["time"] == 1)


def checkpoint_memory(runner):
    """A run that writes a checkpoint after each step does not hold its contents in memory once more."""

    def peak_memory_and_checkpoint(minutes_between):
        entries = (
            "Geometry/Initial refinements=5", "Refinement/Strategy=none", "Refinement/Number of cycles=1",
            "Loading/History=1: depth 0.002", "Loading/Number of steps=2",
            f"Output/Minutes between checkpoints={minutes_between}",
        )
        with runner.results("sphere_3d.prm", entries) as folder:
            files = (pathlib.Path(folder) / "checkpoint").glob("*")
            return read_tables(folder)["statistics"][-1]["memory_mb"], sum(file.stat().st_size for file in files) / 2**20

    without, _ = peak_memory_and_checkpoint(1000)
    with_checkpoints, checkpoint = peak_memory_and_checkpoint(0)
    # (The peak of one and the same run varies by up to 6 MB with what else the machine does.)
    runner.verify(
        f"peak memory with checkpoints {with_checkpoints:.1f} MB, without {without:.1f} MB, at most a quarter "
        f"of the {checkpoint:.1f} MB of a checkpoint more", with_checkpoints <= without + checkpoint / 4,
    )
