# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""epc COMMAND [ARGUMENT ...], or python3 -m elasto_plastic_contact: see COMMANDS."""

import argparse
import importlib
import os
import subprocess
import sys

from .errors import FileError, UserError
from .program import is_checkout

# The module of each command, whose main() takes its arguments, and what it does.
COMMANDS = {
    "new": ("new_case.command", "write the parameter file of a usual test"),
    "run": ("run_and_draw", "run a case and draw its results"),
    "plot": ("plots.command", "diagrams of runs"),
    "render": ("pictures.render", "pictures and films of bodies"),
    "study": ("study.command", "many runs of one case with different entries"),
    "evaluate": ("evaluate", "hardness, moduli and more of measured curves"),
    "fit": ("fitting.command", "the material of measured curves, with its uncertainty"),
    "report": ("reporting.command", "a report of a run for a paper and its reviewers"),
    "schema": ("schema", "the JSON schema of all entries of a parameter file"),
}

# Those for developers, which need a checkout.
DEVELOPER_COMMANDS = {
    "verify": ("verification.verify", "compare with exact and published values"),
    "kill_test": ("verification.kill_test", "kill runs, resume them and compare"),
    "contact_law": ("verification.contact_law", "waves and errors for values of 'Contact/Edge'"),
    "contact_uniqueness": ("verification.contact_uniqueness", "the same history computed in several ways"),
    "rough_spots": ("verification.rough_spots", "force and pressure of many spots for values of 'Contact/Edge'"),
    "fit_coverage": ("verification.fit_coverage", "how often the regions of a fit hold the true values"),
    "curve_and_imprint": ("verification.curve_and_imprint", "two materials with equal curves and other imprints"),
    "curve_and_imprint_fit": ("verification.curve_and_imprint_fit", "fits to a curve alone and with its imprint"),
    "published_metals": ("verification.published_metals", "fits of published measurements against tension tests"),
    "two_cones": ("verification.two_cones", "fits of published computations of cones of two angles"),
    "ten_cases": ("verification.ten_cases", "a number of each of ten short runs, to compare systems"),
    "full_disk_test": ("verification.full_disk_test", "fill disks, resume and compare"),
    "compare_with_step42": ("verification.step42_comparison", "run step-42 on the same cases"),
    "height_maps": ("inputs.height_maps", "make the height maps of the ready cases"),
    "sphere_meshes": ("inputs.sphere_meshes", "make the meshes of the thick sphere"),
    "fit_data": ("inputs.fit_data", "make the curves of the ready fits"),
    "update_schema": ("update_schema", "bring the schema and the columns of tables up to date"),
    "man_pages": ("man_pages", "write the manual pages of the program and of epc"),
}

# The Debian package of a module that may be missing.
PACKAGES = {"numpy": "python3-numpy", "matplotlib": "python3-matplotlib", "scipy": "python3-scipy", "xlrd": "python3-xlrd",
            "openpyxl": "python3-openpyxl", "h5py": "python3-h5py"}


def main(arguments=None):
    """Runs a command. Returns its exit status: 2 after a wrong input, 5 if a file could not be read or
    written, that of the program if it has failed, 130 after Ctrl-C."""
    commands = COMMANDS | (DEVELOPER_COMMANDS if is_checkout() else {})
    parser = argparse.ArgumentParser(
        prog="epc", formatter_class=argparse.RawDescriptionHelpFormatter,
        description="Commands (each explains itself with --help):\n" +
        "".join(f"  {name:20} {text}\n" for name, (_, text) in commands.items()))
    parser.add_argument("command", choices=commands, metavar="COMMAND")
    parser.add_argument("arguments", nargs=argparse.REMAINDER, metavar="ARGUMENT")
    chosen = parser.parse_args(arguments)
    try:
        module = importlib.import_module(f".{commands[chosen.command][0]}", __package__)
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
