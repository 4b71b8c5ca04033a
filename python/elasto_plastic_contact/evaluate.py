# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Evaluate measured curves of force over depth, as instruments write them: hardness, moduli and more of each unloading,
by the method of Oliver and Pharr, and what has been assumed and corrected on the way.

    epc evaluate job.txt --berkovich
    epc evaluate test_1.hld test_2.hld --zero-point fit --drift instrument --json found.json --output found.png
    epc evaluate table.csv --columns depth=2,force=3 --unit depth=nm --unit force=mN --area-file tip.txt

Files: texts of Hysitron and Bruker (.txt, .hld), FischerScope, Agilent and KLA (texts, .xls, .xlsx), HDF5 of
micromechanics, and tables with any separator. Results are in mN, µm, GPa and nJ.

With --run, a curve beside that of a run, evaluated in the same way and in the units of the run; so are tables with
columns depth and force and no units, and those with --factors: these print the columns of indentation.csv
(doc/lookup/tables.md) for each unloading, in the units of the curve. Depths are counted from zero_point, the depth at the
first contact.

    epc evaluate measured.csv --cone 70.3 --beta 1.034
    epc evaluate measured.csv --run output/cone_axisymmetric --output both.png

A folder with results alone: hardness numbers of that run in their own units, Brinell's of a sphere, Vickers' (by the
contact area, and by the residual diagonal of the imprint) and Martens' of a pyramid.

    epc evaluate output/vickers_sector
"""

import dataclasses
import os

import numpy

from .errors import UserError
from .measured.arguments import own_units_only, parse_arguments
from .measured.columns import given_columns
from .measured.curve import in_own_units
from .measured.order import check_time, check_work
from .measured.readers import read_raw
from .measured.results import ResultsTable
from .measured.units import FACTORS, differ, factor, given_units, tidy
from .oliver_pharr import HIGHEST_SHARE, LOWEST_SHARE, Tip, Unloading, evaluate, jumps_of_meshes
from .pyramids import PYRAMIDS
from .results import Results
from .rounded_pyramid import section
from .tables import read_table
from .zero_point import find_zero_point


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
    if "time" in rows[0]:
        check_time(numpy.array([row["time"] for row in rows]), "time", f"'{path}'")
    check_work(*curve, f"'{path}'")
    return curve


def units_of_run(run, arguments):
    """Length and force of a run, in µm and mN. Raises UserError."""
    found = []
    for kind, given, entry in (("length", arguments.length_unit, "Length"), ("force", arguments.force_unit, "Force")):
        stands = run.parameters.get(f"Output/{entry} unit", "")
        unit = given or stands
        if factor(kind, unit) is None:
            raise UserError(f"the run in '{run.directory}' has the unit of {kind} '{unit}', which is none of "
                            f"{', '.join(FACTORS[kind])}: give it by --{kind}-unit")
        if differ(kind, unit, stands):
            raise UserError(f"the run in '{run.directory}' says that its unit of {kind} is {stands}, and --{kind}-unit "
                            f"{given} says otherwise: leave that out")
        found.append(factor(kind, tidy(unit)))
    return found


def read_curve_for_run(path, run, arguments):
    """Depth and force of a file of an instrument, in the units of the run."""
    curves = read_raw(path, given_columns(arguments.columns[0]) if arguments.columns else {})[1]
    if isinstance(curves, ResultsTable):
        raise UserError(f"'{path}' holds results, one row an indent, and no curve to compare with the run")
    number = (arguments.indents or [1])[0]
    if len(curves) > 1 and len(arguments.indents or []) != 1 or number > len(curves):
        raise UserError(f"'{path}' holds {len(curves)} indents, and one is compared with the run: choose it, such as "
                        "by --indents 1")
    curve = in_own_units(curves[number - 1], path, given_units(arguments.unit))
    length, force = units_of_run(run, arguments)
    return curve.depth / length, curve.force / force


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
    if shape == "pyramid":
        faces = run.number("Indenter/Number of faces"), run.number("Indenter/Face angle")
        rounding = run.number("Indenter/Rounding radius")
        if rounding > 0.:
            return Tip(lambda height: section(height, *faces, rounding), 0.75)
        return Tip.pyramid(*faces, run.number("Indenter/Truncation"))
    raise UserError(f"the indenter of the run in '{run.directory}', '{shape}', is none of cone, sphere, paraboloid, "
                    "pyramid and area function: give the tip by --cone, --sphere or --area")


def choose_tip(arguments, run):
    if arguments.cone is not None:
        return Tip.cone(arguments.cone)
    if arguments.sphere is not None:
        return Tip.sphere(arguments.sphere)
    if arguments.area is not None:
        return Tip.polynomial(arguments.area)
    if arguments.pyramid is not None:
        return Tip.pyramid(*arguments.pyramid)
    for name, pyramid in PYRAMIDS.items():
        if getattr(arguments, name):
            return Tip.pyramid(*pyramid)
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
        raise UserError("--indenter adds the compliance of the measurement's indenter to that of a run, and there is "
                        "no run: give it by --run, or leave out --indenter; E_r of the measurement includes it already")
    return (1. - ratio ** 2) / modulus


def run_to_compare(directory):
    run = Results(directory)
    run.expect("history.csv")
    if run.is_plane:
        raise UserError(f"the run in '{run.directory}' is one of plane strain or stress, whose indenter has no tip")
    if run.parameters.get("Indenter/Type") == "none":
        raise UserError(f"the run in '{run.directory}' has no indenter, so that there is nothing to compare with")
    return run


def measured_curve(arguments, run):
    """Depth from the zero point, and force; and the zero point."""
    path, = arguments.curve
    if has_own_units(arguments):
        names = arguments.columns if len(arguments.columns or []) == 2 else ["depth", "force"]
        depth, force = read_curve(path, names, arguments.factors or (1., 1.))
    else:
        depth, force = read_curve_for_run(path, run, arguments)
    zero = find_zero_point(depth, force, arguments.zero_point, arguments.noise)
    if not depth.max() > zero:
        raise UserError(f"'{path}' has no depth beyond its zero point, {zero:g}: turn the sign of the depths by "
                        "--factors, or give another --zero-point")
    return (depth - zero, force), zero


def curve_of_run(run):
    """Depth from the zero point and force of the whole indenter; and the zero point."""
    zero = run.number("Indenter/Initial gap")
    return (run.history["depth"] - zero, run.history["force"] / run.modelled_part), zero


def check_results(name, unloadings):
    for unloading in unloadings:
        if not unloading.contact_depth > 0.:
            raise UserError(f"the {name} curve has a contact depth of {unloading.contact_depth:.6g}, but it must be "
                            "above 0: the depth at its largest force is too small for the slope of its unloading. Is "
                            "the depth counted from the first contact?")
        if not unloading.tip_area > 0.:
            raise UserError(f"the {name} curve has a contact depth of {unloading.contact_depth:.6g}, where the section "
                            f"of the tip is {unloading.tip_area:.6g}: are the tip and the curve in the same units?")
        if not numpy.isfinite(dataclasses.astuple(unloading)).all():
            raise UserError(f"the {name} curve has numbers too large or too small to be evaluated: choose other units")


def why_no_unloading(name, force, to_unload, to_refine):
    """What a curve without any unloading lacks, and the remedy: of one that does not unload, or too coarsely."""
    largest, lowest = force.max(), force[force.argmax():].min()
    shares = f"{100. * HIGHEST_SHARE:g} and {100. * LOWEST_SHARE:g} %"
    if lowest > HIGHEST_SHARE * largest:
        return (f"{name} has no unloading: its force does not fall below {100. * HIGHEST_SHARE:g} % of its largest "
                f"value, {largest:.6g}, but three points between {shares} of that are needed; {to_unload}")
    return f"{name} has no unloading with three points between {shares} of its largest force; {to_refine}"


def print_table(found, zero_points):
    print("curve", "zero_point", *(field.name for field in dataclasses.fields(Unloading)), sep=",")
    for name, unloadings in found.items():
        for unloading in unloadings:
            numbers = (zero_points[name], *dataclasses.astuple(unloading))
            print(name, *(f"{value:.6g}" for value in numbers), sep=",")


def has_own_units(arguments):
    """Whether the curve is a table in units that are not named: of these factors, with two names of columns, or with
    those of this program's tables."""
    if arguments.factors or len(arguments.columns or []) == 2:
        return True
    if arguments.unit or arguments.columns or len(arguments.curve) > 1:
        return False
    try:
        return {"depth", "force"} <= set((read_table(arguments.curve[0]) or [{}])[0])
    except UserError:
        return False  # (no table of this kind: the readers of instruments say what is wrong with it)


