# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of a fit: what was measured and computed, residuals, and the stress-strain curve with its band and the
two materials at the ends of the flat direction."""

import numpy

from .figures import BLUE, RED, Units, letter, plt, save, with_unit
from ..fitting.statistics import LEVEL
from ..fitting.uniqueness import STRAINS

GREY, ORANGE, GREEN = "#707070", "#d9822b", "#3c8a4e"

# The total strain up to which stress-strain curves are drawn.
LARGEST_STRAIN = 0.12

CURVES = ("load", "unload")
KINDS = {"time": "time", "depth": "length", "force": "force", "distance": "length", "height": "length"}
QUANTITIES = "quantities"


def groups(fit):
    """The blocks of each column of the picture with their residuals, by its title."""
    found, first = {}, 0
    for experiment, block in fit.problem.blocks():
        part = fit.residuals[first:first + len(block.y)]
        first += len(block.y)
        title = QUANTITIES
        if block.kind != "quantity":
            title = experiment.name + ("" if block.kind in CURVES else f", {block.kind}")
        found.setdefault(title, []).append((experiment, block, part))
    return found


def draw(fit, path):
    columns = groups(fit)
    has_material = fit.representative is not None
    n_columns = len(columns) + has_material
    figure, axes = plt.subplots(2, n_columns, figsize=(4.6 * n_columns, 5.6), squeeze=False, height_ratios=(2.2, 1.))
    for i, (title, blocks) in enumerate(columns.items()):
        (draw_quantities if title == QUANTITIES else draw_blocks)(*axes[:, i], blocks)
        letter(axes[0, i], i)
        axes[0, i].set_title(title)
    if has_material:
        for panel in axes[:, -1]:
            panel.remove()
        panel = figure.add_subplot(axes[0, -1].get_gridspec()[:, -1])
        draw_material(panel, fit)
        letter(panel, n_columns - 1)
    save(figure, path)


def draw_blocks(upper, lower, blocks):
    """Measured points and computed lines; below, residuals over their standard deviations."""
    for experiment, block, residuals in blocks:
        computed = block.y + residuals * block.sigma
        order = numpy.argsort(block.x)
        upper.plot(block.x, block.y, "o", color=GREY, markersize=2.5, alpha=0.6, linewidth=0.)
        upper.plot(block.x[order], computed[order], color=BLUE, linewidth=1.4)
        lower.plot(block.x, residuals, "o", color=RED if block.kind == "unload" else BLUE, markersize=2.5, alpha=0.7,
                   label=block.kind)
    labels = [with_unit(label, experiment.units.get(KINDS.get(label), "")) for label in blocks[0][1].labels]
    upper.plot([], [], "o", color=GREY, markersize=3, label="measured")
    upper.plot([], [], color=BLUE, label="computed")
    upper.set(ylabel=labels[1])
    upper.legend()
    lower.axhline(0., color="black", linewidth=0.6)
    lower.set(xlabel=labels[0], ylabel="residual / σ")
    if len({block.kind for _, block, _ in blocks}) > 1:
        lower.legend(ncol=2, loc="lower right", bbox_to_anchor=(1., 0.95))


def draw_quantities(upper, lower, blocks):
    """Computed over measured values, with the standard deviations of these; below, residuals."""
    names = [block.name for _, block, _ in blocks]
    values = numpy.array([(part[0] * block.sigma[0] / abs(block.y[0]), block.sigma[0] / abs(block.y[0]), part[0])
                          for _, block, part in blocks])
    places = numpy.arange(len(names))
    upper.errorbar(places, numpy.zeros(len(names)), 100. * values[:, 1], fmt="o", color=GREY, capsize=4,
                   label="measured ± σ")
    upper.plot(places, 100. * values[:, 0], "D", color=BLUE, label="computed")
    upper.set(ylabel="deviation from measured in %", xlim=(-0.5, len(names) - 0.5))
    upper.set_xticks(places, [])
    upper.legend()
    lower.bar(places, values[:, 2], 0.4, color=BLUE)
    lower.axhline(0., color="black", linewidth=0.6)
    lower.set(ylabel="residual / σ", xlim=(-0.5, len(names) - 0.5))
    lower.set_xticks(places, [name.replace(" ", "\n") for name in names], fontsize=8)


def draw_material(axes, fit):
    """The best curve, the band of all that fit equally well, the two at the ends of the flat direction, and the stress
    that is known best."""
    strains = STRAINS[STRAINS <= LARGEST_STRAIN]
    curves = [fit.material.curve(x, strains) for x in fit.family]
    grid = numpy.linspace(0., LARGEST_STRAIN, 600)
    stresses = numpy.array([numpy.interp(grid, strain, stress) for strain, stress in curves])
    axes.fill_between(grid, stresses.min(axis=0), stresses.max(axis=0), color=BLUE, alpha=0.2, linewidth=0.,
                      label=f"{100. * LEVEL:g} % region")
    axes.plot(*curves[0], color=BLUE, linewidth=1.8, label="best fit")
    if len(fit.x) > 1:
        for end, color in zip(fit.ends[fit.flattest], (ORANGE, GREEN)):
            values = ", ".join(f"{name} = {value:.3g}" for name, value in fit.problem.values(end.x).items())
            axes.plot(*fit.material.curve(end.x, strains), "--", color=color, linewidth=1.2, label=values)
    found = fit.representative
    if found.total_strain <= LARGEST_STRAIN:
        axes.errorbar([found.total_strain], [found.stress],
                      [[found.stress - found.lower], [found.upper - found.stress]],
                      fmt="o", color=RED, capsize=4, markersize=4,
                      label=f"known best: {found.stress:.4g}\nat the plastic strain {found.plastic_strain:.2g}")
    units = fit.problem.experiments[0].units
    stress = Units(units.get("length"), units.get("force"), False).stress
    axes.set(xlabel="strain", ylabel=with_unit("stress", stress), xlim=(0., LARGEST_STRAIN), ylim=(0., None))
    axes.legend(loc="lower right")
