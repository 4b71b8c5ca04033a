#!/usr/bin/env python3
# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the verification cases and compares them with exact or published values.

usage: scripts/verify.py [--program PROGRAM] [--ranks N] [CASE ...]

Prints one line per quantity: computed, reference, deviation, what is allowed.
Exit status 1 if a deviation is too large. Without CASE, all of them run.
"""

import argparse
import csv
import math
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
CASES = ROOT / "parameter_files"
E, NU = 200000.0, 0.3
E_STAR = E / (1 - NU**2)


class Runner:
    """Runs the program and collects what is compared."""

    def __init__(self, program, ranks):
        self.program = program
        self.ranks = ranks
        self.failed = False

    def run(self, case, *entries):
        """Rows of statistics.csv, the last one extended by that of history.csv."""
        with tempfile.TemporaryDirectory() as folder:
            command = ["mpirun", "-np", str(self.ranks)] if self.ranks > 1 else []
            command += [self.program, CASES / case, "--quiet", "--output-directory", folder]
            command += ["--overwrite", "--set", "Output/Fields=never"]
            for entry in entries:
                command += ["--set", entry]
            environment = dict(
                os.environ,
                OMP_NUM_THREADS="1",
                OMPI_ALLOW_RUN_AS_ROOT="1",
                OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                OMPI_MCA_rmaps_base_oversubscribe="1",
                OMPI_MCA_ess_singleton_isolated="1",
            )
            subprocess.run(list(map(str, command)), check=True, env=environment)
            rows = read_table(pathlib.Path(folder) / "statistics.csv")
            rows[-1].update(read_table(pathlib.Path(folder) / "history.csv")[-1])
        for row in rows:
            self.compare("force balance", row["force_balance_error"], 0, 1e-8, absolute=True)
            self.compare("complementarity", row["complementarity_error"], 0, 1e-8, absolute=True)
        return rows

    def compare(self, name, value, reference, allowed, absolute=False):
        """Reports a value whose relative (or absolute) deviation is limited."""
        deviation = value - reference if absolute else value / reference - 1
        self.verify(f"{name}: {value:.9g}, reference {reference:.9g}, "
                    f"deviation {deviation:.1e}, allowed {allowed:.1e}",
                    abs(deviation) <= allowed)

    def verify(self, text, holds):
        """Reports a property."""
        print(f"  {text}: {'ok' if holds else 'FAILED'}", flush=True)
        self.failed = self.failed or not holds


def read_table(name):
    """The rows of a CSV file as dictionaries of numbers."""
    with open(name, encoding="ascii") as file:
        return [{k: float(v) for k, v in row.items()} for row in csv.DictReader(file)]


def step42(runner):
    """step-42's sphere, uniform Q1 meshes: published contact forces."""
    rows = runner.run("step42/sphere_uniform_q1.prm", "Refinement/Number of cycles=3")
    for row, force in zip(rows, (37.3058, 62.3128, 59.0988)):
        runner.compare("contact force", row["force"], force, 2e-5)


def step42_fine(runner):
    """The same to 64^3 cells (minutes)."""
    rows = runner.run("step42/sphere_uniform_q1.prm", "Refinement/Number of cycles=4")
    runner.compare("contact force", rows[-1]["force"], 56.761, 2e-5)


def confined_block(runner):
    """Uniaxial strain 0.005 and 0.01 (exact)."""
    for depth, stress in ((0.005, 1102.1150033), (0.01, 1939.8545936)):
        row = runner.run("verification/confined_block.prm", f"Loading/Depth={depth}")[-1]
        runner.compare("force", row["force"], stress, 1e-8)


