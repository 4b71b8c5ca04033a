# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""One number of each of ten short runs, of all kinds there are, to compare systems: each line has the name of the case,
its number with all digits, and the seconds it took. A run can also be begun on one system and finished on another."""

import argparse
import os
import pathlib
import subprocess
import tempfile
import time

from elasto_plastic_contact.program import MPI_ENVIRONMENT, add_program, command_line, find_program, ready_case
from elasto_plastic_contact.tables import read_table

CONE = {"Geometry/Local refinements": 5, "Geometry/Local radius": 1, "Nonlinear solver/Tolerance": 1e-12}
CONE_DOWN = {**CONE, "Loading/History": "1: depth 0.1", "Loading/Number of steps": 40}
CONE_UP = {**CONE, "Loading/History": "1: depth 0.1 | 1.2: force 10", "Loading/Number of steps": 48}
EXACT = {"Nonlinear solver/Tolerance": 1e-12}

# The runs of a case one after the other (file, entries), each but the first resumed; its number: table and column.
TEN_CASES = {
    "plane": ([("cylinder_2d.prm", {**EXACT, "Refinement/Number of cycles": 4})], "history", "force"),
    "plane, given force": ([("flat_punch_force_2d.prm", {**EXACT, "Refinement/Number of cycles": 3})], "history", "depth"),
    "revolution": ([("indentation/sphere_axisymmetric.prm", {**EXACT, "Loading/Number of steps": 12})], "history", "force"),
    "space": ([("sphere_3d.prm", {**EXACT, "Refinement/Number of cycles": 3})], "history", "force"),
    "finite strain": ([("indentation/cone_finite_strain.prm", CONE_DOWN)], "history", "force"),
    "checkpoint and resume": ([("indentation/cone_finite_strain.prm", CONE_DOWN),
                               ("indentation/cone_finite_strain.prm", CONE_UP)], "history", "depth"),
    "friction": ([("friction/ssnv128.prm", EXACT)], "history", "tangential_force_x"),
    "limit load": ([("limit_load/strip_punch.prm", {"Refinement/Number of cycles": 4})], "limit_load", "upper_bound"),
    "limit load in space": ([("limit_load/circular_punch_3d.prm", {"Refinement/Number of cycles": 1})],
                            "limit_load", "lower_bound"),
    "error bound": ([("error_bound/sphere.prm", {**EXACT, "Refinement/Number of cycles": 3})], "error_bound", "bound"),
}


RESUMED = "checkpoint and resume"


def run_part(program, name, number, directory):
    """One of the runs of a case."""
    case, entries = TEN_CASES[name][0][number]
    options = ["--resume"] if number > 0 else []
    subprocess.run(command_line(program, ready_case(case, program), {"Output/Fields": "never", **entries},
                                directory, *options), env=os.environ | MPI_ENVIRONMENT, check=True)


def print_result(name, directory, seconds):
    _, table, column = TEN_CASES[name]
    value = read_table(pathlib.Path(directory) / f"{table}.csv")[-1][column]
    print(f"{name};{value!r};{seconds:.1f}", flush=True)


def run_parts(program, name, numbers, directory):
    start = time.monotonic()
    for number in numbers:
        run_part(program, name, number, directory)
    print_result(name, directory, time.monotonic() - start)


def main(arguments=None):
    parser = argparse.ArgumentParser(prog="ten_cases", description=__doc__)
    add_program(parser)
    half = parser.add_mutually_exclusive_group()
    half.add_argument("--begin", metavar="FOLDER", help=f"only the first run of '{RESUMED}', into a new folder")
    half.add_argument("--finish", metavar="FOLDER", help=f"only the second run of '{RESUMED}', with the folder of the first")
    options = parser.parse_args(arguments)
    program = find_program(options.program)
    if options.begin:
        run_part(program, RESUMED, 0, options.begin)
    elif options.finish:
        run_parts(program, RESUMED, [1], options.finish)
    else:
        for name, (runs, _, _) in TEN_CASES.items():
            with tempfile.TemporaryDirectory() as folder:
                run_parts(program, name, range(len(runs)), folder)
    return 0
