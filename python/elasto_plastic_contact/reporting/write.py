# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parts of a report in their order."""

from . import constants, convergence, energy, figures, key_numbers, mesh, methods, problem
from .bibliography import bibtex


def write(facts, others, document):
    """others: the Facts of the same run on other meshes."""
    document.paragraph(f"Kind of run: {facts.kind}. Folder: {facts.name}.")
    key_numbers.write(facts, document)
    problem.write(facts, document)
    mesh.write(facts, document)
    convergence.write(facts, others, document)
    figures.write_curves(facts, document)
    figures.write_imprint(facts, document)
    figures.write_fields(facts, document)
    energy.write(facts, document)
    constants.write(facts, document)
    keys = methods.write(facts, others, document)
    document.heading("BibTeX")
    document.code(bibtex(facts.program, [*keys, *(["roache_1994"] if len(others) > 1 else [])]))
