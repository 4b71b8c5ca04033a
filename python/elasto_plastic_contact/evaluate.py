# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Evaluate the unloadings of a measured curve of force over depth by the method of Oliver and
Pharr and, to compare, those of a run, in the same way. Prints the columns of indentation.csv
(doc/lookup/tables.md) for each unloading, in the units of the curve. Depths are counted from zero_point, the depth at
the first contact.

    epc evaluate measured.csv --cone 70.3 --beta 1.034
    epc evaluate measured.csv --run output/cone_axisymmetric --output both.png

The curve is a table (CSV) with a header; its columns are called depth and force, or --columns.
Either ',' separates them and '.' is the decimal point, or ';' separates them and ',' is the decimal comma.
"""

import dataclasses

import numpy

from .arguments import CommandParser, number, picture
from .errors import UserError
from .oliver_pharr import CONSTANTS, HIGHEST_SHARE, LOWEST_SHARE, Tip, Unloading, evaluate, jumps_of_meshes
from .results import Results
from .tables import read_table
from .zero_point import find_zero_point


def zero_point(text):
    return text if text == "fit" else number()(text)


def parse_arguments(arguments):
    parser = CommandParser("evaluate", __doc__)
    parser.add_argument("curve", help="the measured curve (CSV)")
    tip = parser.add_mutually_exclusive_group()
    tip.add_argument("--cone", type=number(above=0, below=90), metavar="ANGLE", help="the tip is a cone: angle between axis and flank in "
                     "degrees; 70.3 stands for Berkovich's pyramid")
    tip.add_argument("--sphere", type=number(above=0), metavar="RADIUS", help="the tip is a sphere")
    tip.add_argument("--area", type=number(), nargs="+", metavar="C",
                     help="the section of the tip is C0 h^2 + C1 h + C2 h^(1/2) + C3 h^(1/4) + ...")
    parser.add_argument("--beta", type=CONSTANTS["beta"], default=1., help="E_r = sqrt(pi) S / (2 beta sqrt(A)) (default: 1)")
    parser.add_argument("--epsilon", type=CONSTANTS["epsilon"], help="h_c = h_max - epsilon F_max / S (default: 2 - 4/pi for a "
                        "cone, else 0.75; 1 for a flat end)")
    parser.add_argument("--indenter", type=number(), nargs=2, metavar=("E", "NU"), help="Young's modulus and Poisson's "
                        "ratio of the measurement's indenter, in units of the run: the E_r of --run gets the compliance")
    parser.add_argument("--noise", type=CONSTANTS["noise"], default=0.01, help="how much depth and force may rise during an "
                        "unloading, relative to their largest values (default: %(default)s)")
    parser.add_argument("--columns", nargs=2, default=["depth", "force"], metavar=("DEPTH", "FORCE"),
                        help="the columns of the curve (default: depth force)")
    parser.add_argument("--factors", type=number(), nargs=2, default=[1., 1.], metavar=("DEPTH", "FORCE"),
                        help="to multiply the curve by, such as 1e-6 1e-3 from nm and mN to mm and N (default: 1 1)")
    parser.add_argument("--zero-point", type=zero_point, metavar="DEPTH", help="the depth of the curve, after --factors, at "
                        "the first contact, or 'fit': where its loading, continued down to the force zero, begins "
                        "(default: 0, unless that is far from there)")
    parser.add_argument("--run", help="output directory of a run to compare with, whose cone, sphere, paraboloid, "
                        "pyramid or area function is the tip unless another one is given")
    parser.add_argument("--output", type=picture, help="draw both curves with their tangents (.png, .svg, .pdf)")
    return parser.parse_args(arguments)


def read_curve(path, columns, factors):
    """Depth and force of a measured curve."""
    if columns[0] == columns[1]:
        raise UserError(f"--columns is '{columns[0]}' for both depth and force: they must be two columns")
    rows = read_table(path)
    if len(rows) < 3:
        raise UserError(f"'{path}' has {len(rows)} rows: that is no curve")
    for column in columns:
        if column not in rows[0]:
            raise UserError(f"'{path}' has no column '{column}'; it has {', '.join(rows[0])}. Choose with --columns")
    curve = [factor * numpy.array([row[column] for row in rows]) for column, factor in zip(columns, factors)]
    for column, values in zip(columns, curve):
        if not numpy.isfinite(values).all():
            raise UserError(f"'{path}' has a value of '{column}' that is not finite, in row "
                            f"{numpy.isfinite(values).argmin() + 1}")
    if not curve[1].max() > 0.:
        raise UserError(f"'{path}' has no value of '{columns[1]}' above 0. Turn its sign by --factors")
    return curve


def tip_of_run(run):
    shape = run.parameters.get("Indenter/Type")
    if shape == "cone":
        return Tip.cone(run.number("Indenter/Semi-apex angle"))
    if shape == "sphere":
        return Tip.sphere(run.number("Indenter/Radius"))
    if shape == "area function":
        return Tip.polynomial(run.numbers("Indenter/Area coefficients"))
    if shape == "paraboloid":
        return Tip.polynomial([0., 2. * numpy.pi * run.number("Indenter/Radius")])
    if shape == "pyramid" and run.number("Indenter/Rounding radius") == 0.:
        return Tip.pyramid(run.number("Indenter/Number of faces"), run.number("Indenter/Face angle"),
                           run.number("Indenter/Truncation"))
    raise UserError(f"the indenter of the run in '{run.directory}', '{shape}', is none of cone, sphere, paraboloid, "
                    "sharp or truncated pyramid and area function: give the tip by --cone, --sphere or --area")


def choose_tip(arguments, run):
    if arguments.cone is not None:
        return Tip.cone(arguments.cone)
    if arguments.sphere is not None:
        return Tip.sphere(arguments.sphere)
    if arguments.area is not None:
        return Tip.polynomial(arguments.area)
    if run is None:
        raise UserError("there is no tip: give it by --cone, --sphere or --area, or a run that has it by --run")
    return tip_of_run(run)


def compliance(indenter, run):
    """(1 - nu^2) / E; 0 of a rigid indenter, None."""
    if indenter is None:
        return 0.
    modulus, ratio = indenter
    if modulus <= 0. or not -1. < ratio <= 0.5:
        raise UserError(f"--indenter is {modulus:g} {ratio:g}, but must be a modulus > 0 and a ratio from -1 to 0.5")
    if run is None:
        raise UserError("--indenter adds the compliance of the measurement's indenter to that of a run, and there is no "
                        "run: give it by --run, or leave out --indenter; E_r of the measurement includes it already")
    return (1. - ratio ** 2) / modulus


def run_to_compare(directory):
    run = Results(directory)
    run.expect("history.csv")
    if run.is_plane:
        raise UserError(f"the run in '{run.directory}' is one of plane strain or stress, whose indenter has no tip")
    if run.parameters.get("Indenter/Type") == "none":
        raise UserError(f"the run in '{run.directory}' has no indenter, so that there is nothing to compare with")
    return run


def measured_curve(arguments):
    """Depth from the zero point, and force; and the zero point."""
    depth, force = read_curve(arguments.curve, arguments.columns, arguments.factors)
    zero = find_zero_point(depth, force, arguments.zero_point, arguments.noise)
    if not depth.max() > zero:
        raise UserError(f"'{arguments.curve}' has no depth beyond its zero point, {zero:g}: turn the sign of "
                        f"'{arguments.columns[0]}' by --factors, or give another --zero-point")
    return (depth - zero, force), zero


def curve_of_run(run):
    """Depth from the zero point and force of the whole indenter; and the zero point."""
    zero = run.number("Indenter/Initial gap")
    return (run.history["depth"] - zero, run.history["force"] / run.modelled_part), zero


def check_results(name, unloadings):
    for unloading in unloadings:
        if not unloading.contact_depth > 0.:
            raise UserError(f"the {name} curve has a contact depth of {unloading.contact_depth:.6g}, but it must be above 0: "
                            "the depth at its largest force is too small for the slope of its unloading. Is the depth "
                            "counted from the first contact?")
        if not unloading.tip_area > 0.:
            raise UserError(f"the {name} curve has a contact depth of {unloading.contact_depth:.6g}, where the section of "
                            f"the tip is {unloading.tip_area:.6g}: are the tip and the curve in the same units?")
        if not numpy.isfinite(dataclasses.astuple(unloading)).all():
            raise UserError(f"the {name} curve has numbers too large or too small to be evaluated: choose other units")


def why_no_unloading(name, force, to_unload, to_refine):
    """What a curve without any unloading lacks, and the remedy: of one that does not unload, or too coarsely."""
    largest, lowest = force.max(), force[force.argmax():].min()
    shares = f"{100. * HIGHEST_SHARE:g} and {100. * LOWEST_SHARE:g} %"
    if lowest > HIGHEST_SHARE * largest:
        return (f"{name} has no unloading: its force does not fall below {100. * HIGHEST_SHARE:g} % of its largest value, "
                f"{largest:.6g}, but three points between {shares} of that are needed; {to_unload}")
    return f"{name} has no unloading with three points between {shares} of its largest force; {to_refine}"


def print_table(found, zero_points):
    print("curve", "zero_point", *(field.name for field in dataclasses.fields(Unloading)), sep=",")
    for name, unloadings in found.items():
        for unloading in unloadings:
            numbers = (zero_points[name], *dataclasses.astuple(unloading))
            print(name, *(f"{value:.6g}" for value in numbers), sep=",")


def main(arguments):
    arguments = parse_arguments(arguments)
    run = run_to_compare(arguments.run) if arguments.run else None
    tip = choose_tip(arguments, run)
    constants = {"beta": arguments.beta, "epsilon": arguments.epsilon}
    indenter_compliance = compliance(arguments.indenter, run)
    curves, zero_points = {}, {}
    curves["measured"], zero_points["measured"] = measured_curve(arguments)
    numpy.seterr(all="ignore")  # (check_results() says it)
    found = {"measured": evaluate(*curves["measured"], tip, noise=arguments.noise, **constants)}
    if run is not None:
        curves["computed"], zero_points["computed"] = curve_of_run(run)
        found["computed"] = evaluate(*curves["computed"], tip, jumps=jumps_of_meshes(run),
                                     indenter_compliance=indenter_compliance, **constants)
    for name, unloadings in found.items():
        check_results(name, unloadings)
    if any(found.values()):
        print_table(found, zero_points)
        if arguments.output:
            from .plots.experiment import draw  # (which needs matplotlib)
            draw(curves, found, arguments.output)
    lacking = []
    if not found["measured"]:
        lacking.append(why_no_unloading(f"'{arguments.curve}'", curves["measured"][1], "the file must hold it, in the order of "
                                        "time", "if the curve is noisy, try a larger --noise"))
    if run is not None and not found["computed"]:
        lacking.append(why_no_unloading(f"the run in '{arguments.run}'", curves["computed"][1], "let it unload, as by "
                                        "'Loading/History = 1: depth 0.02 | 2: force 0'", "let it unload in more "
                                        "'Loading/Number of steps'"))
    if lacking:
        raise UserError(". And ".join(lacking))
    return 0
