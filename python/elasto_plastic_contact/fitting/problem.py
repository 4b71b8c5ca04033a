# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parts of a fit: parameters, experiments, and what was measured in each."""

import pathlib
from dataclasses import dataclass, field

import numpy

from ..program import build_of
from ..study.plan import Case


@dataclass(frozen=True)
class Parameter:
    """One that is looked for, between its bounds. The optimisation sees its coordinate: the logarithm, or, on a linear
    scale, the value over the distance of the bounds."""
    name: str
    start: float
    lower: float
    upper: float
    is_logarithmic: bool

    @property
    def size(self):
        return self.upper - self.lower

    def coordinate(self, value):
        return numpy.log(value) if self.is_logarithmic else value / self.size

    def value(self, coordinate):
        value = float(numpy.exp(coordinate) if self.is_logarithmic else coordinate * self.size)
        return min(max(value, self.lower), self.upper)  # (a bound stays one after rounding)

    def slope(self, value):
        """The derivative of the value with respect to the coordinate."""
        return value if self.is_logarithmic else self.size


@dataclass(frozen=True)
class Block:
    """Numbers that are measured in one go, and how to find their like in the Results of a run, in units of the case.

    kind: load, unload, hold, imprint, columns or quantity. x: places (empty for a quantity); y: what was measured there
    (nan in a candidate); sigma: standard deviations, or weights if the noise is not known. labels: of x and y.
    remark: a sentence on what has been assumed, empty if there is none."""
    name: str
    kind: str
    x: numpy.ndarray
    y: numpy.ndarray
    sigma: numpy.ndarray
    predict: object
    labels: tuple = ("", "")
    remark: str = ""


@dataclass(frozen=True)
class Experiment:
    """cases: by stage, 'coarse' and 'fine', with their common entries; formulas: entries that depend on the parameters,
    Formulas or lists of them; units: names of those of length and force, as far as they are known, for pictures."""
    name: str
    cases: dict
    formulas: dict
    blocks: list
    units: dict = field(default_factory=dict)

    def entries(self, values):
        """Those of a run with these values of parameters and constants."""
        return {path: [part(values) for part in parts] if isinstance(parts, list) else parts(values)
                for path, parts in self.formulas.items()}


@dataclass(frozen=True)
class Problem:
    """noise_is_known: sigma of all blocks are standard deviations. step: of derivatives, in coordinates; None: by the
    smoothness of the curves. candidates: experiments that have not been made."""
    name: str
    parameters: list
    constants: dict
    experiments: list
    noise_is_known: bool
    at_once: int = 1
    step: float = None
    candidates: list = field(default_factory=list)

    @property
    def names(self):
        return [parameter.name for parameter in self.parameters]

    @property
    def stages(self):
        return ("coarse", "fine") if any("coarse" in e.cases for e in self.experiments) else ("fine",)

    def start(self):
        return numpy.array([p.coordinate(p.start) for p in self.parameters])

    def bounds(self):
        return tuple(numpy.array([p.coordinate(getattr(p, end)) for p in self.parameters])
                     for end in ("lower", "upper"))

    def values(self, coordinates):
        """By name, in the order of the parameters."""
        return {p.name: p.value(x) for p, x in zip(self.parameters, coordinates)}

    def slopes(self, coordinates):
        """Derivatives of the values with respect to the coordinates."""
        return numpy.array([p.slope(p.value(x)) for p, x in zip(self.parameters, coordinates)])

    def blocks(self):
        return [(experiment, block) for experiment in self.experiments for block in experiment.blocks]

    def remarks(self):
        """Sentences on what has been assumed of the data."""
        return list(dict.fromkeys(block.remark for _, block in self.blocks() if block.remark))


def case_of(path, entries, ranks, program=None):
    return Case(case=pathlib.Path(path), common={"Output/Fields": "never"} | entries, ranks=ranks,
                build=build_of(program))
