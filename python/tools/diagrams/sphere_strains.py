# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run and plot a sphere with small and with finite strains: how far force and pile-up differ,
over the contact radius, for two yield stresses.

    scripts/command.py sphere_strains --output sphere_strains.svg

Takes a minute.
"""

from elasto_plastic_contact.plots.figures import BLUE, RED, letter, plt
from .own_runs import draw_own_runs
from ..verification.finite_strain import excess_of_small_strains, sphere_loading


def plot_sphere_strains(runner):
    figure, panels = plt.subplots(1, 2, figsize=(9., 3.6))
    for yield_stress, colour in ((400, RED), (2000, BLUE)):
        finite, small = (sphere_loading(runner, strain, yield_stress) for strain in ("logarithmic", "small"))
        name = rf"$E/\sigma_0$ = {200000 // yield_stress}"
        radii = [step["contact_radius"] for step in finite]
        excess = [100 * value for value in excess_of_small_strains(finite, small)]
        panels[0].plot(radii, excess, color=colour, label=name)
        for steps, line, strain in ((finite, "-", "finite"), (small, "--", "small")):
            panels[1].plot(radii, [step["pile_up"] / step["depth"] for step in steps], line, color=colour,
                           label=f"{name}, {strain}")
    panels[0].set(xlabel="contact radius $a/R$, finite strains", ylabel="force of small strains, deviation in %")
    panels[1].set(xlabel="contact radius $a/R$, finite strains", ylabel="pile-up over depth")
    for i, panel in enumerate(panels):
        panel.legend()
        letter(panel, i)
    return figure


def main(arguments):
    draw_own_runs(plot_sphere_strains, __doc__, "sphere_strains.png", arguments)
