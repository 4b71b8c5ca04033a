# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run and plot a sphere with small and with finite strains: how far force and pile-up differ,
over the contact radius, for two yield stresses. Prints the deviation of the force of small
strains, a mean over five load steps.

    scripts/plot.py sphere_strains --program build/release/elasto_plastic_contact --output sphere_strains.svg

Takes a minute.
"""

from .figures import BLUE, RED, draw_own_runs, letter, plt

CASE = "indentation/sphere_finite_strain.prm"
PRINTED = (0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.44, 0.5)  # contact radius over that of the sphere


def loading(runner, strain, yield_stress):
    return runner.history(CASE, f"Strain={strain}", f"Material/Yield stress={yield_stress}",
                          "Loading/History=1: depth 0.1", "Loading/Number of steps=100")


def mean(values, i):
    """Over five steps: nodes that come into contact make waves."""
    nearby = values[max(0, i - 2):i + 3]
    return sum(nearby) / len(nearby)


def plot_sphere_strains(runner):
    figure, panels = plt.subplots(1, 2, figsize=(9., 3.6))
    for yield_stress, colour in ((400, RED), (2000, BLUE)):
        finite, small = (loading(runner, strain, yield_stress) for strain in ("logarithmic", "small"))
        name = rf"$E/\sigma_0$ = {200000 // yield_stress}"
        radii = [step["contact_radius"] for step in finite]
        excess = [100 * (other["force"] / step["force"] - 1) for step, other in zip(finite, small)]
        excess = [mean(excess, i) for i in range(len(excess))]
        panels[0].plot(radii, excess, color=colour, label=name)
        for steps, line, strain in ((finite, "-", "finite"), (small, "--", "small")):
            panels[1].plot(radii, [step["pile_up"] / step["depth"] for step in steps], line, color=colour,
                           label=f"{name}, {strain}")
        for radius in PRINTED:
            i = min(range(len(radii)), key=lambda i, radius=radius: abs(radii[i] - radius))
            if abs(radii[i] - radius) < 0.01:
                print(f"E/sigma_0 = {200000 // yield_stress}, a/R = {radius}: force {excess[i]:+.1f} %")
    panels[0].set(xlabel="contact radius $a/R$, finite strains", ylabel="force of small strains, deviation in %")
    panels[1].set(xlabel="contact radius $a/R$, finite strains", ylabel="pile-up over depth")
    for i, panel in enumerate(panels):
        panel.legend()
        letter(panel, i)
    return figure


def main(arguments):
    draw_own_runs(plot_sphere_strains, __doc__, "sphere_strains.png", arguments)
