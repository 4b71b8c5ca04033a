# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finds the material of a Problem: coarse stage, fine stage, errors, regions, what is unique."""

import time
from dataclasses import dataclass

import numpy
from scipy import stats

from .models import CorrectedModel, ProgramModel
from .optimisation import SMALLEST_STEP, Derivatives, minimise, noise_of, polish, start_of
from .profiles import better_point, profiles
from .runs import Runs
from .statistics import LEVEL, Quality, correlations, covariance, covariance_of_known, directions, quality
from .uniqueness import Material, candidates, family, representative
from ..errors import UserError
from ..study.execution import start as start_program

# Central differences of a function with errors e are best with steps (3 e)^(1/3), if its third derivatives are as large
# as its first ones; no step reaches farther than this.
LARGEST_STEP = 0.1

# An iteration on the coarse mesh ends at half a standard error: the fine one changes more.
COARSE_TOLERANCE = 0.25

# The width of a region, in logarithms or shares of the bounds, up to which a fit is called unique.
WIDE = 0.5

# How often the coarse model is shifted to the fine one and minimised anew.
MAPPINGS = 2


@dataclass(frozen=True)
class Region:
    """Of one parameter: 95 %. closed: whether lower and upper end are ends, and not the last value that was looked at.
    remarks: why not, for each end."""
    lower: float
    upper: float
    closed: tuple
    remarks: tuple


@dataclass(frozen=True)
class Fit:
    """x: coordinates of the best point; values: by name. matrix: covariance of the coordinates; directions: as
    statistics.directions(). ends: of the profiles; family: coordinates of points that fit equally well.
    results: the runs of the best point. representative: None without a plastic material. n_runs: how many the fit has
    looked at, n_made of which were not there yet."""
    problem: object
    x: numpy.ndarray
    values: dict
    standard_errors: dict
    regions: dict
    matrix: numpy.ndarray
    correlation: numpy.ndarray
    directions: list
    quality: Quality
    residuals: numpy.ndarray
    step: float
    ends: list
    family: list
    material: object
    representative: object
    candidates: list
    results: list
    converged: bool
    remarks: list
    n_runs: int
    n_made: int
    processor_seconds: float
    seconds: float

    @property
    def flattest(self):
        """The number of the parameter that the flat direction changes most."""
        return int(numpy.abs(self.directions[-1][2]).argmax())

    @property
    def verdict(self):
        """'not unique' if a region does not end within the bounds, 'hardly determined' if one is wider than WIDE, else
        'unique'."""
        if not all(all(region.closed) for region in self.regions.values()):
            return "not unique"
        widths = [upper.x[i] - lower.x[i] for i, (lower, upper) in enumerate(self.ends)]
        return "hardly determined" if max(widths) > WIDE else "unique"


def validate(problem, runs):
    """Refuses what the program refuses at the start, before the first run."""
    for stage in problem.stages:
        for case, entries in ProgramModel(problem, runs, stage).tasks(problem.start()):
            process = start_program(case, runs.folder / case.folder(entries), entries, runs.program, "--validate")
            if process.returncode != 0:
                raise UserError(f"the run at the start is refused: {process.stderr.strip()}")


def step_of(problem, model, x, report):
    """That of the problem, or what the noise of the model in the coordinates allows."""
    if problem.step is not None:
        return problem.step
    noise = noise_of(model, x)
    step = float(numpy.clip((3. * noise) ** (1. / 3.), SMALLEST_STEP, LARGEST_STEP))
    report(f"computed values have a noise of {noise:.2g} of their derivatives: these are taken by differences of "
           f"{step:.2g}")
    return step


