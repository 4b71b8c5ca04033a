# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finds and starts the program."""

import os
import pathlib
import shutil
import subprocess
import sys

from .errors import UserError
from .results import Results

# The checkout that this package lies in; installed elsewhere, its folders do not exist.
ROOT = pathlib.Path(__file__).resolve().parents[2]
CASES = ROOT / "parameter_files"
PROGRAM_VARIABLE = "ELASTO_PLASTIC_CONTACT"

# One thread a rank, also as root, on fewer cores than ranks, and in a container; on one machine, so that Open MPI need
# not look for networks at each start. (Version 5 has another name for what version 4 calls oversubscribe.)
MPI_ENVIRONMENT = {
    "OMP_NUM_THREADS": "1",
    "OMPI_ALLOW_RUN_AS_ROOT": "1",
    "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
    "OMPI_MCA_rmaps_base_oversubscribe": "1",
    "PRTE_MCA_rmaps_default_mapping_policy": ":oversubscribe",
    "OMPI_MCA_ess_singleton_isolated": "1",
    "OMPI_MCA_sharedfp": "^sm",
    "OMPI_MCA_pml": os.environ.get("OMPI_MCA_pml", "ob1"),
    "OMPI_MCA_btl": os.environ.get("OMPI_MCA_btl", "^tcp"),
}


class RunError(UserError):
    """The program has ended with an error: its message, and its exit status in 'status'."""

    def __init__(self, status, message):
        super().__init__(message or f"the program has ended with exit status {status}")
        self.status = status


def find_program(program=None):
    """The path of the program: what is given, or what the variable ELASTO_PLASTIC_CONTACT of the
    environment says, or the Release build of this checkout, or what the shell would find."""
    given = program or os.environ.get(PROGRAM_VARIABLE)
    built = ROOT / "build/release/elasto_plastic_contact"
    found = shutil.which(str(given or (built if built.exists() else "elasto_plastic_contact")))
    if found is None:
        raise UserError(f"there is no program '{given or 'elasto_plastic_contact'}': build it (scripts/run.sh), or "
                        f"say where it is, by --program, the argument 'program' or the variable {PROGRAM_VARIABLE}")
    return os.path.abspath(found)


def as_text(value):
    """A value as it stands in a parameter file: lists are separated by commas."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (list, tuple)):
        return ", ".join(map(as_text, value))
    return str(value)


def find_case(case):
    """The path of a parameter file, or of a ready case of that name."""
    for file in (pathlib.Path(case), CASES / case):
        if file.is_file():
            return file.absolute()
    raise UserError(f"there is no parameter file '{case}', neither here nor in {CASES}")


def command_line(program, case, entries, directory, *options, ranks=1, guard=()):
    """The command that runs a case with other values of some entries, by 'Section/Entry'.
    guard: a command that starts others, for mpirun and for each rank."""
    launcher = [*guard, "mpirun", "-np", str(ranks)] if ranks > 1 else []
    changes = [part for path, value in entries.items() for part in ("--set", f"{path}={as_text(value)}")]
    return [*launcher, *guard, str(program), str(case), *changes, "--quiet",
            "--output-directory", str(directory), *options]


def has_checkpoint(directory):
    """Whether a run has left something to resume from."""
    return any(pathlib.Path(directory).glob("checkpoint*/index"))


def check_arguments(case, directory, entries, ranks):
    for name, value in (("case", case), ("directory", directory)):
        if not isinstance(value, (str, os.PathLike)):
            raise UserError(f"'{name}' is {value!r}, but must be a path")
    if not isinstance(entries, (dict, type(None))):
        raise UserError(f"'entries' is {entries!r}, but must be a dictionary, 'Section/Entry' to value")
    if not isinstance(ranks, int) or ranks < 1:
        raise UserError(f"'ranks' is {ranks!r}, but must be an integer >= 1")


def run(case, directory, entries=None, *, ranks=1, overwrite=False, resume=False, program=None):
    """Run a parameter file and return its Results.

    case: the file, or the name of a ready case below parameter_files/.
    directory: where the results go.
    entries: what is changed in the case, by 'Section/Entry'; lists become values separated by commas.
    overwrite: replace results that are there; resume: go on from their last checkpoint.
    program: see find_program().

    Raises RunError with the program's own message, or UserError if there is no such case or program.
    """
    check_arguments(case, directory, entries, ranks)
    options = [option for option, chosen in (("--overwrite", overwrite), ("--resume", resume)) if chosen]
    command = command_line(find_program(program), find_case(case), entries or {}, directory, *options, ranks=ranks)
    process = subprocess.run(command, env=os.environ | MPI_ENVIRONMENT, stdout=subprocess.DEVNULL,
                             stderr=subprocess.PIPE, text=True, check=False)
    if process.returncode != 0:
        raise RunError(process.returncode, process.stderr.strip())
    sys.stderr.write(process.stderr)  # warnings
    return Results(directory)
