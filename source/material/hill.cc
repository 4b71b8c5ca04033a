// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include "material/hill.h"

namespace ElastoPlastic
{
  namespace
  {
    /// F, G, H of the ratios of tension.
    std::array<double, 3>
    coefficients_of_tension(const HillRatios &ratios)
    {
      std::array<double, 3> squares;
      for (unsigned int d = 0; d < 3; ++d)
        squares[d] = 1. / (ratios[d] * ratios[d]);
      const double half_sum = 0.5 * (squares[0] + squares[1] + squares[2]);
      return {
        {half_sum - squares[0], half_sum - squares[1], half_sum - squares[2]}};
    }



    SymmetricTensor<2, 3>
    diagonal(const double a, const double b, const double c)
    {
      SymmetricTensor<2, 3> result;
      result[0][0] = a;
      result[1][1] = b;
      result[2][2] = c;
      return result;
    }
  } // namespace



  bool
  HillCriterion::are_convex(const HillRatios &ratios)
  {
    constexpr double margin = 0.01;
    if (std::any_of(ratios.begin(), ratios.end(), [](const double ratio) {
          return !(ratio > 0.);
        }))
      return false;
    std::array<double, 3> sides = {
      {1. / ratios[0], 1. / ratios[1], 1. / ratios[2]}};
    std::sort(sides.begin(), sides.end());
    return sides[0] + sides[1] >= (1. + margin) * sides[2];
  }



  // Without shear, q^2 is a form on the two deviators along (1, -1, 0) and (1,
  // 1, -2), with the matrix (a, c; c, b).
  HillCriterion::HillCriterion(const HillRatios   &ratios,
                               const Tensor<2, 3> &axes)
  {
    const auto [F, G, H] = coefficients_of_tension(ratios);
    const double a       = 0.5 * (F + G + 4. * H);
    const double b       = 1.5 * (F + G);
    const double c       = std::sqrt(0.75) * (G - F);
    const double angle   = 0.5 * std::atan2(2. * c, a - b);
    const double mean = 0.5 * (a + b), deviation = std::hypot(0.5 * (a - b), c);
    weights[0] = mean + deviation;
    weights[1] = (a * b - c * c) / weights[0];

    const auto first  = std::sqrt(0.5) * diagonal(1., -1., 0.);
    const auto second = std::sqrt(1. / 6.) * diagonal(1., 1., -2.);
    eigentensors[0]   = std::cos(angle) * first + std::sin(angle) * second;
    eigentensors[1]   = std::cos(angle) * second - std::sin(angle) * first;
    constexpr std::array<std::array<unsigned int, 2>, 3> shear = {
      {{{0, 1}}, {{0, 2}}, {{1, 2}}}};
    for (unsigned int k = 0; k < 3; ++k)
      {
        weights[2 + k] = 1.5 / (ratios[3 + k] * ratios[3 + k]);
        eigentensors[2 + k][shear[k][0]][shear[k][1]] = std::sqrt(0.5);
      }

    for (Tensor3 &tensor : eigentensors)
      tensor = symmetrize(axes * Tensor<2, 3>(tensor) * transpose(axes));
  }



  bool
  HillCriterion::has_third_axis() const
  {
    constexpr double rounding = 1e-10;
    for (const auto &[i, j] : {std::array<unsigned int, 2>{{0, 2}}, {{1, 2}}})
      {
        SymmetricTensor<2, 3> shear, product;
        shear[i][j] = 1.;
        for (unsigned int k = 0; k < 5; ++k)
          product += (weights[k] * (eigentensors[k] * shear)) * eigentensors[k];
        const double in_plane = product[0][0] * product[0][0] +
                                product[1][1] * product[1][1] +
                                product[0][1] * product[0][1];
        if (in_plane > rounding * rounding * (product * product))
          return false;
      }
    return true;
  }



  HillCriterion::Relaxation::Relaxation(const HillCriterion &criterion,
                                        const Tensor3       &trial)
    : criterion(criterion)
  {
    for (unsigned int k = 0; k < 5; ++k)
      this->trial[k] = criterion.eigentensors[k] * trial;
  }



  double
  HillCriterion::Relaxation::equivalent_stress() const
  {
    double square = 0;
    for (unsigned int k = 0; k < 5; ++k)
      {
        const double p = criterion.weights[k];
        const double z = trial[k] / (1. + ratio * p);
        square += p * z * z;
      }
    return std::sqrt(square);
  }



  SymmetricTensor<2, 3>
  HillCriterion::Relaxation::normal() const
  {
    Tensor3 sum;
    for (unsigned int k = 0; k < 5; ++k)
      {
        const double p = criterion.weights[k];
        sum += (p * trial[k] / (1. + ratio * p)) * criterion.eigentensors[k];
      }
    return sum / equivalent_stress();
  }



  SymmetricTensor<4, 3>
  HillCriterion::Relaxation::derivative() const
  {
    SymmetricTensor<4, 3> sum;
    for (unsigned int k = 0; k < 5; ++k)
      sum +=
        outer_product(criterion.eigentensors[k], criterion.eigentensors[k]) /
        (1. + ratio * criterion.weights[k]);
    return sum;
  }
} // namespace ElastoPlastic
