# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a candidate would measure: an experiment that has not been made, whose data are those of the run at the fit."""

import numpy

from .data import LOWEST, deviations, named_quantity
from .predictions import Curve, curve_at, imprint_at
from .problem import Block
from .values import number, texts
from ..errors import UserError
from ..study.plan import check_keys, choice

KINDS = {"curve": ("segments", "compare", "points"), "imprint": ("points",), "quantity": ("fit",)}

N_POINTS = 40

# How far an imprint is measured, in contact radii.
IMPRINT_RADII = 3.


def read_candidate_data(data, place):
    """A function that makes, of the Results at the fit, the Blocks of an item of 'data'. Raises UserError."""
    if not isinstance(data, dict) or sum(kind in data for kind in KINDS) != 1 or "noise" not in data:
        raise UserError(f"'{place}' must be an object with one of the keys {', '.join(KINDS)} and a 'noise'")
    kind = next(kind for kind in KINDS if kind in data)
    check_keys(data, f"'{place}'", (kind, "noise"), KINDS[kind])
    n_points = number(data, "points", place, N_POINTS, convert=int, least=2)
    if kind == "curve":
        segments = texts(data, "segments", place) if "segments" in data else ["load", "unload"]
        for segment in segments:
            choice(segment, f"{place}/segments", ["load", "unload"])
        compared = choice(data.get("compare", "force"), f"{place}/compare", ["force", "depth"])
        return lambda run: [curve_block(run, data, place, segment, compared, n_points) for segment in segments]
    if kind == "imprint":
        return lambda run: [imprint_block(run, data, place, n_points)]
    _, find = named_quantity(data, place)
    return lambda run: [block_of(data, place, "quantity", run, lambda other: numpy.atleast_1d(find(other)))]


def block_of(data, place, kind, run, predict):
    y = predict(run)
    return Block(place, kind, numpy.empty(0), y, deviations({"noise": data["noise"]}, place, y), predict)


def curve_block(run, data, place, segment, compared, n_points):
    rows = Curve(run).segment(segment)
    known = rows[:, 0 if compared == "force" else 1]
    used = rows[:, 1] >= LOWEST * rows[:, 1].max()
    places = numpy.linspace(known[used].min(), known[used].max(), n_points)
    return block_of(data, place, segment, run, lambda other: curve_at(other, segment, compared, places))


def imprint_block(run, data, place, n_points):
    places = numpy.linspace(0., IMPRINT_RADII * run.history["contact_radius"].max(), n_points)
    return block_of(data, place, "imprint", run, lambda other: imprint_at(other, places))
