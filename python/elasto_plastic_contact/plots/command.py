# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command plot: the diagrams of a run, or one by its name."""

import importlib

from . import run

# The modules, whose main() takes the arguments, and what they draw.
PLOTS = {
    "cost": "wall time and iterations over the unknowns",
    "cycles": "force over depth, and depth over cycle",
    "bounds": "error bounds over the unknowns",
    "equilibrium": "fields of the equilibrium method",
    "friction": "shear traction and forces of a contact with friction in the plane",
    "imprints": "force over depth, and deformed surfaces from above, of tests in space",
}


def main(arguments):
    if arguments and arguments[0] in PLOTS:
        return importlib.import_module(f".{arguments[0]}", __package__).main(arguments[1:])
    return run.main(arguments, PLOTS)
