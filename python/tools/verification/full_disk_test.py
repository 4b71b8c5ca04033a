# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run a load history on disks of many sizes, all of them too small, and check
that each run ends with one message and exit status 5, that no process hangs,
and that the run can be resumed from its last checkpoint when there is room.

The disks are file systems in memory: this needs root, or a kernel on which a
user may mount in a namespace of his own (unshare)."""

import argparse
import os
import pathlib
import signal
import subprocess
import sys
import tempfile

from .kill_test import CASE, ENTRIES, differences, end
from elasto_plastic_contact.arguments import number
from elasto_plastic_contact.program import MPI_ENVIRONMENT, add_program, command_line, find_program, has_checkpoint, ready_case
from elasto_plastic_contact.tables import read_table

IO_FAILURE = 5
HANGS = "hangs"
NOTHING_TO_RESUME = 2
SIZES = range(50, 500, 25)  # KB; the whole run takes some more
TIMEOUT = 60
# With and without the shared file pointers of Open MPI, which once waited for ever.
SETTINGS = {"sharedfp=any": {"OMPI_MCA_sharedfp": ""},
            "sharedfp=^sm": {"OMPI_MCA_sharedfp": "^sm"}}


def run(program, ranks, directory, option, environment=None):
    variables = {**os.environ, **MPI_ENVIRONMENT, **(environment or {})}
    if not variables.get("OMPI_MCA_sharedfp"):
        variables.pop("OMPI_MCA_sharedfp", None)
    command = command_line(program, ready_case(CASE, program), {**ENTRIES, "Output/Fields": "last cycle"}, directory,
                           option, ranks=ranks)
    process = subprocess.Popen(command, env=variables, stderr=subprocess.PIPE, text=True)
    try:
        _, errors = process.communicate(timeout=TIMEOUT)
    except subprocess.TimeoutExpired:
        end(process, signal.SIGKILL)
        return HANGS, ""
    return process.returncode, errors


def failures_of_run(program, ranks, environment, size, folder, reference):
    """What goes wrong with a disk of this size (KB), and whether the run could be resumed."""
    disk = folder / "disk"
    disk.mkdir()
    subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size}k", "tmpfs", str(disk)],
                   check=True)
    try:
        status, errors = run(program, ranks, disk / "run", "--overwrite", environment)
        failures = []
        if status != IO_FAILURE:
            failures.append(f"{status}: {errors[:300]}")
        elif errors.count("Error: ") != 1:
            failures.append(f"{errors.count('Error: ')} messages")
        subprocess.run(["mount", "-o", "remount,size=1g", str(disk)], check=True)
        status, errors = run(program, 3 - ranks, disk / "run", "--resume")
        if status == NOTHING_TO_RESUME:
            if has_checkpoint(disk / "run"):
                failures.append(f"not resumed: {errors[:300]}")
            return failures, False
        if status != 0:
            return [*failures, f"resumed: {status}: {errors[:300]}"], False
        return failures + list(differences(reference, disk / "run", 1e-10)), True
    finally:
        subprocess.run(["umount", str(disk)], check=True)
        disk.rmdir()


def main(arguments):
    parser = argparse.ArgumentParser(prog="full_disk_test", description=__doc__)
    add_program(parser)
    parser.add_argument("--sizes", type=number(int, least=1), nargs="+", default=list(SIZES),
                        help="of the disks, in KB")
    options = parser.parse_args(arguments)
    options.program = find_program(options.program)
    if not os.environ.get("FULL_DISK_TEST_INSIDE"):
        return subprocess.call(["unshare", "--mount", "--map-root-user", *sys.orig_argv],
                               env={**os.environ, "FULL_DISK_TEST_INSIDE": "1"})

    n_failures = 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        reference = folder / "reference"
        status, errors = run(options.program, 1, reference, "--overwrite")
        if status != 0:
            print(f"{status}: {errors}")
            return 1
        print(f"with room: {len(read_table(reference / 'history.csv'))} steps")
        for setting, environment in SETTINGS.items():
            for ranks in (1, 2):
                n_resumed = 0
                for size in options.sizes:
                    failures, resumed = failures_of_run(
                        options.program, ranks, environment, size, folder, reference)
                    n_resumed += resumed
                    n_failures += len(failures)
                    for text in failures:
                        print(f"FAILED: {setting}, {ranks} ranks, {size} KB: {text}")
                print(f"{setting}, {ranks} ranks: {len(options.sizes)} full disks, "
                      f"{n_resumed} runs resumed", flush=True)
    print(f"{n_failures} failures")
    return 1 if n_failures else 0
