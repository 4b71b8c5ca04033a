# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run elasto_plastic_contact and deal.II's step-42 in turn on the same cases
and print a table of both. Called by compare_with_step42.sh, which builds them.
"""

import argparse
import itertools
import os
import re
import subprocess
import tempfile
import time
from dataclasses import dataclass

from elasto_plastic_contact.arguments import number
from elasto_plastic_contact.errors import UserError
from elasto_plastic_contact.program import command_line, ready_case
from elasto_plastic_contact.tables import read_table


@dataclass(frozen=True)
class Case:
    """A case of step-42's own parameter files. With default_cycles, step-42
    runs for some minutes on two cores."""
    degree: int
    initial_refinements: int
    strategy: str
    default_cycles: int


CASES = {
    "uniform_q1": Case(1, 3, "global", 4),
    "adaptive_q1": Case(1, 3, "percentage", 6),
    "uniform_q2": Case(2, 3, "global", 2),
    "adaptive_q2": Case(2, 2, "percentage", 5),
}

# What counts as the converged contact force: that of this program on a finer
# mesh; and how far from it a force may be.
REFERENCE_CASE, REFERENCE_CYCLES, ACCURACY = "adaptive_q2", 7, 2e-3

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
    """megabytes: the largest resident memory of a rank; start_megabytes: what
    of it the program needs for hardly any mesh."""
    meshes: list
    seconds: float
    megabytes: float
    start_megabytes: float = 0.

    def kilobytes_per_unknown(self, ranks):
        return (self.megabytes - self.start_megabytes) * ranks * 1024. / self.meshes[-1].dofs


def parse_arguments(arguments):
    parser = argparse.ArgumentParser(prog="compare_with_step42", description=__doc__)
    parser.add_argument("program", help="elasto_plastic_contact")
    parser.add_argument("step42", help="step-42")
    parser.add_argument("cases", nargs="*", metavar="CASE[=CYCLES]",
                        help=f"{', '.join(CASES)} (default: all); CYCLES is the number of meshes")
    parser.add_argument("--ranks", type=number(int, least=1), default=2, help="number of MPI ranks (default: %(default)s)")
    return parser.parse_args(arguments)


def choose_cases(texts):
    """Names and numbers of cycles of the cases to run."""
    chosen = []
    for text in texts or CASES:
        name, _, cycles = text.partition("=")
        if name not in CASES:
            raise UserError(f"there is no case '{name}'; there are: {', '.join(CASES)}")
        if cycles and not re.fullmatch("[1-9][0-9]*", cycles):
            raise UserError(f"the number of cycles in '{text}' must be a positive integer")
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
        raise UserError(f"{' '.join(command)} failed; its last words:\n" + "\n".join(text.splitlines()[-20:]))
    return text, seconds, usage.ru_maxrss / 1024.


def find_one(pattern, text):
    match = re.search(pattern, text)
    if not match:
        raise UserError(f"step-42 did not print what was expected ('{pattern}')")
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
    with tempfile.TemporaryDirectory() as folder:
        command = command_line(program, ready_case(f"step42/sphere_{name}.prm", program),
                               {"Refinement/Number of cycles": cycles}, "output")
        _, seconds, megabytes = run_measured(command, ranks, folder)
        rows = read_table(os.path.join(folder, "output", "statistics.csv"))
    meshes = [Mesh(int(row["dofs"]), row["force"], int(row["newton_iterations"]),
                   int(row["linear_iterations"]), row["wall_seconds"]) for row in rows]
    return Run(meshes, seconds, megabytes)


def run_with_start(run, program, name, cycles, ranks):
    result = run(program, name, cycles, ranks)
    result.start_megabytes = run(program, name, 1, ranks).megabytes
    return result


def first_accurate_mesh(meshes, reference):
    """Index of the first mesh from which on all forces are accurate, or None."""
    first = len(meshes)
    while first > 0 and abs(meshes[first - 1].force / reference - 1.) <= ACCURACY:
        first -= 1
    return first if first < len(meshes) else None


def format_mesh(mesh):
    if mesh is None:
        return f"{'-':>10}{'':36}"
    return (f"{mesh.dofs:>10} {mesh.force:>10.4f} {mesh.newton_steps:>7} "
            f"{mesh.linear_iterations:>7} {mesh.seconds:>8.2f}")


def print_case(name, ours, step42, ranks):
    columns = f"{'unknowns':>10} {'force':>10} {'Newton':>7} {'linear':>7} {'s':>8}"
    print(f"\n{name}\n{'':5}{'elasto_plastic_contact':>46}   {'step-42':>46}\n{'mesh':5}{columns}   {columns}")
    for i, meshes in enumerate(itertools.zip_longest(ours.meshes, step42.meshes), start=1):
        print(f"{i:<5}" + "   ".join(map(format_mesh, meshes)))
    totals = (f"{f'{run.megabytes:.0f} MB a rank, {run.kilobytes_per_unknown(ranks):.2f} KB/unknown':>37} "
              f"{run.seconds:>8.2f}" for run in (ours, step42))
    print(f"{'all':5}" + "   ".join(totals))
    memory = ""
    if len(ours.meshes) > 1:
        ratio = step42.kilobytes_per_unknown(ranks) / ours.kilobytes_per_unknown(ranks)
        memory = f" and {ratio:.1f} times the memory beyond that of the first mesh"
    print(f"{'':5}step-42 took {step42.seconds / ours.seconds:.1f} times as long{memory}.", flush=True)


def times_to_accuracy(runs, program, ranks):
    """The reference mesh, and by program the sorted seconds and cases in which its contact force is accurate."""
    reference = run_ours(program, REFERENCE_CASE, REFERENCE_CYCLES, ranks).meshes[-1]
    times = {"ours": [], "step-42": []}
    for name, (ours, step42) in runs.items():
        mesh = first_accurate_mesh(ours.meshes, reference.force)
        if mesh is not None:
            times["ours"].append((run_ours(program, name, mesh + 1, ranks).seconds, name))
        mesh = first_accurate_mesh(step42.meshes, reference.force)
        if mesh is not None:
            times["step-42"].append((sum(m.seconds for m in step42.meshes[:mesh + 1]), name))
    return reference, {who: sorted(values) for who, values in times.items()}


def print_accuracy(runs, program, ranks):
    """How long both take to an accurate contact force, each in its best case."""
    reference, times = times_to_accuracy(runs, program, ranks)
    print(f"\nTime to a contact force within {100 * ACCURACY:g} % of {reference.force:.4f} "
          f"({REFERENCE_CASE}, {reference.dofs} unknowns)")
    for who, values in times.items():
        for seconds, name in values:
            print(f"     {who:10} {name:12} {seconds:8.2f} s")
    if all(times.values()):
        print(f"     step-42 took {times['step-42'][0][0] / times['ours'][0][0]:.1f} times as long.")


def run_both(program, step42, name, cycles, ranks):
    """This program and step-42 on a case."""
    return (run_with_start(run_ours, program, name, cycles, ranks), run_with_start(run_step42, step42, name, cycles, ranks))


def main(arguments):
    arguments = parse_arguments(arguments)
    program, step42 = os.path.abspath(arguments.program), os.path.abspath(arguments.step42)
    if arguments.ranks < 1:
        raise UserError(f"--ranks is {arguments.ranks}, but must be at least 1")
    cases = choose_cases(arguments.cases)
    print(f"Ranks: {arguments.ranks}. step-42 runs with 'transfer solution = true', its better setting.\n"
          "linear: iterations of all Newton steps; one of step-42 (BiCGStab) has two matrix products, one of\n"
          "this program (CG) has one. s: wall time, in the rows of the cycle (step-42: set-up, solution and\n"
          "output; this program: solution), in the last row of the whole run, start and output included.")
    runs = {}
    for name, cycles in cases:
        runs[name] = run_both(program, step42, name, cycles, arguments.ranks)
        print_case(name, *runs[name], arguments.ranks)
    print_accuracy(runs, program, arguments.ranks)
