# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The arguments of the command evaluate."""

import argparse

from ..arguments import CommandParser, listed, number, picture
from ..errors import UserError
from ..oliver_pharr import CONSTANTS, HIGHEST_SHARE, LOWEST_SHARE
from .lengths import Length
from .units import FACTORS, tidy, value_with_unit


def zero_point(text):
    if text == "fit":
        return text
    try:
        return Length(value_with_unit(text, "length", "nm"))
    except ValueError:
        pass
    try:
        return number()(text)
    except argparse.ArgumentTypeError:
        raise argparse.ArgumentTypeError(f"it is '{text}', but must be a depth, such as '5 nm', without a unit in that of the "
                                         "file, or 'fit'") from None


def with_unit(kind, unit, *words):
    """The type of a value with a unit, or of one of these words."""
    def read(text):
        if text in words:
            return text
        try:
            return value_with_unit(text, kind, unit)
        except ValueError as error:
            raise argparse.ArgumentTypeError(f"{error}, or {' or '.join(words)}") from None

    return read


def unit_of(kind):
    def read(text):
        if tidy(text) not in FACTORS[kind]:
            raise argparse.ArgumentTypeError(f"there is no unit of {kind} '{text}'; there are "
                                             f"{', '.join(FACTORS[kind])}")
        return tidy(text)

    return read


def add_reading(parser):
    group = parser.add_argument_group("reading")
    group.add_argument("--columns", nargs="+", metavar="COLUMNS", help="depth=2,force=3,time=1,stiffness=4: numbers, "
                                                                       "from 1, or names of "
                       "the columns, if they are not known by their names; or two names, of depth and force, of a "
                       "table in units that are not named")
    group.add_argument("--unit", action="append", default=[], metavar="QUANTITY=UNIT", help="the unit of depth, "
                                                                                            "force, time or stiffness "
                       "where the file does not say it, such as depth=nm; repeatable")
    group.add_argument("--factors", type=number(), nargs=2, metavar=("DEPTH", "FORCE"),
                       help="to multiply a table without units by, such as 1e-6 1e-3 from nm and mN to mm and N "
                            "(default: 1 1)")
    group.add_argument("--indents", type=listed(number(int, least=1)), metavar="1,2", help="only these indents, in the "
                                                                                           "order of the files")
    group.add_argument("--noise", type=CONSTANTS["noise"], default=0.01, help="how much depth and force may rise "
                                                                              "during an "
                       "unloading, relative to their largest values (default: %(default)s)")


def add_tip(parser):
    group = parser.add_argument_group("tip (default: the area function of the instrument if the file has it, or that "
                                      "of --run)")
    tip = group.add_mutually_exclusive_group()
    tip.add_argument("--berkovich", action="store_true", help="a sharp pyramid with 3 faces at 65.27° to the axis")
    tip.add_argument("--vickers", action="store_true", help="a sharp pyramid with 4 faces at 68°")
    tip.add_argument("--cube-corner", action="store_true", help="the corner of a cube: 3 faces at 35.26°")
    tip.add_argument("--pyramid", type=number(above=0), nargs=2, metavar=("FACES", "ANGLE"), help="faces, and their "
                                                                                                  "angle to the axis "
                                                                                                  "in degrees")
    tip.add_argument("--cone", type=number(above=0, below=90), metavar="ANGLE", help="angle between axis and flank in "
                                                                                     "degrees; 70.3 "
                     "has the section of Berkovich's pyramid")
    tip.add_argument("--sphere", type=number(above=0), metavar="RADIUS", help="its radius")
    tip.add_argument("--area", type=number(), nargs="+", metavar="C", help="the section is C0 h^2 + C1 h + C2 h^(1/2) "
                                                                           "+ C3 h^(1/4) + ...")
    tip.add_argument("--area-file", metavar="FILE", help="coefficients, one a line, such as 'C0 = 24.5', or a table of "
                                                         "depth and area")
    group.add_argument("--tip-unit", type=unit_of("length"), metavar="UNIT", help="of lengths of the tip (default: "
                                                                                  "that of the depth in the "
                       "file)")


