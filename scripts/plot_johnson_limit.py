#!/usr/bin/python3
# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run and plot Johnson's limit mu -> 0: the depth that the displacement method finds for
hardening mu, and that of the equilibrium method for perfect plasticity.

    scripts/plot_johnson_limit.py --program build/release/elasto_plastic_contact --output johnson_limit.png

Needs matplotlib (Debian package python3-matplotlib). Takes a minute.
"""

import argparse
import sys

from verification_runner import ROOT, Runner
from verify_equilibrium import BOUND, depths_for_hardening, QUADRATIC


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=ROOT / "build/release/elasto_plastic_contact")
    parser.add_argument("--output", default="johnson_limit.png", help="the picture (default: johnson_limit.png)")
    return parser.parse_args()


def main():
    arguments = parse_arguments()
    try:
        import matplotlib
        matplotlib.use("Agg")
        import matplotlib.pyplot as plt
    except ImportError as error:
        sys.exit(f"plot_johnson_limit.py: {error}. Install the Debian package python3-matplotlib.")

    runner = Runner(arguments.program, 1)
    meshes = ("Refinement/Number of cycles=4", *QUADRATIC)
    row = runner.tables("johnson/perfect.prm", BOUND, *meshes)["error_bound"][-1]
    hardening = (1, 0.3, 0.1, 0.03, 0.01, 0.003, 0.001, 0.0003, 0.0001)
    figure, axes = plt.subplots(figsize=(6., 4.))
    axes.semilogx(hardening, depths_for_hardening(runner, hardening, meshes), "o-", label="displacement method")
    axes.axhline(row["equilibrium_depth"], color="black", linestyle=":", label="equilibrium method, perfectly plastic")
    axes.axhline(row["depth"], color="gray", linestyle="--", label="displacement method, perfectly plastic")
    axes.invert_xaxis()
    axes.set(xlabel=r"$\mu$", ylabel="depth under the force 2")
    axes.legend(frameon=False)
    axes.grid(alpha=0.3)
    figure.savefig(arguments.output, bbox_inches="tight", dpi=150)
    print(arguments.output)


if __name__ == "__main__":
    main()
