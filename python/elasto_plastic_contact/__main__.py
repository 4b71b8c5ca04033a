# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""epc COMMAND [ARGUMENT ...], or python3 -m elasto_plastic_contact: see COMMANDS."""

import argparse
import importlib
import os
import subprocess
import sys

from .errors import FileError, UserError

# The module of each command, whose main() takes its arguments, and what it does.
COMMANDS = {
    "new": ("elasto_plastic_contact.new_case.command", "write the parameter file of a usual test"),
    "run": ("elasto_plastic_contact.run_and_draw", "run a case and draw its results"),
    "plot": ("elasto_plastic_contact.plots.command", "diagrams of runs"),
    "render": ("elasto_plastic_contact.pictures.render", "pictures and films of bodies"),
    "study": ("elasto_plastic_contact.study.command", "many runs of one case with different entries"),
    "evaluate": ("elasto_plastic_contact.evaluate", "hardness, moduli and more of measured curves"),
    "fit": ("elasto_plastic_contact.fitting.command", "the material of measured curves, with its uncertainty"),
    "report": ("elasto_plastic_contact.reporting.command", "a report of a run for a paper and its reviewers"),
    "schema": ("elasto_plastic_contact.schema", "the JSON schema of all entries of a parameter file"),
}

# The Debian package of a module that may be missing.
PACKAGES = {"numpy": "python3-numpy", "matplotlib": "python3-matplotlib", "scipy": "python3-scipy", "xlrd": "python3-xlrd",
            "openpyxl": "python3-openpyxl", "h5py": "python3-h5py"}


def main(arguments=None, commands=None):
    """Runs one of the commands, by default COMMANDS. Returns its exit status: 2 after a wrong input, 5 if a file
    could not be read or written, that of the program if it has failed, 130 after Ctrl-C."""
    commands = commands or COMMANDS
    parser = argparse.ArgumentParser(
        prog="epc", formatter_class=argparse.RawDescriptionHelpFormatter,
        description="Commands (each explains itself with --help):\n" +
        "".join(f"  {name:20} {text}\n" for name, (_, text) in commands.items()))
    parser.add_argument("command", choices=commands, metavar="COMMAND")
    parser.add_argument("arguments", nargs=argparse.REMAINDER, metavar="ARGUMENT")
    chosen = parser.parse_args(arguments)
    try:
        module = importlib.import_module(commands[chosen.command][0])
        status = module.main(chosen.arguments)
        sys.stdout.flush()
        return status
    except UserError as error:
        status, problem = error.status, str(error)
    except ImportError as error:
        package = PACKAGES.get((error.name or "").partition(".")[0])
        if package is None:
            raise
        status = UserError.status
        problem = (f"{error} in {sys.executable}. The Debian package {package} installs it for /usr/bin/python3, which "
                   "runs these commands unless another Python is named before them.")
    except subprocess.CalledProcessError as error:
        status = error.returncode
        problem = (error.stderr or "").strip() or f"the program has ended with exit status {status}"
    except OSError as error:
        status, problem = FileError.status, f"'{error.filename or 'standard output'}': {error.strerror}"
        # (so that what is left of the output is not tried again at the end of the process)
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    except KeyboardInterrupt:
        print(f"{chosen.command}: stopped", file=sys.stderr)
        return 130
    print(f"{chosen.command}: {problem}", file=sys.stderr)
    return status


if __name__ == "__main__":
    sys.exit(main())