def main(arguments):
    arguments = parse_arguments(arguments, __doc__)
    if not arguments.run and len(arguments.curve) == 1 and os.path.isdir(arguments.curve[0]):
        return evaluate_run(arguments)
    if arguments.run or has_own_units(arguments):
        return compare(arguments)
    from .measured.command import evaluate_and_show  # (which needs none of the above)
    return evaluate_and_show(arguments)


def evaluate_run(arguments):
    """The hardness numbers of a run. Raises UserError of options that are for curves."""
    from .hardness_numbers import show
    directory, = arguments.curve
    unless_given = vars(parse_arguments([directory], __doc__))
    for name, value in vars(arguments).items():
        if name not in ("length_unit", "force_unit") and value != unless_given[name]:
            raise UserError(f"--{name.replace('_', '-')} is for curves, and '{directory}' is a folder: leave it out, or "
                            f"compare a curve with this run by --run {directory}")
    run = run_to_compare(directory)
    length, force = units_of_run(run, arguments)
    return show(run, length / FACTORS["length"]["mm"], force / FACTORS["force"]["N"])


def compare(arguments):
    """A curve in the units of a run, or in those of its own, and the run beside it, if there is one."""
    own_units_only(arguments)
    run = run_to_compare(arguments.run) if arguments.run else None
    tip = choose_tip(arguments, run)
    constants = {"beta": arguments.beta, "epsilon": arguments.epsilon}
    indenter_compliance = compliance(arguments.indenter, run)
    curves, zero_points = {}, {}
    curves["measured"], zero_points["measured"] = measured_curve(arguments, run)
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
        lacking.append(why_no_unloading(f"'{arguments.curve[0]}'", curves["measured"][1], "the file must hold it, in "
                                                                                          "the order of "
                                        "time", "if the curve is noisy, try a larger --noise"))
    if run is not None and not found["computed"]:
        lacking.append(why_no_unloading(f"the run in '{arguments.run}'", curves["computed"][1], "let it unload, as by "
                                        "'Loading/History = 1: depth 0.02 | 2: force 0'", "let it unload in more "
                                        "'Loading/Number of steps'"))
    if lacking:
        raise UserError(". And ".join(lacking))
    return 0
