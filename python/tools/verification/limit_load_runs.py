# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Case of verify: what a limit load analysis says while it runs, and when it is ended."""

import os
import pathlib
import re
import subprocess
import tempfile
import time

from elasto_plastic_contact.program import MPI_ENVIRONMENT
from elasto_plastic_contact.tables import read_table


def start(runner, folder, n_cycles, *entries, case="strip_punch", n_threads=1):
    """A limit load on so many meshes, with one row on the screen for each."""
    command = [runner.program, runner.case(f"limit_load/{case}.prm"), "--output-directory", folder, "--overwrite"]
    for entry in (f"Refinement/Number of cycles={n_cycles}", "Output/Screen=summary", "Output/Fields=never", *entries):
        command += ["--set", entry]
    return subprocess.Popen(command, env=os.environ | MPI_ENVIRONMENT | {"OMP_NUM_THREADS": str(n_threads)}, text=True,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE)


def end_on_request(runner, n_threads=1):
    """SIGTERM after some meshes."""
    with tempfile.TemporaryDirectory() as folder:
        table = pathlib.Path(folder) / "limit_load.csv"
        process = start(runner, folder, 40, n_threads=n_threads)
        while process.poll() is None and (not table.exists() or len(read_table(table)) != 3):
            time.sleep(0.01)
        process.terminate()
        message = process.communicate()[1]
        last = read_table(table)[-1]
        runner.verify("exit status after SIGTERM", process.returncode == 143)
        said = re.search(r"The limit load is between\s+(\S+)\s+and\s+([^\s,]+)", message)
        runner.verify("says its bounds", said is not None)
        if said:
            for number, name in enumerate(("lower_bound", "upper_bound"), 1):
                runner.compare(f"{name} of the last mesh", float(said.group(number)), last[name], 1e-9)


def limit_load_runs(runner):
    """The summary of a limit load has the bounds, and SIGTERM leaves the last ones."""
    with tempfile.TemporaryDirectory() as folder:
        table = pathlib.Path(folder) / "limit_load.csv"
        screen = start(runner, folder, 2).communicate()[0].splitlines()
        runner.verify("names of the columns", screen[:1] == ["cycle cells triangles lower_bound upper_bound"])
        shown = [[float(number) for number in line.split()] for line in screen[1:]]
        computed = [[row[name] for name in screen[0].split()] for row in read_table(table)]
        runner.verify("one row for each mesh", len(shown) == len(computed) == 2)
        runner.compare("bounds on the screen", max(abs(a / b - 1) for a, b in zip(sum(shown, []), sum(computed, [])) if b),
                       0, 1e-9, absolute=True)

    end_on_request(runner)


def limit_load_passes(runner):
    """Several passes of refinement: the same meshes on 1 and 2 ranks, bounds as close as by one pass on twice as many."""
    def last(n_cycles, *entries):
        return runner.tables("limit_load/circular_punch.prm", f"Refinement/Number of cycles={n_cycles}", *entries)["limit_load"][-1]

    passes = ("Refinement/Passes=3", "Refinement/Refinement fraction=0.4")
    alone = last(4, *passes)
    with runner.on_ranks(2):
        shared = last(4, *passes)
    for name in ("cells", "triangles"):
        runner.compare(f"{name} on 2 ranks", shared[name], alone[name], 0)
    for name in ("lower_bound", "upper_bound"):
        runner.compare(f"{name} on 2 ranks", shared[name], alone[name], 1e-9)
    one_pass = last(8)
    runner.compare("triangles, three passes over one", alone["triangles"] / one_pass["triangles"], 1, 0.15)
    runner.verify("a smaller difference of the bounds", alone["relative_difference"] < one_pass["relative_difference"])


def limit_load_threads(runner):
    """Both bounds of bodies in the plane, of revolution and in space side by side: the same numbers, and the same errors."""
    def run(case, n_threads, *entries, n_cycles=1):
        with tempfile.TemporaryDirectory() as folder:
            process = start(runner, folder, n_cycles, *entries, case=case, n_threads=n_threads)
            message = process.communicate()[1]
            rows = [row | {"wall_seconds": 0} for row in read_table(pathlib.Path(folder) / "limit_load.csv")]
        return process.returncode, rows, message

    for case, n_cycles in {"strip_punch": 3, "plate_with_hole": 1, "footing_circular": 3, "square_punch_3d": 1}.items():
        alone, shared = (run(case, n_threads, n_cycles=n_cycles) for n_threads in (1, 2))
        runner.verify(f"{case}: {n_cycles} meshes", alone[0] == shared[0] == 0 and len(alone[1]) == n_cycles)
        runner.verify(f"{case}: the same in all digits", alone == shared)
    enclosed = ("Boundary conditions/Roller=left, right", "Boundary conditions/Free=", "Indenter/Half width=10")
    alone, shared = run("strip_punch", 1, *enclosed), run("strip_punch", 2, *enclosed)
    runner.verify("no limit load", alone[0] == 3 and "There is no limit load" in alone[2])
    runner.verify("no limit load: the same message", alone == shared)
    end_on_request(runner, n_threads=2)
