#!/usr/bin/python3
# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw what the equilibrium method has found: the last mesh of limit_load.pvd (yield
ratio of the stresses, mechanism of collapse, multipliers u_h of equilibrium) or of
equilibrium.pvd (yield ratio, displacement u_h, parts of the error bound), thirds of
triangles as they are.

    scripts/plot_equilibrium.py output/limit_load_strip_punch --window 3 --output prandtl.png

Needs matplotlib (Debian package python3-matplotlib).
"""

import math
import pathlib
import sys

from plot_of_runs import make_parser, save
from vtu_fields import read_fields


def last_fields(directory):
    for kind in ("limit_load", "equilibrium"):
        if (pathlib.Path(directory) / f"{kind}.pvd").exists():
            return list(read_fields(directory, kind))[-1]
    sys.exit(f"plot_equilibrium.py: there is neither limit_load.pvd nor equilibrium.pvd in {directory}. "
             "Run a case with 'Analysis = limit load' or 'contact with error bound'.")


def draw(figure, axes, fields, values, title, **options):
    x, y, _ = zip(*fields["points"])
    image = axes.tripcolor(x, y, fields["cells"], values, **options)
    axes.triplot(x, y, fields["cells"], color="black", linewidth=0.1, alpha=0.5)
    axes.set(title=title, aspect="equal")
    figure.colorbar(image, ax=axes, shrink=0.8)


def draw_arrows(axes, fields, distance):
    """The velocity at some points that are about so far apart."""
    arrows = {(round(x / distance), round(y / distance)): (x, y, *velocity[:2])
              for (x, y, _), velocity in zip(fields["points"], fields["velocity"])}
    axes.quiver(*zip(*arrows.values()), color="white", width=0.003)


def draw_magnitude(figure, axes, fields, name, title):
    """Its colours leave out what only a hundredth of the points reach, as at the edge of a punch."""
    magnitude = [math.hypot(*vector) for vector in fields[name]]
    draw(figure, axes, fields, magnitude, title, shading="gouraud", cmap="magma",
         vmax=sorted(magnitude)[int(0.99 * len(magnitude))])


def draw_error(figure, axes, fields):
    # (an indicator is the same number at all corners)
    error = [math.log10(max(fields["error_indicator"][cell[0]], 1e-30)) for cell in fields["cells"]]
    x, y, _ = zip(*fields["points"])
    image = axes.tripcolor(x, y, fields["cells"], facecolors=error, cmap="magma", vmin=max(error) - 6)
    axes.set(title="error bound of a triangle (power of 10)", aspect="equal")
    figure.colorbar(image, ax=axes, shrink=0.8)


def plot(plt, fields, window):
    plt.rcParams["axes.grid"] = False
    figure, pictures = plt.subplots(1, 3, figsize=(16.5, 4.5))
    if max(fields["yield_ratio"]) > 0:
        draw(figure, pictures[0], fields, fields["yield_ratio"], "stress over yield stress", shading="gouraud",
             vmin=0, vmax=1)
    else:
        draw(figure, pictures[0], fields, fields["von_mises_stress"], "von Mises stress", shading="gouraud")
    if "velocity" in fields:
        draw_magnitude(figure, pictures[1], fields, "velocity", "speed of the mechanism")
        draw_arrows(pictures[1], fields, (window or max(map(max, fields["points"]))) / 25)
        draw_magnitude(figure, pictures[2], fields, "discontinuous_velocity", "speed $u_h$ of the multipliers")
    else:
        draw_magnitude(figure, pictures[1], fields, "discontinuous_displacement", "displacement $u_h$")
        draw_error(figure, pictures[2], fields)
    if window:
        top = max(point[1] for point in fields["points"])
        left_end = max(-window, min(point[0] for point in fields["points"]))
        for axes in pictures:
            axes.set(xlim=(left_end, window), ylim=(top - window, top + 0.03 * window))
    return figure


def main():
    parser = make_parser(__doc__, "equilibrium.png")
    parser.add_argument("directory", help="output directory of a run")
    parser.add_argument("--window", type=float, help="show only so much to both sides of the axis, and below")
    arguments = parser.parse_args()
    fields = last_fields(arguments.directory)
    save(lambda plt: plot(plt, fields, arguments.window), arguments.output, parser.prog)


if __name__ == "__main__":
    main()
