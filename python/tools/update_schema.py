# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Brings the schema of all entries, the columns of the tables and the bibliography of reports up to date with the program,
doc/lookup/tables.md and doc/references.bib."""

import argparse
import json
import os
import subprocess

from elasto_plastic_contact import columns, schema
from elasto_plastic_contact.errors import UserError
from elasto_plastic_contact.program import MPI_ENVIRONMENT, add_program, find_program
from elasto_plastic_contact.reporting import bibliography


def main(arguments):
    parser = argparse.ArgumentParser(prog="update_schema", description=__doc__)
    add_program(parser)
    parser.add_argument("--check", action="store_true", help="change nothing, fail if it is not up to date")
    chosen = parser.parse_args(arguments)
    of_tables = columns.columns_of_reference()
    reference = print_of_program(chosen.program, "--print-parameters")
    bring_up_to_date(schema.FILE, schema.make_schema(reference), chosen.check)
    bring_up_to_date(columns.FILE, of_tables, chosen.check)
    bring_up_to_date(bibliography.FILE, bibliography.entries_of_bibliography(), chosen.check)
    return 0


def print_of_program(program, option):
    return subprocess.run([find_program(program), option], env=os.environ | MPI_ENVIRONMENT,
                          stdout=subprocess.PIPE, text=True, check=True).stdout


def bring_up_to_date(file, content, only_check):
    text = json.dumps(content, indent=1, ensure_ascii=False) + "\n"
    if not only_check:
        file.write_text(text, encoding="utf-8")
    elif file.read_text(encoding="utf-8") != text:
        raise UserError(f"{file} is not that of the program. Bring it up to date with the target 'parameters'.")
