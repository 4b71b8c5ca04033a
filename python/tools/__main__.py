# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""scripts/command.py COMMAND [ARGUMENT ...]: the commands of users, and those of developers, see COMMANDS."""

import sys

from elasto_plastic_contact import __main__ as package

# The module of each command, whose main() takes its arguments, and what it does.
COMMANDS = {
    "verify": ("tools.verification.verify", "compare with exact and published values"),
    "kill_test": ("tools.verification.kill_test", "kill runs, resume them and compare"),
    "contact_law": ("tools.verification.contact_law", "waves and errors for values of 'Contact/Edge'"),
    "contact_uniqueness": ("tools.verification.contact_uniqueness", "the same history computed in several ways"),
    "rough_spots": ("tools.verification.rough_spots", "force and pressure of many spots for values of 'Contact/Edge'"),
    "fit_coverage": ("tools.verification.fit_coverage", "how often the regions of a fit hold the true values"),
    "curve_and_imprint": ("tools.verification.curve_and_imprint", "two materials with equal curves and other imprints"),
    "curve_and_imprint_fit": ("tools.verification.curve_and_imprint_fit", "fits to a curve alone and with its imprint"),
    "published_metals": ("tools.verification.published_metals", "fits of published measurements against tension tests"),
    "two_cones": ("tools.verification.two_cones", "fits of published computations of cones of two angles"),
    "ten_cases": ("tools.verification.ten_cases", "a number of each of ten short runs, to compare systems"),
    "full_disk_test": ("tools.verification.full_disk_test", "fill disks, resume and compare"),
    "compare_with_step42": ("tools.verification.step42_comparison", "run step-42 on the same cases"),
    "height_maps": ("tools.inputs.height_maps", "make the height maps of the ready cases"),
    "sphere_meshes": ("tools.inputs.sphere_meshes", "make the meshes of the thick sphere"),
    "fit_data": ("tools.inputs.fit_data", "make the curves of the ready fits"),
    "update_schema": ("tools.update_schema", "bring the schema and the columns of tables up to date"),
    "man_pages": ("tools.man_pages", "write the manual pages of the program and of epc"),
    "johnson_limit": ("tools.diagrams.johnson_limit", "draw Johnson's limit of vanishing hardening"),
    "sphere_strains": ("tools.diagrams.sphere_strains", "draw a sphere with small and with finite strains"),
    "stress_convergence": ("tools.diagrams.stress_convergence", "draw errors of stresses in equilibrium"),
}


def main(arguments=None):
    """Runs a command. Returns its exit status."""
    return package.main(arguments, package.COMMANDS | COMMANDS)


if __name__ == "__main__":
    sys.exit(main())
