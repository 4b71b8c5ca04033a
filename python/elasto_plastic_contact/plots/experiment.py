# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measured and computed curves of force over depth, with their tangents by Oliver and Pharr."""

from .figures import BLUE, RED, new_diagram, save

STYLES = {"measured": {"color": RED, "linestyle": "none", "marker": ".", "markersize": 3.,
                       "zorder": 3},  # above the lines
          "computed": {"color": BLUE}}


def draw(curves, unloadings, path):
    """curves: depth and force, unloadings: lists of Unloading, both by 'measured' and 'computed'."""
    figure, axes = new_diagram()
    for name, (depth, force) in curves.items():
        axes.plot(depth, force, label=name, **STYLES[name])
        for found in unloadings[name]:
            axes.plot([found.max_depth - found.max_force / found.stiffness, found.max_depth], [0., found.max_force],
                      "--", linewidth=1., color=STYLES[name]["color"])
    axes.plot([], [], "--", color="gray", linewidth=1., label="initial slope of unloading")
    axes.set(xlabel="depth", ylabel="force", xlim=(0., None), ylim=(0., None))
    axes.legend()
    save(figure, path)
