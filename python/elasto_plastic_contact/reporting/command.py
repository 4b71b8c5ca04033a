# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write a report of a run, as a reviewer of a paper would ask for: problem, results, mesh, convergence, curves,
imprint, fields, energy balance, versions and tolerances, a paragraph of methods to be copied, and BibTeX. One page of
HTML with all pictures in it; a browser prints it to PDF. What the run has not written is said.

    epc report output/cone_finite_strain
    epc report output/cone_finite_strain --mesh-pair coarser --mesh-pair coarser 2
    epc report output/plate --mesh-pair 'Geometry/File=../fine.msh' --output report.html
"""

import argparse
import pathlib

from ..arguments import CommandParser, number
from ..errors import UserError
from ..files import new_file
from ..program import add_program


def page(text):
    """The type of the name of a report."""
    if not text.endswith(".html"):
        raise argparse.ArgumentTypeError(f"it is '{text}', but must end with .html; a browser prints that to PDF")
    return pathlib.Path(text)


def make_parser():
    parser = CommandParser("report", __doc__)
    # (What follows --mesh-pair are its words, so the run comes first.)
    parser.usage = ("epc report RUN [--mesh-pair MESH ...] [--output OUTPUT] [--overwrite] [--ranks RANKS] "
                    "[--program PROGRAM]")
    parser.add_argument("directory", metavar="RUN", help="output directory of a run")
    parser.add_argument("--output", type=page, help="the report, .html (default: RUN/report.html)")
    parser.add_argument("--overwrite", action="store_true", help="replace a report that is there")
    parser.add_argument("--mesh-pair", action="append", nargs="+", default=[], metavar="MESH",
                        help="run the same input on another mesh, and compare: coarser or finer (all elements of twice "
                             "or half the size; a number behind it: so many times), or entries 'Section/Entry=value'; "
                             "repeatable, and with three meshes the numbers are extrapolated. These runs lie in "
                             "RUN/meshes, and are made once")
    parser.add_argument("--ranks", type=number(int, least=1), default=1,
                        help="how many processors they run on (default: %(default)s)")
    add_program(parser)
    return parser


def write_report(directory, output=None, *, overwrite=False, meshes=(), ranks=1, program=None, say=print):
    """Writes the report of a run. Returns its path.

    meshes: lists of words as behind --mesh-pair. Raises UserError if there is no such run, if it has not finished, or
    if there is a report already.
    """
    # (These need matplotlib, which the text of --help does not.)
    from .convergence import entries_of_mesh, run_on
    from .document import Document
    from .facts import Facts
    from .write import write
    facts = Facts(directory)
    output = pathlib.Path(output or facts.run.path("report.html"))
    if output.exists() and not overwrite:
        raise UserError(f"'{output}' is there already: choose another --output, or add --overwrite to replace it")
    entries = [entries_of_mesh(facts, words) for words in meshes]
    others = [run_on(facts, changes, ranks, program, say) for changes in entries]
    document = Document(f"Report of the run {facts.name}")
    write(facts, others, document)
    with new_file(output) as file:
        file.write(document.html())
    say(output)
    return output


def main(arguments):
    chosen = make_parser().parse_args(arguments)
    write_report(chosen.directory, chosen.output, overwrite=chosen.overwrite, meshes=chosen.mesh_pair,
                 ranks=chosen.ranks,
                 program=chosen.program)
    return 0
