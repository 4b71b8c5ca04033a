# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Models of an experiment: what the optimisation sees. A model has 'lower' and 'upper', bounds of its coordinates,
'noise_is_known', whether its sigmas are those of the noise, and 'evaluate', which gives for each of several points the
residuals, (computed - measured) / sigma, or a Failure."""

import numpy

from .runs import Failure


class ProgramModel:
    """The runs of a problem in a stage, 'coarse' or 'fine'."""

    def __init__(self, problem, runs, stage):
        self.problem, self.runs, self.stage = problem, runs, stage
        self.lower, self.upper = problem.bounds()
        self.noise_is_known = problem.noise_is_known

    def tasks(self, x):
        """A run for each experiment."""
        values = self.problem.values(x) | self.problem.constants
        return [(experiment.cases.get(self.stage, experiment.cases["fine"]), experiment.entries(values))
                for experiment in self.problem.experiments]

    def results(self, x):
        return self.runs.results(self.tasks(x))

    def evaluate(self, points):
        tasks = [task for x in points for task in self.tasks(x)]
        found = self.runs.results(tasks)
        n = len(self.problem.experiments)
        return [self.residuals(found[i * n:(i + 1) * n]) for i in range(len(points))]

    def residuals(self, results):
        """Of all blocks, one after the other."""
        parts = []
        for experiment, result in zip(self.problem.experiments, results):
            if isinstance(result, Failure):
                return result
            parts += [(block.predict(result) - block.y) / block.sigma for block in experiment.blocks]
        return numpy.concatenate(parts)


class FunctionModel:
    """A function of the coordinates that gives the residuals, or raises ArithmeticError where it fails."""

    def __init__(self, function, lower, upper, noise_is_known=True):
        self.function, self.noise_is_known = function, noise_is_known
        self.lower, self.upper = numpy.asarray(lower, float), numpy.asarray(upper, float)
        self.n_evaluations = 0

    def evaluate(self, points):
        return [self.residuals(x) for x in points]

    def residuals(self, x):
        self.n_evaluations += 1
        try:
            return self.function(x)
        except ArithmeticError as error:
            return Failure(str(error))


class CorrectedModel:
    """A coarse model to which the difference of the fine one at a point is added, so that it is the fine one there;
    with the difference of the derivatives, too, it is so to the first order beside the point."""

    def __init__(self, coarse, correction, point=None, slopes=None):
        self.coarse, self.correction, self.point, self.slopes = coarse, correction, point, slopes
        self.lower, self.upper = coarse.lower, coarse.upper
        self.noise_is_known = coarse.noise_is_known

    def evaluate(self, points):
        return [found if isinstance(found, Failure) else found + self.correction_at(x)
                for x, found in zip(points, self.coarse.evaluate(points))]

    def correction_at(self, x):
        return self.correction if self.slopes is None else self.correction + self.slopes @ (x - self.point)
