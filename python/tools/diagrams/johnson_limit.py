# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run and plot Johnson's limit mu -> 0: the depth that the displacement method finds for
hardening mu, and that of the equilibrium method for perfect plasticity.

    scripts/command.py johnson_limit --output johnson_limit.png

Takes a minute.
"""

from elasto_plastic_contact.plots.figures import plt
from .own_runs import draw_own_runs
from ..verification.equilibrium import BOUND, depths_for_hardening, QUADRATIC


def plot_johnson_limit(runner):
    meshes = ("Refinement/Number of cycles=4", *QUADRATIC)
    row = runner.tables("johnson/perfect.prm", BOUND, *meshes)["error_bound"][-1]
    hardening = (1, 0.3, 0.1, 0.03, 0.01, 0.003, 0.001, 0.0003, 0.0001)
    figure, axes = plt.subplots(figsize=(6., 4.))
    axes.semilogx(hardening, depths_for_hardening(runner, hardening, meshes), "o-", label="displacement method")
    axes.axhline(row["equilibrium_depth"], color="black", linestyle=":", label="equilibrium method, perfectly plastic")
    axes.axhline(row["depth"], color="gray", linestyle="--", label="displacement method, perfectly plastic")
    axes.invert_xaxis()
    axes.set(xlabel=r"$\mu$", ylabel="depth under the force 2")
    axes.legend()
    return figure


def main(arguments):
    draw_own_runs(plot_johnson_limit, __doc__, "johnson_limit.png", arguments)
