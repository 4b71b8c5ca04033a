# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finds and starts the program."""

import difflib
import functools
import hashlib
import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys

from .errors import UserError
from .results import Results

# The checkout that this package lies in; installed elsewhere, its folders do not exist.
ROOT = pathlib.Path(__file__).resolve().parents[2]
INSTALLED_CASES = "share/elasto_plastic_contact/parameter_files"
PROGRAM_VARIABLE = "ELASTO_PLASTIC_CONTACT"

# One thread a rank unless the environment says otherwise, also as root, on fewer cores than ranks, and in a container; on one machine, so that Open MPI need
# not look for networks at each start. (Version 5 has another name for what version 4 calls oversubscribe, which version
# 6 calls deprecated.)
MPI_ENVIRONMENT = {
    "OMP_NUM_THREADS": os.environ.get("OMP_NUM_THREADS", "1"),
    "OMPI_ALLOW_RUN_AS_ROOT": "1",
    "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
    "OMPI_MCA_rmaps_base_oversubscribe": "1",
    "PRTE_MCA_rmaps_default_mapping_policy": ":oversubscribe",
    "PMIX_MCA_mca_base_suppress_deprecated_warning": "1",
    "OMPI_MCA_ess_singleton_isolated": "1",
    "OMPI_MCA_sharedfp": "^sm",
    "OMPI_MCA_pml": os.environ.get("OMPI_MCA_pml", "ob1"),
    "OMPI_MCA_btl": os.environ.get("OMPI_MCA_btl", "^tcp,ofi"),
}


class RunError(UserError):
    """The program has ended with an error: its message, and its exit status in 'status'."""

    def __init__(self, status, message):
        super().__init__(message or f"the program has ended with exit status {status}")
        self.status = status


def is_checkout():
    """Whether this package lies in a checkout."""
    return (ROOT / "parameter_files").is_dir()


def checkout():
    """The checkout that this package lies in, for what is not installed with it."""
    if not is_checkout():
        raise UserError(f"this works in a checkout of ElastoPlasticContact only (scripts/command.py), and the package in "
                        f"'{pathlib.Path(__file__).parent}' has none around it")
    return ROOT


def add_program(parser):
    """The argument --program."""
    parser.add_argument("--program", help="elasto_plastic_contact (default: what the variable "
                        f"{PROGRAM_VARIABLE} says, or the Release build of a checkout, "
                        "or what is installed with this command)")


def find_program(program=None):
    """The path of the program: what is given, or what the variable ELASTO_PLASTIC_CONTACT of the environment says, or the
    Release build of this checkout, or what is installed with this package, or what the shell would find."""
    given = program or os.environ.get(PROGRAM_VARIABLE)
    own = next(filter(pathlib.Path.exists, (ROOT / "build/release/elasto_plastic_contact",
                                            ROOT / "../../bin/elasto_plastic_contact")), "elasto_plastic_contact")
    found = shutil.which(str(given or own))
    if found is None:
        build = "build it (scripts/run.sh), or " if is_checkout() else ""
        raise UserError(f"there is no program '{given or 'elasto_plastic_contact'}': {build}say where it is, "
                        f"by --program, the argument 'program' or the variable {PROGRAM_VARIABLE}")
    return os.path.abspath(found)


def build_of(program=None):
    """What tells builds of the program apart, also those of one version: a hash of its file and of the library of its
    parts, if it has one; empty if there is no program. (Other libraries, such as deal.II, do not count.)"""
    try:
        path = find_program(program)
        files = [(file, os.stat(file)) for file in (path, *own_libraries(path))]
        return "".join(hash_of(file, facts.st_mtime_ns, facts.st_size) for file, facts in files)
    except (OSError, UserError):
        return ""


def own_libraries(path):
    """The shared libraries of this project that the loader takes for the program, of which a package has one for each
    kind of processor; none if it is linked as a whole, or is no program that 'ldd' knows."""
    if shutil.which("ldd") is None:
        return []
    listed = subprocess.run(["ldd", path], capture_output=True, text=True, check=False).stdout
    return re.findall(r"libelasto_plastic_contact\S* => (/.*) \(", listed)


@functools.cache
def hash_of(path, *_):
    """Of what stands in a file, once for each time at which it has been changed and each size."""
    with open(path, "rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def as_text(value):
    """A value as it stands in a parameter file: lists are separated by commas."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (list, tuple)):
        return ", ".join(map(as_text, value))
    return str(value)


def cases_folder(program=None):
    """The folder of the ready cases: that of this checkout, or, as for the program itself, what is installed with it."""
    if is_checkout():
        return ROOT / "parameter_files"
    folder = pathlib.Path(find_program(program)).resolve().parent.parent / INSTALLED_CASES
    if not folder.is_dir():
        raise UserError(f"there are no ready cases: they would be in '{folder}', but there is no such folder. Install "
                        "the program together with them, or give the file with its folder")
    return folder


def with_suffix(name):
    return name if name.endswith(".prm") else f"{name}.prm"


def ready_case(name, program=None):
    """The path of a ready case: by its name below the folder of all, also without '.prm', or by the last part of it."""
    folder, wanted = cases_folder(program), with_suffix(str(name))
    names = sorted(file.relative_to(folder).as_posix() for file in folder.rglob("*.prm"))
    found = [wanted] if wanted in names else [other for other in names if other.endswith(f"/{wanted}")]
    if len(found) > 1:
        raise UserError(f"the name '{name}' fits several ready cases: {', '.join(map(repr, found))}. Give one of these")
    if not found:
        last_parts = [other.rpartition("/")[2] for other in names]
        close = difflib.get_close_matches(wanted, [*names, *last_parts], n=1, cutoff=0.8)
        hint = f" Did you mean '{close[0]}'?" if close else ""
        raise UserError(f"there is no parameter file '{name}', and no ready case '{name}' in '{folder}'.{hint} "
                        "elasto_plastic_contact --list-cases lists the ready cases")
    return folder / found[0]


def find_case(case, places=(".",), program=None):
    """The path of a parameter file in the first of some folders that has it, also without '.prm', or of a ready case."""
    for file in (pathlib.Path(place, name) for place in places for name in (case, with_suffix(str(case)))):
        if file.is_file():
            return file.absolute()
    return ready_case(case, program)


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

    case: the file, or the name of a ready case, as 'elasto_plastic_contact --list-cases' prints it.
    directory: where the results go.
    entries: what is changed in the case, by 'Section/Entry'; lists become values separated by commas.
    overwrite: replace results that are there; resume: go on from their last checkpoint.
    program: see find_program().

    Raises RunError with the program's own message, or UserError if there is no such case or program.
    """
    check_arguments(case, directory, entries, ranks)
    options = [option for option, chosen in (("--overwrite", overwrite), ("--resume", resume)) if chosen]
    program = find_program(program)
    command = command_line(program, find_case(case, program=program), entries or {}, directory, *options, ranks=ranks)
    process = subprocess.run(command, env=os.environ | MPI_ENVIRONMENT, stdout=subprocess.DEVNULL,
                             stderr=subprocess.PIPE, text=True, check=False)
    if process.returncode != 0:
        raise RunError(process.returncode, process.stderr.strip())
    sys.stderr.write(process.stderr)  # warnings
    return Results(directory)


def processor_seconds():
    """Of all processes that this one has started and waited for."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime
