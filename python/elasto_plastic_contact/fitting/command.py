# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find the material of measured curves: yield stress, hardening and other entries of a parameter file for which runs of
the program come closest to what was measured, by least squares within bounds. Several runs at a time; a fit that has
been interrupted goes on where it was, as no run is made twice. Written are fit.csv (values, standard errors, 95 %
regions), fit.json and fit.png. doc/recipes/fit.md describes the file.

    epc fit sphere.json --output-directory output/sphere_fit
"""

import functools
import pathlib

from ..arguments import CommandParser, number
from ..program import add_program, cases_folder, find_program
from ..study.command import open_folder


def fit(problem, directory, *, program=None, at_once=None, report=functools.partial(print, flush=True)):
    """Fits a problem, a file (JSON) or a dictionary like it, and writes fit.csv and fit.json. Returns the Fit.

    directory: of the results and the runs; at_once: how many runs at a time (None: as the problem says);
    report: is told in sentences how it goes on.

    Raises UserError: what is wrong, at which key, what is allowed.
    """
    from .reading import read_problem  # (these need SciPy, and the text of --help does not)
    from .results import write_csv, write_json
    from .solve import fit as solve
    program, directory = find_program(program), pathlib.Path(directory)
    problem = read_problem(problem, program)
    with open_folder(directory, "fit"):
        found = solve(problem, directory, program, at_once or problem.at_once, report)
        for write, name in ((write_csv, "fit.csv"), (write_json, "fit.json")):
            write(found, directory / name)
    return found


def find_problem(path, program=None):
    """The file, or, if there is none of that name, the ready problem. Raises UserError: there are no ready cases."""
    if path.exists() or len(path.parts) > 1:
        return path
    ready = cases_folder(program) / "fit" / path.with_suffix(".json").name
    return ready if ready.exists() else path


def main(arguments):
    parser = CommandParser("fit", __doc__)
    parser.add_argument("problem", type=pathlib.Path, help="the file (JSON), or the name of a ready problem")
    parser.add_argument("--output-directory", type=pathlib.Path,
                        help="where the results go (default: output/ and the name of the file)")
    parser.add_argument("--at-once", type=number(int, least=1),
                        help="how many runs at a time (default: 'at once' of the file)")
    parser.add_argument("--no-plot", action="store_true", help="write the tables only")
    add_program(parser)
    chosen = parser.parse_args(arguments)
    directory = chosen.output_directory or pathlib.Path("output") / chosen.problem.stem
    report = functools.partial(print, flush=True)
    found = fit(find_problem(chosen.problem, chosen.program), directory, program=chosen.program, at_once=chosen.at_once, report=report)
    from .results import print_fit
    print_fit(found, report)
    for name in ("fit.csv", "fit.json"):
        print(directory / name)
    if not chosen.no_plot:
        from ..plots.fit import draw  # (which needs matplotlib)
        draw(found, directory / "fit.png")
    return 0
