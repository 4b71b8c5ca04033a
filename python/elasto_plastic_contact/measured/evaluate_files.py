# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Evaluates the files of instruments: reads, corrects, evaluates, and says what has been assumed."""

import os
from dataclasses import dataclass, replace

from ..errors import UserError
from ..oliver_pharr import HIGHEST_SHARE, LOWEST_SHARE, Tip
from ..pyramids import PYRAMIDS
from .corrections import from_zero_point, without_drift, without_frame
from .curve import in_own_units
from .evaluation import Constants, evaluate_indent
from .lengths import Length
from .readers import read_raw
from .results import ResultsTable
from .segments import find_segments, scatter_of
from .tips import polynomial, read_area, tip_of_instrument
from .units import factor

DIAMOND = (1141., 0.07)


@dataclass(frozen=True)
class Evaluation:
    """Of all files: sentences on how they were read and on the constants, and their Indents."""
    files: list
    constants: Constants
    sentences: list
    indents: list


def read_files(arguments, chosen, given):
    """The formats, the unit of depth of the first file, and the curves of all; or the ResultsTable of the only one."""
    formats, curves, depth_unit = [], [], ""
    for path in arguments.curve:
        name, found = read_raw(path, chosen)
        if isinstance(found, ResultsTable):
            if len(arguments.curve) > 1:
                raise UserError(f"'{path}' holds results, one row an indent, and no curve: give it alone")
            return [], "", found
        formats.append(f"{path}: {name}, {len(found)} indent{'s' if len(found) > 1 else ''}")
        for curve in found:
            depth_unit = depth_unit or curve.units.get("depth") or given.get("depth", "")
            scaled = in_own_units(curve, path, given)
            prefix = f"{os.path.basename(path)} " if len(arguments.curve) > 1 else ""
            curves.append(replace(scaled, name=prefix + (curve.name if len(found) > 1 or not prefix else "")).named())
    return formats, depth_unit, choose_indents(curves, arguments.indents)


def choose_indents(curves, chosen):
    """By their numbers, from 1. Raises UserError."""
    if not chosen:
        return curves
    for number in chosen:
        if number > len(curves):
            raise UserError(f"--indents has {number}, but there are {len(curves)} of them, numbered from 1")
    return [curves[number - 1] for number in chosen]


def given_tip(arguments, unit):
    """The Tip that was asked for, and a sentence; None if there is none. unit: of its lengths, unless told."""
    if arguments.pyramid is not None:
        n_faces, angle = arguments.pyramid
        return Tip.pyramid(n_faces, angle), f"a sharp pyramid with {n_faces:g} faces at {angle:g}° to the axis"
    for name, (n_faces, angle) in PYRAMIDS.items():
        if getattr(arguments, name):
            name = name.replace("_", " ").capitalize()
            return Tip.pyramid(n_faces, angle), f"{name}, sharp: {n_faces} faces at {angle:g}° to the axis"
    if arguments.cone is not None:
        return Tip.cone(arguments.cone), f"a sharp cone, {arguments.cone:g}° between axis and flank"
    tip_unit = arguments.tip_unit or unit
    length = factor("length", tip_unit)
    if arguments.sphere is not None:
        return Tip.sphere(arguments.sphere * length), f"a sphere of radius {arguments.sphere:g} {tip_unit}"
    if arguments.area is not None:
        return polynomial(arguments.area, length), (f"area function {', '.join(f'{c:g}' for c in arguments.area)} of "
                                                    f"h^2, h, h^(1/2) and so on, h in {tip_unit}")
    if arguments.area_file is not None:
        tip, sentence = read_area(arguments.area_file, length)
        return tip, f"area function: {sentence}, lengths in {tip_unit}"
    return None


def choose_tip(arguments, unit, curves, cycles):
    """The Tip, None if none is known, and a sentence."""
    given = given_tip(arguments, unit)
    if given is not None:
        return given
    found = tip_of_instrument(curves, cycles, 0.75 if arguments.epsilon is None else arguments.epsilon)
    if found is not None:
        return found[0], f"area function of the instrument: {found[1]}"
    return None, ("not known, so that there is no hardness and no modulus: give it by --berkovich, --vickers, --cone, "
                  "--sphere, --area or --area-file")


def corrected(curve, arguments, unit):
    """The curve with what was asked for, its segments, its cycles, and sentences."""
    segments, cycles = find_segments(curve, arguments.noise)
    sentences = list(curve.remarks)
    scatter, largest = scatter_of(curve.force), curve.force.max()
    if scatter > arguments.noise * largest > 0.:
        sentences.append(f"noise: the force scatters, so that a segment ends where it turns back by {scatter / largest:.1%} of its "
                         "largest value")
    if arguments.drift is not None:
        curve, sentence = without_drift(curve, arguments.drift, segments)
        sentences.append(sentence)
    if arguments.frame_compliance is not None:
        curve, sentence = without_frame(curve, arguments.frame_compliance)
        sentences.append(sentence)
    zero = arguments.zero_point
    curve, sentence = from_zero_point(curve, zero if zero in (None, "fit") else Length.of(zero, unit), arguments.noise)
    sentences += [sentence, *not_subtracted(curve, arguments)]
    return curve, segments, cycles, sentences


def not_subtracted(curve, arguments):
    """What the file knows and was not asked for."""
    if curve.notes.drift_rate is not None and arguments.drift is None:
        yield f"drift: the file says {1e3 * curve.notes.drift_rate:.4g} nm/s; not subtracted (--drift instrument would)"
    if curve.notes.frame_compliance is not None and arguments.frame_compliance is None:
        yield (f"frame: the file says {1e3 * curve.notes.frame_compliance:.4g} nm/mN; not subtracted "
               "(--frame-compliance instrument would, if the instrument has not done so)")


def evaluate_files(arguments, chosen, given):
    """An Evaluation, or the ResultsTable that stand in the file. Raises UserError."""
    formats, unit, curves = read_files(arguments, chosen, given)
    if isinstance(curves, ResultsTable):
        return curves
    parts = [corrected(curve, arguments, unit) for curve in curves]
    tip, sentence = choose_tip(arguments, unit, [part[0] for part in parts], [part[2] for part in parts])
    constants = constants_of(tip, arguments)
    indents = []
    for curve, segments, cycles, sentences in parts:
        indent = evaluate_indent(curve, segments, cycles, constants)
        indents.append(replace(indent, remarks=(*sentences, *indent.remarks, *too_deep(indent))))
    sentences = [*formats, f"tip: {sentence}", sentence_on(constants, arguments)]
    return Evaluation(list(arguments.curve), constants, sentences, indents)


def constants_of(tip, arguments):
    return Constants(tip, arguments.beta, arguments.epsilon, tuple(arguments.fit or (LOWEST_SHARE, HIGHEST_SHARE)),
                     tuple(arguments.indenter or DIAMOND), arguments.poisson)


def too_deep(indent):
    limit = indent.curve.notes.usable_depth
    if limit is not None and any(found.get("contact_depth", 0.) > limit for found in indent.unloadings):
        yield f"the area function of the file holds up to {limit:g} µm only"


def sentence_on(constants, arguments):
    epsilon = constants.epsilon
    if epsilon is None:
        epsilon = constants.tip.depth_factor if constants.tip else 0.75
    low, high = constants.shares
    return (f"constants: beta {constants.beta:g}, epsilon {epsilon:.4g}, unloadings fitted from {100. * high:g} to "
            f"{100. * low:g} %, indenter "
            f"{constants.indenter[0]:g} GPa, {constants.indenter[1]:g}" + ("" if arguments.indenter else " (diamond)"))
