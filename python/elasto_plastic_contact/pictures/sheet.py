# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arranges panels: those of one view side by side, several views in columns; letters, bars of
colours and of length, and legends stand beside the bodies."""

from mpl_toolkits.axes_grid1.anchored_artists import AnchoredSizeBar

from .draw import DARK
from .panels import round_down
from ..plots.figures import DPI, letter, plt

PANEL_WIDTH, BESIDE, BELOW = 5.2, 1.2, 0.7  # inches: a panel, its colours beside it, its texts


def size_that_fits(panels, n_views):
    if n_views == 1:
        width = sum(PANEL_WIDTH + BESIDE for _ in panels)
        return width, PANEL_WIDTH * max(panel.aspect() for panel in panels) + BELOW
    width = 0.75 * PANEL_WIDTH
    return n_views * width + BESIDE, sum(width * panel.aspect() + BELOW for panel in panels)


def add_scale_bar(axes, panel, units):
    left, right, _, _ = panel.window
    length = round_down(0.3 * (right - left))
    axes.add_artist(AnchoredSizeBar(
        axes.transData, length, f"{length:g} {units.length}".strip(), "upper left", pad=0.1, borderpad=0.1, sep=3,
        frameon=False, color=DARK, size_vertical=0., bbox_to_anchor=(0., -0.01), bbox_transform=axes.transAxes))


def draw_sheet(panels, views, titles, units, size):
    """The figure; size in pixels, or None for one that fits."""
    rows, columns = (1, len(panels)) if len(views) == 1 else (len(panels), len(views))
    inches = [pixels / DPI for pixels in size] if size else size_that_fits(panels, len(views))
    figure, grid = plt.subplots(rows, columns, figsize=inches, squeeze=False)
    grid = grid.reshape(len(panels), len(views))
    for panel, row in zip(panels, grid):
        for axes, view, title in zip(row, views, titles):
            handles = panel.draw(axes, view)
            if handles:
                axes.legend(handles=handles, loc="upper left", bbox_to_anchor=(0.31 if panel.flat else 0., -0.01),
                            ncol=len(handles), borderaxespad=0.2, columnspacing=1.2, handlelength=1.2, fontsize=9)
            if panel.flat:
                add_scale_bar(axes, panel, units)
            axes.set_title(title if panel is panels[0] else "from above")
        bar = figure.colorbar(panel.colours, ax=list(row), shrink=0.8, aspect=25, pad=0.03)
        bar.set_label(units.stress_label(panel.name, panel.label()))
        bar.outline.set_linewidth(0.5)
    if grid.size > 1:
        for i, axes in enumerate(grid.flat):
            letter(axes, i)
    return figure
