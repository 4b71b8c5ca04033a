# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the height maps that the ready cases read.

parameter_files/rough_surface.pgm: a periodic self-affine rough surface, Hurst
exponent 0.8, the sum of waves with random phases. parameter_files/step42/ring.pgm:
a stamp with a ring and a bar. Both are PGM images with 16 bit heights; black is low.
"""

import argparse
import math
import pathlib

from elasto_plastic_contact.new_case.rough_surface import rough_surface
from elasto_plastic_contact.program import checkout


def write_pgm(file, heights):
    """Writes rows of heights, scaled to 0..65535, as a 16 bit ASCII PGM."""
    low = min(map(min, heights))
    high = max(map(max, heights))
    with open(file, "w", encoding="ascii") as out:
        out.write(f"P2\n{len(heights[0])} {len(heights)}\n65535\n")
        for row in heights:
            out.write(" ".join(str(round(65535 * (h - low) / (high - low))) for h in row))
            out.write("\n")


def ring(n):
    """n x n heights: a ring and a bar across it stand out, with sloping flanks."""

    def height(x, y):
        distance = min(abs(math.hypot(x, y) - 0.28), max(abs(y), abs(x) - 0.28))
        return min(1.0, max(0.0, (distance - 0.05) / 0.1))

    axis = [i / (n - 1) - 0.5 for i in range(n)]
    return [[height(x, y) for x in axis] for y in axis]


def main(arguments):
    """Writes the files below the folder given on the command line."""
    parser = argparse.ArgumentParser(prog="height_maps", description=__doc__)
    parser.add_argument("folder", nargs="?", type=pathlib.Path)
    folder = parser.parse_args(arguments).folder or checkout() / "parameter_files"
    write_pgm(folder / "rough_surface.pgm", rough_surface(65, 0.8, 2, 12, seed=1978))
    write_pgm(folder / "step42" / "ring.pgm", ring(65))
