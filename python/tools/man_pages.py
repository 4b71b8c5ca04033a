# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes the manual pages elasto_plastic_contact.1.gz and epc.1.gz, made of what the program and the commands print
themselves: --help, and the reference of all entries (--print-parameters)."""

import argparse
import gzip
import os
import pathlib
import re
import subprocess
import sys

from elasto_plastic_contact.program import add_program
from elasto_plastic_contact import __main__ as commands
from elasto_plastic_contact.schema import ENTRY
from .update_schema import print_of_program

# "  --option VALUE   what it does", and further lines of that
OPTION = re.compile(r"^  (--[\w-]+(?: [A-Z]+| '[^']*')?) +(.*(?:\n {10,}.*)*)", re.MULTILINE)


def escape(text):
    """As roff takes it for what it is, also at the beginning of a line."""
    return re.sub(r"^([.'])", r"\\&\1", text.replace("\\", r"\e").replace("-", r"\-"), flags=re.MULTILINE)


def plain(markdown):
    """The text of the reference without the marks of Markdown."""
    return re.sub(r"\\(.)", r"\1", markdown).replace("`", "")


def tagged(tag, text):
    return f".TP\n.B {escape(tag)}\n{escape(text)}\n"


def head(name, program, what):
    version = print_of_program(program, "--version").splitlines()[0]
    # (No hyphens, lines that are not stretched: names of entries and files stay as they are.)
    return f'.TH {name.upper()} 1 "" "{escape(version)}"\n.nh\n.ad l\n.SH NAME\n{name} \\- {escape(what)}\n'


def page_of_program(program):
    """The sections of --help, and all entries."""
    text, reference = (print_of_program(program, option) for option in ("--help", "--print-parameters"))
    usage, *what = text.partition("\n\n")[0].splitlines()
    # (The name of a page has one line.)
    first_sentence = " ".join(what).partition(". ")[0].rstrip(".")
    introduction = re.split("^#+ ", reference, flags=re.MULTILINE)[1].partition("\n")[2]
    parts = [head("elasto_plastic_contact", program, first_sentence[0].lower() + first_sentence[1:]),
             f".SH SYNOPSIS\n{escape(usage.removeprefix('Usage: '))}\n.SH OPTIONS\n",
             *(tagged(option, " ".join(meaning.split())) for option, meaning in OPTION.findall(text)),
             f".SH EXIT STATUS\n{escape(' '.join(text.partition('Exit status: ')[2].split()))}\n",
             f".SH PARAMETERS\n{escape(plain(introduction).strip())}\n",
             *(tagged(path, f"{plain(meaning).strip()}\nDefault: {plain(default)}. Values: {plain(values)}.")
               for path, meaning, default, values in ENTRY.findall(reference)),
             ".SH SEE ALSO\n.BR epc (1)\n"]
    return "".join(parts)


def help_of(command):
    # (argparse folds its lines to the width of the terminal.)
    environment = os.environ | {"COLUMNS": "78", "PYTHONPATH": str(pathlib.Path(__file__).parents[1])}
    return subprocess.run([sys.executable, "-m", "elasto_plastic_contact", command, "--help"], check=True, text=True,
                          stdout=subprocess.PIPE, env=environment).stdout


def page_of_commands(program):
    """What each command says of itself."""
    parts = [head("epc", program, "run, draw and evaluate what elasto_plastic_contact computes"),
             ".SH SYNOPSIS\nepc COMMAND [ARGUMENT ...]\n.SH COMMANDS\n"]
    parts += [tagged(name, what) for name, (_, what) in commands.COMMANDS.items()]
    parts += [f".SH {name.upper()}\n.nf\n{escape(help_of(name))}.fi\n" for name in commands.COMMANDS]
    return "".join([*parts, ".SH SEE ALSO\n.BR elasto_plastic_contact (1)\n"])


def main(arguments):
    parser = argparse.ArgumentParser(prog="man_pages", description=__doc__)
    parser.add_argument("--output-directory", type=pathlib.Path, default=".", help="where they go")
    add_program(parser)
    chosen = parser.parse_args(arguments)
    for name, text in (("elasto_plastic_contact", page_of_program(chosen.program)), ("epc", page_of_commands(chosen.program))):
        # (without the time, so that the same page is the same file)
        (chosen.output_directory / f"{name}.1.gz").write_bytes(gzip.compress(text.encode(), mtime=0))
    return 0
