# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is unique about a fit: the family of materials that fit equally well, where their stress-strain curves cross,
and which further experiment would tell them apart."""

from dataclasses import dataclass

import numpy

from .flow_stress import flow_stress, total_strain
from .models import ProgramModel
from .optimisation import Derivatives
from .problem import Experiment, Problem
from .runs import expect
from .statistics import covariance

# Where stress-strain curves are looked at: plastic strains.
STRAINS = numpy.geomspace(1e-4, 0.5, 400)

# For the derivatives of a stress.
SMALL = 1e-4


@dataclass(frozen=True)
class Representative:
    """The plastic strain at which the stress is known best, the stress there, and its 95 % region. spread: the largest
    of the family over the smallest one there, less 1; spread_elsewhere: the same at the yield point."""
    plastic_strain: float
    total_strain: float
    stress: float
    lower: float
    upper: float
    spread: float
    spread_elsewhere: float


class Material:
    """The stress-strain curve as a function of the coordinates of a fit. entries: those of a run of the first
    experiment."""

    def __init__(self, problem, entries):
        self.problem, self.base = problem, entries

    def entries(self, x):
        values = self.problem.values(x) | self.problem.constants
        changed = self.problem.experiments[0].entries(values)
        return self.base | {path: ", ".join(map(str, value)) if isinstance(value, list) else value
                            for path, value in changed.items()}

    def stress(self, x, plastic_strain=STRAINS):
        return flow_stress(self.entries(x), plastic_strain)

    def curve(self, x, plastic_strain=STRAINS):
        """Total strain and stress, from the origin."""
        stress = self.stress(x, plastic_strain)
        strain = total_strain(self.entries(x), stress, plastic_strain)
        return numpy.append(0., strain), numpy.append(0., stress)

    @property
    def is_plastic(self):
        """Whether there is a stress-strain curve: with a rate law, the stress depends on the rate, too."""
        return (not self.base.get("Material/Law", "").startswith("linear elastic")
                and set(self.base.get("Material/Rate law", "none").replace(" ", "").split(",")) == {"none"})

    def log_slopes(self, x, plastic_strain):
        """Derivatives of the logarithm of the stress with respect to the coordinates."""
        found = []
        for i in range(len(x)):
            ends = [numpy.array(x) for _ in range(2)]
            for end, sign in zip(ends, (-1., 1.)):
                end[i] = numpy.clip(end[i] + sign * SMALL, *(bound[i] for bound in self.problem.bounds()))
            a, b = (numpy.log(self.stress(end, numpy.atleast_1d(plastic_strain))[0]) for end in ends)
            found.append((b - a) / (ends[1][i] - ends[0][i]))
        return numpy.array(found)


def family(x, ends, threshold):
    """All points of the profiles within the region, the best one first."""
    points = [point for pair in ends for end in pair for point, rise in end.points if rise <= 1.1 * threshold]
    return [x, *points]


def representative(material, points, matrix, spread_of_normal):
    """Where the curves of the family cross (dao_2001). matrix: covariance of the coordinates in directions
    that the data know (along others, the points say how far the stress goes); spread_of_normal: how many standard
    errors the region of 95 % reaches to each side."""
    x = points[0]
    stresses = numpy.array([material.stress(point) for point in points])
    spread = stresses.max(axis=0) / stresses.min(axis=0) - 1.
    k = int(spread.argmin())
    strain = float(STRAINS[k])
    slopes = material.log_slopes(x, strain)
    error = spread_of_normal * float(slopes @ matrix @ slopes) ** 0.5
    stress = float(stresses[0, k])
    lower = min(stress * numpy.exp(-error), stresses[:, k].min())
    upper = max(stress * numpy.exp(error), stresses[:, k].max())
    total = float(total_strain(material.entries(x), stress, strain))
    return Representative(strain, total, stress, float(lower), float(upper), float(spread[k]), float(spread[0]))


@dataclass(frozen=True)
class Candidate:
    """An experiment that has not been made, and the standard errors of the parameters that it would leave, by name."""
    name: str
    standard_errors: dict
    n_points: int


def candidates(problem, runs, x, jacobian, scale, step):
    """What each candidate would add to the derivatives at the fit."""
    found = []
    for candidate in problem.candidates:
        plan = Problem(problem.name, problem.parameters, problem.constants, [candidate], True)
        run = expect(ProgramModel(plan, runs, "fine").results(x)[0], f"the candidate '{candidate.name}'")
        blocks = [block for made in candidate.blocks for block in made(run)]
        experiment = Experiment(candidate.name, candidate.cases, candidate.formulas, blocks)
        model = ProgramModel(Problem(problem.name, problem.parameters, problem.constants, [experiment], True), runs,
                             "fine")
        residuals, = model.evaluate([x])
        added = Derivatives(model, step)(x, residuals)
        matrix = covariance(numpy.vstack([jacobian / scale ** 0.5, added]))
        errors = problem.slopes(x) * numpy.sqrt(numpy.diag(matrix))
        found.append(Candidate(candidate.name, dict(zip(problem.names, map(float, errors))), len(residuals)))
    return sorted(found, key=lambda candidate: sum(numpy.log(list(candidate.standard_errors.values()))))