class Solver:
    """The stages of a fit."""

    def __init__(self, problem, runs, report):
        self.problem, self.runs, self.report = problem, runs, report
        self.fine = ProgramModel(problem, runs, "fine")
        self.coarse = ProgramModel(problem, runs, "coarse") if "coarse" in problem.stages else None
        self.step = None

    def in_words(self, x):
        return ", ".join(f"{name} = {value:.5g}" for name, value in self.problem.values(x).items())

    def minimum(self):
        """The Minimum of the fine model."""
        x = self.problem.start()
        first = self.coarse or self.fine
        start_of(first, x)
        self.step = step_of(self.problem, first, x, self.report)
        if self.coarse:
            self.report("coarse stage")
            found = minimise(self.coarse, x, self.step, self.report, self.in_words, tolerance=COARSE_TOLERANCE)
            x = self.mapped(found)
        self.report("fine stage")
        return minimise(self.fine, x, self.step, self.report, self.in_words)

    def mapped(self, found):
        """Where the coarse model, shifted to be the fine one at the last point, has its minimum: a few coarse runs for
        each fine one."""
        free = numpy.arange(len(found.x))
        for _ in range(MAPPINGS):
            fine, = self.fine.evaluate([found.x])
            coarse, = self.coarse.evaluate([found.x])
            if not isinstance(fine, numpy.ndarray):
                break
            self.report(f"  coarse and fine together: {self.in_words(found.x)}: sum of squares {fine @ fine:.6g}")
            shifted = CorrectedModel(self.coarse, fine - coarse)
            found = polish(shifted, found.x, found.jacobian, free, residuals=fine)
        return found.x

    def regions(self, best, result_quality):
        """The two ProfileEnds of each coordinate: of the coarse model, corrected to be the fine one to the first order
        at the best point, if there is one."""
        model = self.corrected(best) if self.coarse else self.fine
        deviations = numpy.sqrt(numpy.diag(covariance(best.jacobian)))
        self.report(f"95 % regions by profiles, on the {'fine' if model is self.fine else 'coarse'} mesh")

        def told(i, end):
            parameter = self.problem.parameters[i]
            remark = f": {end.remark}" if end.remark else ""
            self.report(f"  {parameter.name} to {parameter.value(end.x[i]):.5g}{remark} "
                        f"({len(end.points)} points)")

        return profiles(model, best, result_quality.threshold, deviations, told)

    def corrected(self, best):
        """The fine model, if the coarse one fails there."""
        residuals, = self.coarse.evaluate([best.x])
        if not isinstance(residuals, numpy.ndarray):
            return self.fine
        slopes = Derivatives(self.coarse, self.step)(best.x, residuals)
        return CorrectedModel(self.coarse, best.residuals - residuals, best.x, best.jacobian - slopes)


def fit(problem, folder, program, at_once, report):
    """The Fit of a Problem, with its runs below a folder. Raises UserError."""
    begin = time.monotonic()
    with Runs(folder, program, at_once) as runs:
        validate(problem, runs)
        solver = Solver(problem, runs, report)
        best = solver.minimum()
        sizes = [len(block.y) for _, block in problem.blocks()]
        found = quality(best.residuals, sizes, len(best.x), problem.noise_is_known)
        ends = solver.regions(best, found)
        results = solver.fine.results(best.x)
        matrix = covariance(best.jacobian, found.scale)
        material = Material(problem, results[0].parameters)
        points = family(best.x, ends, found.threshold)
        width = float(stats.norm.ppf(0.5 * (1. + LEVEL)))
        planned = candidates(problem, runs, best.x, best.jacobian, found.scale, solver.step)
        remarks = [*problem.remarks(), *filter(None, (best.remark, found.remark))]
        if (better := better_point(ends, found.threshold)) is not None:
            remarks.append(f"there is a better point at {solver.in_words(better)}: begin there, by 'start'")
        return Fit(
            problem=problem, x=best.x, values=problem.values(best.x), matrix=matrix, correlation=correlations(matrix),
            standard_errors=dict(zip(problem.names,
                                     map(float, problem.slopes(best.x) * numpy.sqrt(numpy.diag(matrix))))),
            regions=regions_of(problem, ends), directions=directions(best.jacobian, found.scale), quality=found,
            residuals=best.residuals, step=solver.step, ends=ends, family=points, material=material,
            representative=representative(material, points, covariance_of_known(best.jacobian, found.scale), width)
            if material.is_plastic else None,
            candidates=planned, results=results, converged=best.converged, remarks=remarks,
            n_runs=len(runs.futures), n_made=runs.n_made,
            processor_seconds=runs.processor_seconds, seconds=time.monotonic() - begin)


def regions_of(problem, ends):
    found = {}
    for i, (parameter, (lower, upper)) in enumerate(zip(problem.parameters, ends)):
        found[parameter.name] = Region(parameter.value(lower.x[i]), parameter.value(upper.x[i]),
                                       (lower.is_closed, upper.is_closed), (lower.remark, upper.remark))
    return found
