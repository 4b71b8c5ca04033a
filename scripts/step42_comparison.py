#!/usr/bin/python3
# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run elasto_plastic_contact and deal.II's step-42 in turn on the same cases
and print a table of both. Called by compare_with_step42.sh, which builds them.
"""

import argparse
import csv
import itertools
import os
import re
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass


class ComparisonError(Exception):
    """Something the user can mend; the message says how."""


@dataclass(frozen=True)
class Case:
    """A case of step-42's own parameter files. default_cycles keeps the run of
    step-42 below a few minutes on two cores."""
    degree: int
    initial_refinements: int
    strategy: str
    default_cycles: int


CASES = {
    "uniform_q1": Case(1, 3, "global", 4),
    "adaptive_q1": Case(1, 3, "percentage", 5),
    "uniform_q2": Case(2, 3, "global", 2),
    "adaptive_q2": Case(2, 2, "percentage", 4),
}

STEP42_PARAMETERS = """\
set polynomial degree             = {case.degree}
set number of initial refinements = {case.initial_refinements}
set number of cycles              = {cycles}
set refinement strategy           = {case.strategy}
set obstacle                      = sphere
set output directory              = output
set transfer solution             = true
"""


@dataclass
class Mesh:
    """What one program did on one mesh."""
    dofs: int
    force: float
    newton_steps: int
    linear_iterations: int
    seconds: float


@dataclass
class Run:
    meshes: list
    seconds: float
    megabytes: float


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", help="elasto_plastic_contact")
    parser.add_argument("step42", help="step-42")
    parser.add_argument("cases", nargs="*", metavar="CASE[=CYCLES]",
                        help=f"{', '.join(CASES)} (default: all); CYCLES is the number of meshes")
    parser.add_argument("--ranks", type=int, default=2, help="number of MPI ranks (default: %(default)s)")
    return parser.parse_args()


def choose_cases(texts):
    """Names and numbers of cycles of the cases to run."""
    chosen = []
    for text in texts or CASES:
        name, _, cycles = text.partition("=")
        if name not in CASES:
            raise ComparisonError(f"there is no case '{name}'; there are: {', '.join(CASES)}")
        if cycles and not re.fullmatch("[1-9][0-9]*", cycles):
            raise ComparisonError(f"the number of cycles in '{text}' must be a positive integer")
        chosen.append((name, int(cycles) if cycles else CASES[name].default_cycles))
    return chosen


def run_measured(command, ranks, folder):
    """Standard output, wall time in seconds and the largest resident memory of
    a rank in MB."""
    log = os.path.join(folder, "output.txt")
    with open(log, "w", encoding="utf-8") as output:
        start = time.monotonic()
        process = subprocess.Popen(["mpirun", "--oversubscribe", "-np", str(ranks)] + command,
                                   cwd=folder, stdout=output, stderr=subprocess.STDOUT)
        _, status, usage = os.wait4(process.pid, 0)
        seconds = time.monotonic() - start
    with open(log, encoding="utf-8") as output:
        text = output.read()
    if status != 0:
        raise ComparisonError(f"{' '.join(command)} failed; its last words:\n" + "\n".join(text.splitlines()[-20:]))
    return text, seconds, usage.ru_maxrss / 1024.


def find_one(pattern, text):
    match = re.search(pattern, text)
    if not match:
        raise ComparisonError(f"step-42 did not print what was expected ('{pattern}')")
    return match.group(1)


def in_seconds(text):
    """step-42's timer prints '12.3s', and long times as '1.23e+03s'."""
    return float(text.rstrip("s"))


def read_step42_cycle(text):
    return Mesh(dofs=int(find_one(r"Number of degrees of freedom: (\d+)", text)),
                force=float(find_one(r"Contact force = (\S+)", text)),
                newton_steps=len(re.findall(r"Newton iteration \d+", text)),
                linear_iterations=sum(int(n) for n in re.findall(r"in (\d+) Bicgstab iterations", text)),
                seconds=in_seconds(find_one(r"Total wallclock time elapsed since start\s*\|\s*([^ |]+)", text)))


def run_step42(program, name, cycles, ranks):
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "case.prm"), "w", encoding="utf-8") as file:
            file.write(STEP42_PARAMETERS.format(case=CASES[name], cycles=cycles))
        text, seconds, megabytes = run_measured([program, "case.prm"], ranks, folder)
    parts = re.split(r"^Cycle \d+:", text, flags=re.MULTILINE)[1:]
    return Run([read_step42_cycle(part) for part in parts], seconds, megabytes)


def run_ours(program, name, cycles, ranks):
    case_file = os.path.abspath(os.path.join("parameter_files", "step42", f"sphere_{name}.prm"))
    with tempfile.TemporaryDirectory() as folder:
        command = [program, case_file, "--output-directory", "output",
                   "--set", f"Refinement/Number of cycles={cycles}"]
        _, seconds, megabytes = run_measured(command, ranks, folder)
        with open(os.path.join(folder, "output", "statistics.csv"), newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
    meshes = [Mesh(int(float(row["dofs"])), float(row["force"]), int(float(row["newton_iterations"])),
                   int(float(row["linear_iterations"])), float(row["wall_seconds"])) for row in rows]
    return Run(meshes, seconds, megabytes)


def format_mesh(mesh):
    if mesh is None:
        return f"{'-':>10}{'':36}"
    return (f"{mesh.dofs:>10} {mesh.force:>10.4f} {mesh.newton_steps:>7} "
            f"{mesh.linear_iterations:>7} {mesh.seconds:>8.2f}")


def print_case(name, ours, step42):
    columns = f"{'unknowns':>10} {'force':>10} {'Newton':>7} {'linear':>7} {'s':>8}"
    print(f"\n{name}\n{'':5}{'elasto_plastic_contact':>46}   {'step-42':>46}\n{'mesh':5}{columns}   {columns}")
    for i, meshes in enumerate(itertools.zip_longest(ours.meshes, step42.meshes), start=1):
        print(f"{i:<5}" + "   ".join(map(format_mesh, meshes)))
    totals = (f"{f'{run.megabytes:.0f} MB a rank':>37} {run.seconds:>8.2f}" for run in (ours, step42))
    print(f"{'all':5}" + "   ".join(totals))
    print(f"{'':5}step-42 took {step42.seconds / ours.seconds:.1f} times as long "
          f"and {step42.megabytes / ours.megabytes:.1f} times the memory.", flush=True)


def main():
    arguments = parse_arguments()
    program, step42 = os.path.abspath(arguments.program), os.path.abspath(arguments.step42)
    try:
        if arguments.ranks < 1:
            raise ComparisonError(f"--ranks is {arguments.ranks}, but must be at least 1")
        cases = choose_cases(arguments.cases)
        print(f"Ranks: {arguments.ranks}. step-42 runs with 'transfer solution = true', its better setting.\n"
              "linear: iterations of all Newton steps; one of step-42 (BiCGStab) has two matrix products, one of\n"
              "this program (CG) has one. s: wall time, in the rows of the cycle (step-42: set-up, solution and\n"
              "output; this program: solution), in the last row of the whole run, start and output included.")
        for name, cycles in cases:
            print_case(name, run_ours(program, name, cycles, arguments.ranks),
                       run_step42(step42, name, cycles, arguments.ranks))
    except ComparisonError as error:
        sys.exit(f"compare_with_step42: {error}")


if __name__ == "__main__":
    main()
