# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Kill a load history at random moments, also while it writes a checkpoint,
resume it with another number of ranks, and compare the final results with those
of an uninterrupted run."""

import argparse
import functools
import os
import pathlib
import random
import signal
import subprocess
import tempfile
import time

from elasto_plastic_contact.arguments import number
from elasto_plastic_contact.program import MPI_ENVIRONMENT, add_program, command_line, find_program, has_checkpoint, ready_case
from elasto_plastic_contact.tables import read_table

CASE = "indentation/sphere_axisymmetric.prm"
# Small, with a mesh that follows the contact, so that checkpoints take a good
# part of the time.
ENTRIES = {
    "Geometry/Initial refinements": 3, "Geometry/Local refinements": 6, "Geometry/Local radius": 4,
    "Refinement/Elements over contact radius": 0,
    "Loading/History": "1: depth 0.002 | 2: force 0.5 | 3: depth 0.002",
    "Loading/Number of steps": 18, "Nonlinear solver/Tolerance": 1e-12,
    "Refinement/Strategy": "Kelly", "Refinement/Refinement fraction": 0.1,
    "Refinement/Coarsening fraction": 0.3, "Refinement/Steps between adaptations": 4,
    "Refinement/Maximum number of unknowns": 1200,
    "Output/Minutes between checkpoints": 0,
}
# What a clock says, or what depends on how the process has lived; what would be zero
# without rounding; and numbers of iterations, which rounding, and so the number of ranks, can
# change by one.
NOT_COMPARED = {"wall_seconds", "memory_mb", "residual", "force_balance_error",
                "max_penetration", "edge_penetration", "max_hanging_penetration", "complementarity_error",
                "newton_iterations", "linear_iterations"}
# These are computed in single precision.
SINGLE_PRECISION = {"estimated_error"}
TERMINATED = 143
MPIRUN_TERMINATED = 1  # of mpirun itself, whatever the program returns


def command(program, ranks, directory, option):
    return command_line(program, ready_case(CASE, program), ENTRIES, directory, option, ranks=ranks)


def descendants(pid):
    """All processes that have been started by pid, and itself."""
    children = {}
    for stat in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = stat.read_text().rsplit(")", 1)[1].split()
        except OSError:
            continue  # it has just ended
        children.setdefault(int(fields[1]), []).append(int(stat.parent.name))
    found = [pid]
    for parent in found:
        found += children.get(parent, [])
    return found


def end(process, number):
    """Send a signal: SIGKILL to all processes of the run at once, SIGTERM to
    the first of them only, as a batch system does."""
    pids = descendants(process.pid) if number == signal.SIGKILL else [process.pid]
    for pid in pids:
        try:
            os.kill(pid, number)
        except ProcessLookupError:
            pass
    process.wait()


def wait_for_random_moment(process, directory, chance, n_steps, seconds):
    """In one of the n_steps that are still to come, at any moment of the seconds that a step takes. (A clock alone
    would not do: the same run may take a second or a minute, as the machine has other work or not.)"""
    first = completed_steps(directory)
    step = chance.randint(first, max(first, n_steps - 1))
    while process.poll() is None and completed_steps(directory) < step:
        time.sleep(0.002)
    try:
        process.wait(chance.uniform(0, seconds))
    except subprocess.TimeoutExpired:
        pass


def wait_for_checkpoint(process, directory):
    """Until the folder of the next checkpoint has appeared."""
    while process.poll() is None and not (directory / "checkpoint.new").exists():
        time.sleep(0.0005)


def differences(reference, directory, allowed):
    """What differs between the tables of two runs by more than allowed, relative
    to the largest number of the column."""
    for name in (table.name for table in reference.glob("*.csv")):
        if not (directory / name).exists():
            yield f"{name} is missing"
            continue
        expected, found = read_table(reference / name), read_table(directory / name)
        if len(expected) != len(found):
            yield f"{name}: {len(found)} rows instead of {len(expected)}"
            continue
        for column in expected[0].keys() - NOT_COMPARED if expected else ():
            pairs = [(row[column], other[column])
                     for row, other in zip(expected, found)]
            largest = max(abs(a) for a, _ in pairs)
            tolerance = 1e-6 if column in SINGLE_PRECISION else allowed
            for number, (a, b) in enumerate(pairs, 1):
                if abs(a - b) > tolerance * largest:
                    yield f"{name}, row {number}, {column}: {b} instead of {a}"
    for file in reference.glob("*.pvd"):
        if entries_of_collection(file) != entries_of_collection(directory / file.name):
            yield f"{file.name} differs"


def entries_of_collection(file):
    """All lines of a .pvd file but the comment that says when it has been written."""
    return [line for line in file.read_text().splitlines() if not line.startswith("#")]


def main(arguments):
    parser = argparse.ArgumentParser(prog="kill_test", description=__doc__)
    add_program(parser)
    parser.add_argument("--kills", type=number(int, least=1), default=50)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args(arguments)
    options.program = find_program(options.program)
    chance = random.Random(options.seed)
    os.environ.update(MPI_ENVIRONMENT)

    with tempfile.TemporaryDirectory() as folder:
        reference = pathlib.Path(folder) / "reference"
        begin = time.time()
        subprocess.run(command(options.program, 2, reference, "--overwrite"),
                       check=True)
        duration = time.time() - begin
        n_steps = len(read_table(reference / "history.csv"))
        wait = functools.partial(wait_for_random_moment, chance=chance, n_steps=n_steps, seconds=duration / n_steps)
        print(f"uninterrupted: {n_steps} steps, {duration:.1f} s", flush=True)

        counts = dict.fromkeys(("any moment", "checkpoint", "SIGTERM"), 0)
        failures, n_runs = [], 0
        while sum(counts.values()) < options.kills:
            directory = pathlib.Path(folder) / f"run_{n_runs}"
            failures += [f"run {n_runs}: {text}" for text in interrupted_run(
                options, chance, directory, wait, counts)]
            failures += [f"run {n_runs}: {text}" for text in differences(
                reference, directory, 1e-10)]
            n_runs += 1
        print(f"{n_runs} runs, killed " + ", ".join(
            f"{n} times ({what})" for what, n in counts.items()))
    for text in failures[:40]:
        print("FAILED:", text)
    print(f"{len(failures)} failures")
    return 1 if failures else 0


def completed_steps(directory):
    """The complete rows of history.csv so far."""
    try:
        lines = (directory / "history.csv").read_text().splitlines(True)
    except FileNotFoundError:
        return 0
    return sum(line.endswith("\n") for line in lines[1:])


def interrupted_run(options, chance, directory, wait, counts):
    """Run the case, killed again and again after wait(process, directory), until it gets to its end; yield
    what goes wrong. A step is safe when the next one has begun."""
    most_steps = 0
    while True:
        resumable = has_checkpoint(directory) or most_steps > 1
        process = subprocess.Popen(command(
            options.program, chance.choice((1, 2)), directory,
            "--resume" if resumable else "--overwrite"))
        way = chance.choice(list(counts))
        number = signal.SIGTERM if way == "SIGTERM" else signal.SIGKILL
        wait(process, directory)
        if way == "checkpoint":
            wait_for_checkpoint(process, directory)
            time.sleep(chance.uniform(0, 0.01))
        killed = process.poll() is None
        if killed:
            end(process, number)
            counts[way] += 1
        if process.returncode == 0:
            return
        if not killed or process.returncode not in (-number, TERMINATED, MPIRUN_TERMINATED):
            yield (f"exit status {process.returncode} after {number.name} on "
                   f"{process.args}")
            return
        steps = completed_steps(directory)
        if steps < most_steps - 1:
            yield f"{steps} steps left of {most_steps}"
        most_steps = max(steps, most_steps)
