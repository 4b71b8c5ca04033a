# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plot the errors of stresses in equilibrium over the size of the cells: a cylinder pressed
into elastic, hardening and perfectly plastic bodies, uniform meshes. Runs the program; takes
a few minutes.

    scripts/command.py stress_convergence --output stress_convergence.png
"""

import math

from elasto_plastic_contact.plots.figures import plt
from .own_runs import draw_own_runs
from ..verification.equilibrium import LAWS, order, uniform_meshes


def plot_stress_convergence(runner):
    figure, axes = plt.subplots(figsize=(7.5, 4.5))
    for law in LAWS:
        rows, _ = uniform_meshes(runner, law, 4)
        sizes = [math.sqrt(rows[0]["cells"] / row["cells"]) for row in rows]
        line, = axes.loglog(sizes, [row["distance"] for row in rows], "o-",
                            label=f"{law}, order {order(rows, 'distance'):.2f}")
        axes.loglog(sizes, [math.sqrt(2 * row["bound"]) for row in rows], "s:", color=line.get_color())
    axes.plot([], [], "ks:", label="guaranteed bound")
    axes.set_xscale("log", base=2)
    axes.set(xlabel="size of the cells, relative to the first mesh", ylabel="error of the stress, norm of the energy",
             ylim=(0.005, None))
    axes.legend(ncol=2, loc="lower center")
    return figure


def main(arguments):
    draw_own_runs(plot_stress_convergence, __doc__, "stress_convergence.png", arguments)
