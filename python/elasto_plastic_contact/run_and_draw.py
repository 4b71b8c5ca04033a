# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs a case and draws what there is to be seen of the result, in a new folder below output/.

    epc run indentation/sphere_axisymmetric.prm
    epc run my_case.prm 4 --set 'Loading/Depth=0.02'
"""

import itertools
import os
import pathlib
import subprocess

from .arguments import CommandParser, number
from .pictures import render
from .plots import command as plot
from .program import MPI_ENVIRONMENT, add_program, find_case, find_program

DEFAULT_CASE = "sphere_3d.prm"


def new_folder(name):
    """output/name, or the first of output/name_2, ... that is not there: earlier results stay."""
    folder = pathlib.Path("output") / name
    return next(path for n in itertools.count(1)
                if not (path := folder if n == 1 else folder.with_name(f"{name}_{n}")).exists())


def main(arguments):
    parser = CommandParser("run", __doc__)
    parser.add_argument("case", nargs="?", default=DEFAULT_CASE,
                        help="a parameter file, or the name of a ready case (default: %(default)s)")
    parser.add_argument("ranks", nargs="?", type=number(int, least=1), default=2,
                        help="how many processors it runs on (default: %(default)s)")
    parser.add_argument("--set", action="append", default=[], metavar="'Section/Entry=value'",
                        help="override an entry of the file; repeatable")
    add_program(parser)
    chosen = parser.parse_args(arguments)
    program = find_program(chosen.program)
    case = find_case(chosen.case, program=program)
    results = new_folder(case.stem)
    launcher = ["mpirun", "-np", str(chosen.ranks)] if chosen.ranks > 1 else []
    changes = [part for entry in chosen.set for part in ("--set", entry)]
    # (The program itself has said what is wrong.)
    status = subprocess.run([*launcher, program, case, *changes, "--output-directory", results],
                            env=os.environ | MPI_ENVIRONMENT, check=False).returncode
    return status or draw(results)


def draw(results):
    plot.main([str(results)])
    # A limit load, or a run without fields, has no deformed body.
    if (results / "solution.pvd").exists():
        render.main([str(results), "--output", str(results / "picture.png")])
    print(f"\nResults:            {results.absolute()} (tables: *.csv; fields for ParaView: *.pvd)\n"
          f"Plots and pictures: {results.absolute()}/*.png")
    return 0
