# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long a run will take: so many microseconds of one processor for each unknown of its last mesh and each load step,
measured with files of each kind, times what a short run takes on this machine over what it took there."""

import os
import re
import subprocess
import tempfile

from ..errors import UserError
from ..program import MPI_ENVIRONMENT, processor_seconds, ready_case

# Microseconds of one processor per unknown and load step, by Case.kind_of_time (doc/lookup/new_cases.md).
MICROSECONDS = {
    "small strains, plane": 10.,
    "finite strains, plane": 35.,
    "small strains, space": 45.,
    "finite strains, space": 50.,
    "pyramid": 60.,
    "corner of a cube": 120.,
}

# What has another cost: seconds as a whole.
SECONDS = {"one cell": 0.5, "strip punch, coarse": 7., "strip punch, usual": 25., "strip punch, fine": 45.,
           "circular punch, coarse": 13., "circular punch, usual": 45., "circular punch, fine": 80.}

# The short run, and what it took where the numbers above have been measured.
SHORT_RUN = ("indentation/sphere_axisymmetric.prm", {"Loading/History": "1: depth 0.0005",
                                                     "Loading/Number of steps": "8",
                                                     "Loading/Integration": "backward Euler",
                                                     "Refinement/Elements over contact radius": "20",
                                                     "Output/Fields": "never"})
SECONDS_OF_SHORT_RUN = 2.5


def speed_of_this_machine(program):
    """How many times as long a run takes here, by the short run, in about a second."""
    case, entries = SHORT_RUN
    with tempfile.TemporaryDirectory() as folder:
        command = [program, ready_case(case, program), "--quiet", "--output-directory", folder, "--overwrite"]
        command += [part for path, value in entries.items() for part in ("--set", f"{path}={value}")]
        before = processor_seconds()
        subprocess.run(command, check=True, env=os.environ | MPI_ENVIRONMENT, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL)
        return (processor_seconds() - before) / SECONDS_OF_SHORT_RUN


def check_file(program, path, surface=None):
    """What --validate says of the file: its report, and its warnings. surface: a file of the user that it names. Raises
    UserError."""
    process = subprocess.run([program, path, "--validate"], env=os.environ | MPI_ENVIRONMENT, capture_output=True,
                             text=True,
                             check=False)
    if process.returncode != 0:
        reason = "which should not happen" if surface is None else f"perhaps for the surface '{surface}'"
        raise UserError(f"the program refuses the file, {reason}: {process.stderr.strip()}")
    return process.stdout, process.stderr.strip()


def unknowns_and_steps(report):
    """Of the last mesh, from the report of --validate."""
    meshes = re.findall(r"^(?:First|Last) mesh .*?([0-9]+) unknowns", report, re.MULTILINE)
    steps = re.findall(r"^Load steps +([0-9]+)", report, re.MULTILINE)
    return int(meshes[-1]), int(steps[0])


def expected_seconds(kind_of_time, report, speed):
    """Of one processor of this machine."""
    if kind_of_time in SECONDS:
        return speed * SECONDS[kind_of_time]
    unknowns, steps = unknowns_and_steps(report)
    return speed * 1e-6 * MICROSECONDS[kind_of_time] * unknowns * steps


def in_words(seconds):
    return f"{max(seconds, 1.):.0f} s" if seconds < 90. else f"{seconds / 60.:.0f} minutes"
