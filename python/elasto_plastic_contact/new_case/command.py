# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write the parameter file of a usual test, ready to run: mesh, steps, strains and units that suit it. What is missing
is asked for on a terminal, and an error elsewhere.

    epc new brinell --material steel-4340
    epc new berkovich --material aluminium-6061 --depth "500 nm" --tip-radius "50 nm"
    epc new coating --material steel --film "2 um, 400 GPa" --depth "300 nm"
"""

import os
import pathlib
import sys

from .duration import check_file, expected_seconds, in_words, speed_of_this_machine
from .kinds import KINDS, MATERIAL_QUESTIONS, OPTIONS, dashed, make_case, missing, read_given
from .materials import print_library
from .rules import FINENESS
from ..arguments import CommandParser, one_of
from ..errors import UserError
from ..files import new_file
from ..program import add_program, find_program

QUESTIONS = MATERIAL_QUESTIONS | OPTIONS


def options_of(kind):
    """What a kind needs and takes, as a line of the help."""
    needs = " and ".join(dashed(need) if isinstance(need, str) else " or ".join(map(dashed, need))
                         for need in kind.needs)
    takes = ", ".join(map(dashed, kind.takes))
    return " " * 17 + "; ".join(filter(None, (needs and f"needs {needs}", takes and f"takes {takes}"))) + "\n"


def parser_of_command():
    kinds = "kinds:\n" + "".join(f"  {name:14} {kind.what}\n{options_of(kind)}" for name, kind in KINDS.items())
    parser = CommandParser("new", __doc__, epilog=kinds)
    parser.add_argument("kind", nargs="?", type=one_of(KINDS), metavar="KIND", help="see below")
    for name, option in QUESTIONS.items():
        parser.add_argument(dashed(name), metavar=f"'{option.example}'", help=option.question)
    parser.add_argument("--mesh", type=one_of(FINENESS), default="usual",
                        help="coarse (an eighth to a third of the time), usual or fine (four to sixteen times)")
    parser.add_argument("--output", type=pathlib.Path, metavar="FILE", help="the file (default: KIND.prm)")
    parser.add_argument("--overwrite", action="store_true", help="replace the file if there is one")
    parser.add_argument("--list-materials", action="store_true",
                        help="print the library with the source of each number")
    add_program(parser)
    return parser


def ask_for(kind, texts):
    """Asks for what is missing, on a terminal. Raises UserError elsewhere."""
    lacking = missing(kind, texts)
    if lacking and not (sys.stdin.isatty() and sys.stdout.isatty()):
        options = ", ".join(f"{dashed(name)} \"{QUESTIONS[name].example}\"" for name in lacking)
        choice = " (or --force)" if "depth" in lacking and ("depth", "force") in KINDS[kind].needs else ""
        raise UserError(f"'{kind}' needs {options}{choice}")
    for name in lacking:
        what, example = QUESTIONS[name].question, QUESTIONS[name].example
        try:
            texts[name] = input(f"{what[0].upper()}{what[1:]}, such as {example}: ").strip()
        except EOFError:
            texts[name] = ""
        if not texts[name]:
            raise UserError(f"'{kind}' needs {dashed(name)}")
    return texts


def write_case(case, path, overwrite):
    """The file and what lies beside it. Raises UserError."""
    beside = {path.with_name(name.format(stem=path.stem)): text for name, text in case.files.items()}
    for existing in filter(pathlib.Path.exists, (path, *beside)):
        if not overwrite:
            raise UserError(f"'{existing}' exists: choose another --output, or replace it by --overwrite")
    case.set("Output", "Directory", f"output/{path.stem}")
    text = case.text().replace("{stem}", path.stem)
    if case.surface is not None:
        surface = os.path.relpath(case.surface, path.parent)
        if "#" in surface:
            raise UserError(f"--surface is '{surface}' as the file sees it, and '#' begins a comment there: give it another name")
        text = text.replace("{surface}", surface)
    with new_file(path) as file:
        file.write(text)
    for name, text in beside.items():
        with new_file(name) as file:
            file.write(text)
    return [path, *beside]


def print_choices(case):
    for name, what in case.chosen.items():
        print(f"{name[0].upper()}{name[1:]:15} {what}")
    print(f"{'Units':16} {case.units}")


def print_duration(case, path, program):
    """What the run will take on this machine. Without a program, the file is written all the same; one whose surface
    the program refuses is removed. Raises UserError."""
    try:
        program = find_program(program)
    except UserError as error:
        print(f"{'Time':16} not estimated, and the file not checked: {error}")
        return
    try:
        report, warnings = check_file(program, path, case.surface)
    except UserError:
        if case.surface is not None:
            path.unlink()
        raise
    if warnings:
        print(warnings, file=sys.stderr)
    seconds = expected_seconds(case.kind_of_time, report, speed_of_this_machine(program))
    print(f"{'Time':16} about {in_words(seconds)} of one processor (unknowns and steps of this file, and the speed of "
          "this machine in a "
          "short run)")


def main(arguments):
    parser = parser_of_command()
    chosen = parser.parse_args(arguments)
    if chosen.list_materials:
        print_library()
        return 0
    if chosen.kind is None:
        parser.error(f"give a KIND: {', '.join(KINDS)}")
    texts = ask_for(chosen.kind, {name: getattr(chosen, name) for name in QUESTIONS})
    case = make_case(chosen.kind, read_given(chosen.kind, texts, chosen.mesh))
    path = chosen.output or pathlib.Path(f"{chosen.kind.replace('-', '_')}.prm")
    files = write_case(case, path, chosen.overwrite)
    print_choices(case)
    print_duration(case, path, chosen.program)
    print(f"{'File':16} {', '.join(map(str, files))}\n{'Run':16} epc run {path}")
    return 0
