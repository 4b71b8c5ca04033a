# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the residuals at a minimum and their derivatives say: errors, correlations, directions, independent points."""

from dataclasses import dataclass

import numpy
from scipy import stats

# The sum of squares is taken for one that the given noise does not explain below this probability.
IMPROBABLE = 1e-3
LEVEL = 0.95


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
    autocorrelations up to the first that is not positive)."""
    n = len(residuals)
    deviations = residuals - residuals.mean() if n > 1 else residuals
    variance = deviations @ deviations
    if n < 8 or variance == 0.:
        return float(n)
    total = 1.
    for lag in range(1, n // 2):
        correlation = (deviations[lag:] @ deviations[:-lag]) / variance
        # (below what independent values have by chance)
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
    if real_freedom < 1. or chi_square == 0.:
        return Quality(chi_square, freedom, 1., float(stats.chi2.ppf(LEVEL, 1)), independent,
                       "there are no more independent values than parameters, so that no noise can be estimated: the "
                       "errors are those of a noise of 1 % of the largest value" if not noise_is_known else "")
    # (variance of a residual chi^2 / n * independent / freedom, and n / independent of them for one that counts)
    scale = chi_square / real_freedom
    remark = ""
    if noise_is_known:
        remark = (f"the residuals are larger than the given noise explains (sum of squares {chi_square:.4g} of "
                  f"{freedom} degrees of freedom): model or noise are wrong, and the errors are multiplied by "
                  f"{scale ** 0.5:.3g}")
    return Quality(chi_square, freedom, scale, scale * float(stats.f.ppf(LEVEL, 1, real_freedom)), independent, remark)


def covariance(jacobian, scale=1.):
    """Of the coordinates, scale (J^T J)^-1; infinite along directions that the data say nothing of."""
    _, singular, directions = numpy.linalg.svd(jacobian, full_matrices=False)
    smallest = max(jacobian.shape) * numpy.finfo(float).eps * singular.max(initial=0.)
    inverse = numpy.where(singular > smallest, 1. / numpy.maximum(singular, 1e-300), 1e8)
    return scale * (directions.T * inverse ** 2) @ directions


def correlations(matrix):
    deviations = numpy.sqrt(numpy.diag(matrix))
    return matrix / numpy.outer(deviations, deviations)


def directions(jacobian, scale=1.):
    """Singular values of the derivatives and their directions in coordinates, best known first: pairs of the standard
    error along the direction and its components, the largest of which is positive."""
    _, singular, rows = numpy.linalg.svd(jacobian, full_matrices=False)
    signs = numpy.sign(rows[numpy.arange(len(rows)), numpy.abs(rows).argmax(axis=1)])
    return [(float(value), float(scale ** 0.5 / max(value, 1e-300)), row * sign)
            for value, row, sign in zip(singular, rows, signs)]
