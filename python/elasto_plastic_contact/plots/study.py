# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The plot of a study: its numbers over one of its entries (or numbers), one line for each
combination of the others; and a curve of each run."""

import sys

from .figures import new_diagram, plt, save
from ..program import as_text


def in_words(run, paths):
    return ", ".join(f"{path.rpartition('/')[2]} = {as_text(run[path])}" for path in paths)


def lines(study, rows):
    """The rows of each line, by its label."""
    others = [path for path in study.varied if path != study.x]
    if study.x not in study.varied:
        others = others[1:]  # the first one runs along the line
    found = {}
    for row in rows:
        found.setdefault(in_words(row, others), []).append(row)
    return found


def set_logarithmic(axes, study, rows, columns):
    """The axes of the plot that the study wants so, unless nothing could be seen there."""
    for axis in study.logarithmic:
        if any(isinstance(row[columns[axis]], (int, float)) and row[columns[axis]] > 0. for row in rows):
            getattr(axes, f"set_{axis}scale")("log")
        else:
            print(f"'plot/logarithmic': the axis of '{columns[axis]}' stays linear, as no value is a number above 0",
                  file=sys.stderr)


def draw(study, rows, path):
    is_numeric = all(isinstance(row[study.x], (int, float)) for row in rows if row[study.x] is not None)
    figure, panels = plt.subplots(1, len(study.y), figsize=(6.4 * len(study.y), 4.), squeeze=False,
                                  layout="constrained")
    for axes, name in zip(panels[0], study.y):
        for label, line in lines(study, rows).items():
            known = [row for row in line if row[study.x] is not None and row[name] is not None]
            abscissa = [row[study.x] if is_numeric else as_text(row[study.x]) for row in known]
            axes.plot(abscissa, [row[name] for row in known], "o-", label=label)
        axes.set(xlabel=study.x, ylabel=name)
        set_logarithmic(axes, study, rows, {"x": study.x, "y": name})
    if len(lines(study, rows)) > 1:
        panels[0, -1].legend(loc="upper left", bbox_to_anchor=(1., 1.))
    save(figure, path)


def draw_curves(study, curves, path):
    """curves: the values of each run with its abscissae and ordinates."""
    figure, axes = new_diagram()
    varied = [path for path in study.varied if any(run[path] != study.runs[0][path] for run in study.runs)]
    for run, (x, y) in curves:
        axes.plot(x, y, label=in_words(run, varied))
    axes.set(xlabel=study.curves.x.replace("_", " "), ylabel=study.curves.y.replace("_", " "))
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.15))
    save(figure, path)
