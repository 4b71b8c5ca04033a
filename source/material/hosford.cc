// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <boost/math/tools/roots.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "material/hosford.h"

namespace ElastoPlastic
{
  // With p = r^{a-1} and s = (1-r)^{a-1}, q^a = (1 + r p + (1 - r) s) / 2, and
  // q (n_1 - n_3) = b (2 + p + s), q (n_1 - n_2) = b (1 + 2 p - s), where b =
  // q^{2-a} / 2.
  HosfordCriterion::Shape
  HosfordCriterion::shape(const double r) const
  {
    const double a = exponent;
    const double p = std::pow(r, a - 1.), s = std::pow(1. - r, a - 1.);
    const double p_slope = (a - 1.) * std::pow(r, a - 2.);
    const double s_slope = -(a - 1.) * std::pow(1. - r, a - 2.);
    const double power   = 0.5 * (1. + r * p + (1. - r) * s);
    const double q       = std::pow(power, 1. / a);
    const double b       = 0.5 * q * q / power;
    const double b_slope = 0.5 * (2. - a) * b * (p - s) / power;
    const double all = 2. + p + s, first = 1. + 2. * p - s;
    return {q,
            b * all,
            b * first,
            b_slope * all + b * (p_slope + s_slope),
            b_slope * first + b * (2. * p_slope - s_slope)};
  }



  HosfordCriterion::Relaxation::Relaxation(const HosfordCriterion &criterion,
                                           const Tensor3          &trial)
    : criterion(criterion)
  {
    const auto pairs =
      eigenvectors(trial, SymmetricTensorEigenvectorMethod::jacobi);
    for (unsigned int d = 0; d < 3; ++d)
      std::tie(this->trial[d], axes[d]) = pairs[d];
    set_ratio(0.);
  }



  // Differences of z + t q n = xi, the first of them divided by the other:
  // r + t q (n_1 - n_2) = rho (1 + t q (n_1 - n_3)) at the range 1. The left
  // side exceeds the right one, at most, at r = 1, and at least at r = 0.
  void
  HosfordCriterion::Relaxation::set_ratio(const double t)
  {
    constexpr int digits = std::numeric_limits<double>::digits * 3 / 5;
    constexpr std::uintmax_t max_iterations = 200;

    ratio                       = t;
    const double   all          = trial[0] - trial[2];
    const double   direction    = all > 0. ? (trial[0] - trial[1]) / all : 0.;
    std::uintmax_t n_iterations = max_iterations;
    place                       = direction;
    if (t > 0. && direction > 0. && direction < 1.)
      place = boost::math::tools::newton_raphson_iterate(
        [&](const double r) {
          const Shape at = criterion.shape(r);
          return std::make_pair(
            r - direction + t * (at.across_first - direction * at.across_all),
            1. + t * (at.across_first_slope - direction * at.across_all_slope));
        },
        direction,
        0.,
        1.,
        digits,
        n_iterations);
    range = all / (1. + t * criterion.shape(place).across_all);
  }



  double
  HosfordCriterion::Relaxation::equivalent_stress() const
  {
    return range * criterion.shape(place).equivalent;
  }



  // (n is a deviator.)
  SymmetricTensor<2, 3>
  HosfordCriterion::Relaxation::normal() const
  {
    const Shape  at    = criterion.shape(place);
    const double all   = at.across_all / at.equivalent;
    const double first = at.across_first / at.equivalent;
    return ((all + first) * symmetrize(outer_product(axes[0], axes[0])) +
            (all - 2. * first) * symmetrize(outer_product(axes[1], axes[1])) +
            (first - 2. * all) * symmetrize(outer_product(axes[2], axes[2]))) /
           3.;
  }



  Tensor<2, 3>
  HosfordCriterion::Relaxation::principal_derivative() const
  {
    // of (z_1 - z_3, z_1 - z_2) with respect to the same of xi
    const Shape  at = criterion.shape(place);
    Tensor<2, 2> slopes;
    slopes[0][0] = 1. + ratio * (at.across_all - place * at.across_all_slope);
    slopes[0][1] = ratio * at.across_all_slope;
    slopes[1][0] = ratio * (at.across_first - place * at.across_first_slope);
    slopes[1][1] = 1. + ratio * at.across_first_slope;
    const Tensor<2, 2> inverse = invert(slopes);

    constexpr double to_values[3][2]      = {{1, 1}, {1, -2}, {-2, 1}};
    constexpr double to_differences[2][3] = {{1, 0, -1}, {1, -1, 0}};
    Tensor<2, 3>     result;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        for (unsigned int k = 0; k < 2; ++k)
          for (unsigned int l = 0; l < 2; ++l)
            result[i][j] +=
              to_values[i][k] / 3. * inverse[k][l] * to_differences[l][j];
    return result;
  }



  // (Where two values of xi are the same, so are those of z, and the quotient
  // is a derivative.)
  double
  HosfordCriterion::Relaxation::turning(
    const Tensor<2, 3> &principal_derivative,
    const unsigned int  i,
    const unsigned int  j) const
  {
    constexpr double smallest = 1e-6;

    const double difference = trial[i] - trial[j];
    if (difference <= smallest * (trial[0] - trial[2]))
      return 0.5 * (principal_derivative[i][i] + principal_derivative[j][j]) -
             principal_derivative[i][j];
    const double of_range = i == 1 ? 1. - place : j == 1 ? place : 1.;
    return of_range * range / difference;
  }



  SymmetricTensor<4, 3>
  HosfordCriterion::Relaxation::derivative() const
  {
    const Tensor<2, 3>    values = principal_derivative();
    SymmetricTensor<4, 3> sum;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        {
          const auto of_i = symmetrize(outer_product(axes[i], axes[i]));
          const auto of_j = symmetrize(outer_product(axes[j], axes[j]));
          sum += values[i][j] * outer_product(of_i, of_j);
          if (i < j)
            {
              const auto shear = symmetrize(outer_product(axes[i], axes[j]));
              sum += 2. * turning(values, i, j) * outer_product(shear, shear);
            }
        }
    return sum;
  }
} // namespace ElastoPlastic
