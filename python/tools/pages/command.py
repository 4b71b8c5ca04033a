# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Computes the tables and marked numbers of the pages in doc/, and writes them there.

usage: scripts/verify.py --tables [--list | --check] [--program PROGRAM] [--ranks N] [NAME ...]

Without NAME, all but those that are measured (times, memory); the name 'measured' stands for these.
Each run that several tables need is made once. --check leaves the pages as they are and says which
numbers differ by more than one unit of their last digit (exit status 1 if any).
"""

import argparse

from . import (contact, error_bounds, finite_strain, fits, friction, guide, histories, limit_loads,  # noqa: F401 (recipes)
               new_cases, performance, scaling)
from .places import differences, fill, names
from .recipe import RECIPES, Runs
from elasto_plastic_contact.arguments import number
from elasto_plastic_contact.errors import UserError
from elasto_plastic_contact.program import add_program, checkout


def main(arguments):
    """Fills the pages, or compares."""
    parser = argparse.ArgumentParser(prog="verify --tables", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="NAME", help="see --list")
    action = parser.add_mutually_exclusive_group()
    action.add_argument("--list", action="store_true", help="all names, with their pages and seconds")
    action.add_argument("--check", action="store_true", help="compare, and write nothing")
    add_program(parser)
    parser.add_argument("--ranks", type=number(int, least=1), default=1)
    chosen = parser.parse_args(arguments)
    check_names(pages())
    if chosen.list:
        print_list(pages())
        return 0
    runs = Runs(chosen.program, chosen.ranks)
    n_differences = 0
    for name in choose(chosen.names):
        print(f"{name}: {RECIPES[name].title}", flush=True)
        content = {name: RECIPES[name].compute(runs)}
        for page, text in pages().items():
            filled = fill(text, content)
            if chosen.check:
                n_differences += report(page, text, filled)
            elif filled != text:
                page.write_text(filled, encoding="utf-8")
    return 1 if runs.failed or n_differences else 0


def pages():
    """What stands in each page of doc/ now: it may be edited while recipes compute."""
    return {page: page.read_text(encoding="utf-8") for page in sorted((checkout() / "doc").rglob("*.md"))}


def check_names(texts):
    """Every mark in a page has a recipe, and every recipe a mark."""
    marked = {name for text in texts.values() for name in names(text)}
    for name in sorted(marked ^ set(RECIPES)):
        raise UserError(f"'{name}' is {'marked in a page, but has no recipe' if name in marked else 'in no page'}")


def choose(wanted):
    """The names of recipes."""
    chosen = []
    for name in wanted or [name for name, recipe in RECIPES.items() if not recipe.measured]:
        if name == "measured":
            chosen += [other for other, recipe in RECIPES.items() if recipe.measured]
        elif name in RECIPES:
            chosen.append(name)
        else:
            raise UserError(f"there is no table '{name}'; there are measured, {', '.join(RECIPES)}")
    return chosen


def print_list(texts):
    """Names, pages and costs."""
    for name, recipe in RECIPES.items():
        pages = ", ".join(place(page) for page, text in texts.items() if name in names(text))
        print(f"{name:28} {recipe.seconds:5} s  {'measured  ' if recipe.measured else ''}{pages}: {recipe.title}")


def place(page):
    """As pages are called: the path below doc/."""
    return page.relative_to(checkout() / "doc").as_posix()


def report(page, old, new):
    """Prints what differs; how many lines."""
    different = list(differences(old, new))
    for number, before, after in different:
        print(f"{place(page)}, line {number}: FAILED\n  stands there: {before}\n  computed:     {after}", flush=True)
    return len(different)
