# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parser of a command of epc, and types of arguments that refuse what makes no sense, and say what does."""

import argparse
import math
import sys

PICTURES = (".png", ".svg", ".pdf")


class CommandParser(argparse.ArgumentParser):
    """Of the arguments of 'epc NAME'. A message begins with the name alone, as all messages of the command."""

    def __init__(self, name, description, epilog=None):
        super().__init__(prog=f"epc {name}", description=description, epilog=epilog,
                         formatter_class=argparse.RawDescriptionHelpFormatter)
        self.name = name

    def error(self, message):
        self.print_usage(sys.stderr)
        self.exit(2, f"{self.name}: error: {message}\n")


def number(convert=float, above=None, least=None, below=None, most=None):
    """The type of a finite number within these limits."""
    limits = [f"{relation} {limit:g}" for relation, limit in
              ((">", above), (">=", least), ("<", below), ("<=", most)) if limit is not None]
    allowed = " ".join(["an integer" if convert is int else "a number", " and ".join(limits)]).strip()

    def read(text):
        try:
            value = convert(text)
        except (TypeError, ValueError):
            value = math.nan
        if not (math.isfinite(value) and (above is None or value > above) and (least is None or value >= least)
                and (below is None or value < below) and (most is None or value <= most)):
            raise argparse.ArgumentTypeError(f"it is '{text}', but must be {allowed}")
        return value

    return read


def picture(text):
    """The type of the name of a picture."""
    if not text.endswith(PICTURES):
        raise argparse.ArgumentTypeError(f"it is '{text}', but must end with {PICTURES[0]}, {PICTURES[1]} or {PICTURES[2]}")
    return text


def folder(text):
    """The type of the name of a folder."""
    if text.endswith(PICTURES):
        raise argparse.ArgumentTypeError(f"it is '{text}', but must be a folder; what names a picture is --panels, with "
                                         "the names of its diagrams")
    return text


def one_of(allowed):
    """The type of one of these words."""
    def read(text):
        if text not in allowed:
            raise argparse.ArgumentTypeError(f"there is no '{text}'; there are {', '.join(allowed)}")
        return text

    return read


def listed(read):
    """The type of a list of these, separated by commas."""
    return lambda text: [read(part) for part in text.split(",") if part]