def uniaxial(runner):
    """Uniaxial stress at the strain 0.02, driven by a displacement (exact)."""
    for law, stress in (
        ("perfectly plastic", 400),
        ("isotropic hardening", 435.6435644),
        ("kinematic hardening", 435.6435644),
        ("combined hardening", 435.6435644),
    ):
        modulus = 1000 if law == "combined hardening" else 2000
        row = runner.run(
            "verification/uniaxial_stress.prm",
            f"Material/Law={law}",
            f"Material/Isotropic hardening modulus={modulus}",
            f"Material/Kinematic hardening modulus={modulus}",
        )[-1]
        # the work density: elastic part plus the area under the plastic branch
        runner.compare(f"plastic strain, {law}", row["max_equivalent_plastic_strain"],
                       0.02 - stress / E, 1e-9)


def hertz(runner):
    """Hertz' paraboloid: force against contact radius and peak pressure (exact)."""
    row = runner.run("verification/hertz_sphere.prm")[-1]
    force, radius = 4 * row["force"], 10.0
    peak = (6 * force * E_STAR**2 / (math.pi**3 * radius**2)) ** (1 / 3)
    contact_radius = (3 * force * radius / (4 * E_STAR)) ** (1 / 3)
    runner.compare("peak pressure", row["max_pressure"], peak, 0.02)
    runner.compare("contact radius", math.sqrt(4 * row["contact_area"] / math.pi),
                   contact_radius, 0.02)
    first_yield(runner, peak)


def first_yield(runner, peak):
    """The body first yields at p0 = 1.612797 Y (exact)."""
    for factor, yields in ((0.97, False), (1.03, True)):
        row = runner.run("verification/hertz_sphere.prm", "Material/Law=perfectly plastic",
                         f"Material/Yield stress={peak / 1.612797 / factor}")[-1]
        runner.verify(f"plastic volume at {factor} of the load of first yield: "
                      f"{row['plastic_volume']:.2e}", (row["plastic_volume"] > 0) == yields)


def strip_punch(runner):
    """Prandtl's limit load (exact) with elements that do not lock."""
    limit = (2 + math.pi) / math.sqrt(3)
    for name, entries in (
        ("B-bar", ()),
        ("Q2", ("Discretization/Polynomial degree=2", "Discretization/Volumetric treatment=standard")),
    ):
        forces = [runner.run("verification/strip_punch.prm", f"Loading/Depth={depth}", *entries)[-1]["force"]
                  for depth in (0.12, 0.16)]
        runner.compare(f"force, {name}", forces[1], 1.025 * limit, 0.025)
        runner.verify(f"levels off ({forces[0]:.6f}, {forces[1]:.6f})", forces[1] / forces[0] < 1.002)


def strip_punch_locks(runner):
    """Standard linear elements lock: no limit load."""
    forces = [runner.run("verification/strip_punch.prm", f"Loading/Depth={depth}",
                         "Discretization/Volumetric treatment=standard")[-1]["force"]
              for depth in (0.12, 0.16)]
    runner.verify(f"does not level off ({forces[0]:.6f}, {forces[1]:.6f})", forces[1] / forces[0] > 1.01)


ALL = {
    function.__name__: function
    for function in (step42, step42_fine, confined_block, uniaxial, hertz, strip_punch,
                     strip_punch_locks)
}


def main():
    """Runs the chosen cases."""
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cases", nargs="*", metavar="CASE",
                        help=", ".join(f"{n} ({f.__doc__.strip()})" for n, f in ALL.items()))
    parser.add_argument("--program", default=ROOT / "build" / "release" / "elasto_plastic_contact")
    parser.add_argument("--ranks", type=int, default=1)
    arguments = parser.parse_args()
    unknown = set(arguments.cases) - set(ALL)
    if unknown:
        parser.error(f"no such case: {', '.join(sorted(unknown))}; there are {', '.join(ALL)}")
    runner = Runner(arguments.program, arguments.ranks)
    for case in arguments.cases or ALL:
        print(f"{case}: {ALL[case].__doc__.strip()}", flush=True)
        ALL[case](runner)
    sys.exit(1 if runner.failed else 0)


if __name__ == "__main__":
    main()
