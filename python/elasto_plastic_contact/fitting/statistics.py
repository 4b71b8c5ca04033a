# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the residuals at a minimum and their derivatives say: errors, correlations, directions, independent points."""

from dataclasses import dataclass

import numpy
from scipy import stats

# The sum of squares is taken for one that the given noise does not explain below this probability.
IMPROBABLE = 1e-3
LEVEL = 0.95

# The standard error, in coordinates, of what the data say nothing of: far beyond all bounds.
UNKNOWN = 1e8


@dataclass(frozen=True)
class Quality:
    """chi_square and its degrees of freedom. scale: the variance over that of the sigmas, as estimated from the
    residual (1: the noise is known, and explains it). threshold: by how much the sum of squares may be larger, at the
    end of the 95 % region of one parameter. remark: a sentence, or empty. independent: how many points the residuals
    are worth."""
    chi_square: float
    freedom: float
    scale: float
    threshold: float
    independent: float
    remark: str


def independent_points(residuals):
    """How many independent values have a mean as sure as these, one after the other: n / (1 + 2 sum of the
    autocorrelations up to the first that is below 2 / sqrt(n), as those of independent values are)."""
    n = len(residuals)
    deviations = residuals - residuals.mean() if n > 1 else residuals
    variance = deviations @ deviations
    if n < 8 or variance == 0.:
        return float(n)
    total = 1.
    for lag in range(1, n // 2):
        correlation = (deviations[lag:] @ deviations[:-lag]) / variance
        if correlation < 2. / n ** 0.5:
            break
        total += 2. * correlation
    return n / total


def quality(residuals, sizes, n_parameters, noise_is_known):
    """The Quality of a minimum. sizes: how many of the residuals belong to each block."""
    blocks = numpy.split(residuals, numpy.cumsum(sizes)[:-1])
    independent = sum(map(independent_points, blocks))
    chi_square, freedom = float(residuals @ residuals), len(residuals) - n_parameters
    if noise_is_known and (freedom <= 0 or stats.chi2.sf(chi_square, freedom) > IMPROBABLE):
        return Quality(chi_square, freedom, 1., float(stats.chi2.ppf(LEVEL, 1)), independent, "")
    real_freedom = independent - n_parameters
    if not noise_is_known and (real_freedom < 1. or chi_square == 0.):
        return Quality(chi_square, freedom, 1., float(stats.chi2.ppf(LEVEL, 1)), independent,
                       "there are no more independent values than parameters, so that no noise can be estimated: the "
                       "errors are those of a noise of 1 % of the largest value")
    # (residuals that are all trend are worth one degree of freedom: their errors are the largest ones)
    real_freedom = max(real_freedom, 1.)
    # (variance of a residual chi^2 / n * independent / freedom, and n / independent of them for one that counts)
    scale = chi_square / real_freedom
    remark = ""
    if noise_is_known:
        remark = (f"the residuals are larger than the given noise explains (sum of squares {chi_square:.4g} of "
                  f"{freedom} degrees of freedom): model or noise are wrong, and the errors are multiplied by "
                  f"{scale ** 0.5:.3g}")
    return Quality(chi_square, freedom, scale, scale * float(stats.f.ppf(LEVEL, 1, real_freedom)), independent, remark)


def singular_values(jacobian):
    """As many as there are coordinates, largest first, zero where the data say nothing, and their directions (rows)."""
    n_rows, n_coordinates = jacobian.shape
    # (with rows of zeros, there are as many values as coordinates also of fewer residuals)
    square = numpy.vstack([jacobian, numpy.zeros((max(n_coordinates - n_rows, 0), n_coordinates))])
    _, singular, rows = numpy.linalg.svd(square, full_matrices=False)
    smallest = max(square.shape) * numpy.finfo(float).eps * singular.max(initial=0.)
    return numpy.where(singular > smallest, singular, 0.), rows


def standard_errors(singular, scale):
    """Along the directions of singular values; UNKNOWN along those that the data say nothing of."""
    return numpy.where(singular > 0., scale ** 0.5 / numpy.where(singular > 0., singular, 1.), UNKNOWN)


def covariance(jacobian, scale=1.):
    """Of the coordinates, scale (J^T J)^-1; UNKNOWN squared along directions that the data say nothing of."""
    singular, directions = singular_values(jacobian)
    return (directions.T * standard_errors(singular, scale) ** 2) @ directions


def covariance_of_known(jacobian, scale=1.):
    """As covariance(), but zero along directions that the data say nothing of."""
    singular, directions = singular_values(jacobian)
    is_known = singular > 0.
    return (directions[is_known].T * standard_errors(singular[is_known], scale) ** 2) @ directions[is_known]


def correlations(matrix):
    deviations = numpy.sqrt(numpy.diag(matrix))
    return matrix / numpy.outer(deviations, deviations)


def directions(jacobian, scale=1.):
    """Singular values of the derivatives and their directions in coordinates, as many as these, best known first: with
    the standard error along the direction, and its components, the largest of which is positive."""
    singular, rows = singular_values(jacobian)
    signs = numpy.sign(rows[numpy.arange(len(rows)), numpy.abs(rows).argmax(axis=1)])
    return [(float(value), float(error), row * sign)
            for value, error, row, sign in zip(singular, standard_errors(singular, scale), rows, signs)]