def add_corrections(parser):
    group = parser.add_argument_group("corrections (none unless asked for; all are reported)")
    group.add_argument("--zero-point", type=zero_point, metavar="DEPTH", help="the depth at the first contact, such "
                                                                              "as '5 nm', without a "
                       "unit in that of the file, or 'fit': where the loading, continued down to the force zero, "
                       "begins (default: 0)")
    group.add_argument("--frame-compliance", type=with_unit("compliance", "nm/mN", "instrument"), metavar="VALUE",
                       help="such as '0.3 nm/mN', or 'instrument': what the file says")
    group.add_argument("--drift", type=with_unit("rate", "nm/s", "hold", "instrument"), metavar="RATE",
                       help="such as '0.05 nm/s', or 'hold': that of the last hold at a low force, or 'instrument'")


def add_evaluation(parser):
    group = parser.add_argument_group("evaluation")
    group.add_argument("--beta", type=CONSTANTS["beta"], default=1., help="E_r = sqrt(pi) S / (2 beta sqrt(A)) "
                                                                          "(default: 1)")
    group.add_argument("--epsilon", type=CONSTANTS["epsilon"], help="h_c = h_max - epsilon F_max / S (default: 2 - "
                                                                    "4/pi for a "
                       "cone, else 0.75; 1 for a flat end)")
    group.add_argument("--fit", type=number(above=0, below=1), nargs=2, metavar=("LOW", "HIGH"), help="the shares of "
                                                                                                      "the largest "
                                                                                                      "force between "
                       f"which unloadings are fitted (default: {LOWEST_SHARE} {HIGHEST_SHARE})")
    group.add_argument("--indenter", type=number(), nargs=2, metavar=("E", "NU"), help="Young's modulus and Poisson's "
                                                                                       "ratio of the "
                       "measurement's indenter, in GPa (default: diamond, 1141 0.07); with --run in units of the run: "
                       "the E_r of the run gets its compliance")
    group.add_argument("--poisson", type=number(above=-1, most=0.5), metavar="NU", help="Poisson's ratio of the "
                                                                                        "specimen, for its Young's "
                                                                                        "modulus")


def add_results(parser):
    group = parser.add_argument_group("results")
    group.add_argument("--run", help="output directory of a run to compare with, whose cone, sphere, paraboloid, "
                                     "pyramid or area function is the "
                       "tip unless another one is given")
    for kind in ("length", "force"):
        group.add_argument(f"--{kind}-unit", metavar="UNIT", help=f"unit of {kind} of the run (default: "
                                                                  f"Output/{kind.capitalize()} unit of the run)")
    group.add_argument("--json", metavar="FILE", help="write all that was found, with segments, corrections and "
                                                      "scatter")
    group.add_argument("--output", type=picture, help="draw the curves with their tangents, and hardness and moduli "
                                                      "(.png, .svg, .pdf)")


def parse_arguments(arguments, description):
    """Raises UserError of those that contradict each other."""
    parser = CommandParser("evaluate", description)
    parser.add_argument("curve", nargs="+", metavar="FILE", help="measured curves; several files are several indents; or the folder of "
                                                                    "a run")
    for add in (add_reading, add_tip, add_corrections, add_evaluation, add_results):
        add(parser)
    chosen = parser.parse_args(arguments)
    if chosen.columns and len(chosen.columns) > 2 or len(chosen.columns or []) == 1 and "=" not in chosen.columns[0]:
        raise UserError(f"--columns is '{' '.join(chosen.columns)}', but must be like depth=2,force=3, or two names, "
                        "of depth and force")
    if chosen.fit and chosen.fit[0] >= chosen.fit[1]:
        raise UserError(f"--fit is {chosen.fit[0]:g} {chosen.fit[1]:g}, but the first share must be below the second "
                        "one")
    return chosen


# What the evaluation in units that are not named, or beside a run, does without.
OTHERS = ("area_file", "tip_unit", "frame_compliance", "drift", "fit", "poisson", "json")


def own_units_only(arguments):
    """Refuses options without effect, in a comparison. Raises UserError."""
    if len(arguments.curve) > 1:
        raise UserError(f"{len(arguments.curve)} files are given, but one curve is compared with a run")
    for name in OTHERS:
        if getattr(arguments, name) is not None:
            raise UserError(f"--{name.replace('_', '-')} is for curves whose units are known, and without --run: let "
                            "the file say its units, or --unit depth=nm --unit force=mN")
    if isinstance(arguments.zero_point, Length):
        raise UserError("--zero-point has a unit, and the curve is evaluated in the units of the run, or without any: "
                        "leave it out")
