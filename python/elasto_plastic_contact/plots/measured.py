# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measured curves of force over depth with the tangents of their unloadings, and what follows of them."""

from .figures import BLUE, RED, letter, plt, save

# More indents than these are drawn without a legend.
MOST_NAMES = 6


def draw(evaluation, path):
    """The curves; beside them hardness and moduli over the contact depth, if there are several of them."""
    indents = evaluation.indents
    n_results = sum("tip_hardness" in found for indent in indents for found in indent.unloadings)
    has_results = n_results > 1 or any(indent.continuous for indent in indents)
    n_panels = 3 if has_results else 1
    figure, panels = plt.subplots(1, n_panels, figsize=(12.8, 4.) if has_results else (6.4, 4.), squeeze=False)
    draw_curves(panels[0, 0], indents)
    if has_results:
        for name, label, color, axes in (("tip_hardness", "hardness H in GPa", BLUE, panels[0, 1]),
                                         ("tip_reduced_modulus", "reduced modulus $E_r$ in GPa", RED, panels[0, 2])):
            draw_over_depth(axes, indents, name, label, color)
        for i, axes in enumerate(panels[0]):
            letter(axes, i)
    save(figure, path)


def draw_curves(axes, indents):
    for i, indent in enumerate(indents):
        curve, color = indent.curve, plt.get_cmap("viridis")(0.9 * i / max(len(indents) - 1, 1))
        axes.plot(curve.depth, curve.force, color=color, linewidth=1.,
                  label=f"indent {curve.name}" if 1 < len(indents) <= MOST_NAMES else None)
        for segment in indent.segments:
            if segment.kind == "hold" and segment.begin > 0:
                rows = slice(segment.begin, segment.end + 1)
                axes.plot(curve.depth[rows], curve.force[rows], color="black", linewidth=2.5, alpha=0.5)
        for found in indent.unloadings:
            if "stiffness" in found:
                begin = found["max_depth"] - found["max_force"] / found["stiffness"]
                axes.plot([begin, found["max_depth"]], [0., found["max_force"]], "--", linewidth=0.8, color=RED)
    if any("stiffness" in found for indent in indents for found in indent.unloadings):
        axes.plot([], [], "--", color=RED, linewidth=0.8, label="initial slope of unloading")
    if any(segment.kind == "hold" and segment.begin > 0 for indent in indents for segment in indent.segments):
        axes.plot([], [], color="black", linewidth=2.5, alpha=0.5, label="hold")
    axes.set(xlabel="depth in µm", ylabel="force in mN", ylim=(0., None))
    if axes.get_legend_handles_labels()[1]:
        axes.legend(loc="upper left")


def draw_over_depth(axes, indents, name, label, color):
    """Of the unloadings as points, of continuous stiffness as a line."""
    for indent in indents:
        points = [(found["contact_depth"], found[name]) for found in indent.unloadings if name in found]
        if points:
            axes.plot(*zip(*points), "o-", color=color, linewidth=0.6, markersize=3.5, alpha=0.7)
        if indent.continuous:
            axes.plot(indent.continuous["contact_depth"], indent.continuous[name], color=color, linewidth=0.8,
                      alpha=0.6)
    axes.margins(0.1)
    axes.set(xlabel="contact depth in µm", ylabel=label, xlim=(0., None), ylim=(0., None))
