# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""How often the 95 % regions of a fit hold the true values: the data of a problem are replaced by what its model
computes for a known material, with as many different noises as are asked for, and each is fitted.

usage: scripts/command.py fit_coverage PROBLEM.json --truth VALUE ... [--stage coarse] [--repetitions 100] [--seed 1]
                                       [--at-once 2] [--output-directory DIRECTORY] [--program PROGRAM]

Each fit makes runs of its own, from the known material on, with the derivatives there; a true value lies in the region
of its parameter if the sum of squares with this value held, least over all other parameters, is higher than the least
one by at most 3.84. A command that has been stopped goes on where it was. Columns: how many regions hold the true
value, of how many; mean and standard deviation of (value - truth) / standard error. Last line: mean sum of squares over
its degrees of freedom, and runs that were made.
"""

import argparse
import concurrent.futures
import pathlib

import numpy
from scipy import stats

from elasto_plastic_contact.arguments import number, one_of
from elasto_plastic_contact.errors import UserError
from elasto_plastic_contact.fitting.models import CorrectedModel, ProgramModel
from elasto_plastic_contact.fitting.optimisation import SMALLEST_STEP, Derivatives, polish, start_of
from elasto_plastic_contact.fitting.profiles import held
from elasto_plastic_contact.fitting.reading import read_problem
from elasto_plastic_contact.fitting.runs import Runs
from elasto_plastic_contact.fitting.statistics import LEVEL, covariance
from elasto_plastic_contact.program import add_program, find_program
from elasto_plastic_contact.study.command import open_folder


class Repetitions:
    """Fits of many noises to the model at a known point."""

    def __init__(self, model, truth):
        self.model, self.truth = model, truth
        self.exact = start_of(model, truth)
        self.jacobian = Derivatives(model, 2. * SMALLEST_STEP)(truth, self.exact)

    def __call__(self, seed):
        """For each parameter whether its region holds the true value, and the deviation over the standard error; the
        sum of squares; None if the fit, or one with a true value held that would be outside, has not converged."""
        noise = numpy.random.default_rng(seed).normal(size=len(self.exact))
        model = CorrectedModel(self.model, -self.exact - noise)
        everything = numpy.arange(len(self.truth))
        best = polish(model, self.truth, self.jacobian, everything)
        if best is None or not best.converged:
            return None
        inside = []
        for i in everything:
            there = held(model, best, i, self.truth[i], [j for j in everything if j != i])
            is_inside = there is not None and there.chi_square - best.chi_square <= stats.chi2.ppf(LEVEL, 1)
            if not is_inside and (there is None or not there.converged):
                return None
            inside.append(is_inside)
        errors = numpy.sqrt(numpy.diag(covariance(best.jacobian)))
        return inside, (best.x - self.truth) / errors, best.chi_square


def parse(arguments):
    parser = argparse.ArgumentParser(prog="fit_coverage", formatter_class=argparse.RawDescriptionHelpFormatter,
                                     description=__doc__)
    parser.add_argument("problem", type=pathlib.Path)
    parser.add_argument("--truth", type=number(), nargs="+", required=True,
                        help="the value of each parameter, in the order of the file")
    parser.add_argument("--stage", type=one_of(("coarse", "fine")), default="coarse",
                        help="whose mesh (default: %(default)s)")
    parser.add_argument("--repetitions", type=number(int, least=2), default=100, help="default: %(default)s")
    parser.add_argument("--seed", type=number(int, least=0), default=1,
                        help="of the first noise (default: %(default)s)")
    parser.add_argument("--at-once", type=number(int, least=1), default=2, help="runs at a time (default: %(default)s)")
    parser.add_argument("--output-directory", type=pathlib.Path, default="output/fit_coverage",
                        help="default: %(default)s")
    add_program(parser)
    return parser.parse_args(arguments)


def main(arguments):
    chosen = parse(arguments)
    program = find_program(chosen.program)
    problem = read_problem(chosen.problem, program)
    if len(chosen.truth) != len(problem.parameters):
        raise UserError(f"--truth has {len(chosen.truth)} values, but the parameters are {', '.join(problem.names)}")
    truth = numpy.array([p.coordinate(value) for p, value in zip(problem.parameters, chosen.truth)])
    with (open_folder(chosen.output_directory, "coverage"),
          Runs(chosen.output_directory, program, chosen.at_once) as runs):
        repeat = Repetitions(ProgramModel(problem, runs, chosen.stage), truth)
        found = []
        with concurrent.futures.ThreadPoolExecutor(chosen.at_once) as pool:
            for i, result in enumerate(pool.map(repeat, range(chosen.seed, chosen.seed + chosen.repetitions)), 1):
                found.append(result)
                if i % 10 == 0:
                    print(f"{i} of {chosen.repetitions}, {runs.n_made} runs", flush=True)
        print_table(problem, found, len(repeat.exact), runs)
    return 0


def print_table(problem, found, n_residuals, runs):
    good = [result for result in found if result is not None]
    if len(good) < len(found):
        print(f"{len(found) - len(good)} of {len(found)} fits have not converged")
    for i, name in enumerate(problem.names):
        deviations = numpy.array([result[1][i] for result in good])
        print(f"{name:16} {sum(bool(result[0][i]) for result in good)} of {len(good)}, deviations "
              f"{deviations.mean():.2f} +- {deviations.std(ddof=1):.2f}")
    freedom = n_residuals - len(problem.names)
    print(f"sum of squares over degrees of freedom {numpy.mean([result[2] for result in good]) / freedom:.3f}, "
          f"{runs.n_made} runs, {runs.processor_seconds:.0f} s of processors")
