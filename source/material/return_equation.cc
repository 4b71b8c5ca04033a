// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <boost/math/tools/roots.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "material/positive_root.h"
#include "material/return_equation.h"

namespace ElastoPlastic
{
  namespace
  {
    constexpr double rounding = 1e-12;

    /// Far more than the bisections and Newton steps that can be needed.
    constexpr std::uintmax_t max_iterations = 1000;
  } // namespace



  ReturnEquation::Value
  ReturnEquation::evaluate(const double multiplier) const
  {
    double weight[max_back_stresses + 1]       = {1.};
    double weight_slope[max_back_stresses + 1] = {0.};
    double kinematic = 0, kinematic_slope = 0;
    for (unsigned int k = 0; k < back_stresses.size(); ++k)
      {
        const auto &[c, g]  = back_stresses[k];
        const double theta  = 1. / (1. + g * multiplier);
        weight[k + 1]       = g * multiplier * theta;
        weight_slope[k + 1] = g * theta * theta;
        kinematic += theta * c;
        kinematic_slope += theta * theta * c;
      }

    double square = 0, half_square_slope = 0;
    for (unsigned int i = 0; i <= back_stresses.size(); ++i)
      for (unsigned int j = 0; j <= back_stresses.size(); ++j)
        {
          square += weight[i] * weight[j] * products[i][j];
          half_square_slope += weight[i] * weight_slope[j] * products[i][j];
        }
    const double norm = std::sqrt(std::max(square, 1e-200));

    const double ratio = std::sqrt(2. / 3.);
    const double alpha = equivalent_plastic_strain + ratio * multiplier;
    return {norm - multiplier * (elastic_modulus + kinematic) - radius -
              isotropic_modulus * multiplier -
              (curve ? ratio * curve->value(alpha) : 0.),
            half_square_slope / norm - elastic_modulus - kinematic_slope -
              isotropic_modulus - (curve ? 2. / 3. * curve->slope(alpha) : 0.),
            norm};
  }



  bool
  ReturnEquation::is_monotone() const
  {
    for (unsigned int k = 0; k < back_stresses.size(); ++k)
      {
        const auto &[c, g] = back_stresses[k];
        if (g * g * products[k + 1][k + 1] > (1. + rounding) * c * c)
          return false;
      }
    return true;
  }



  // The step that ends the iteration is so small that its square is rounding.
  double
  ReturnEquation::newton_iteration(const Value &at_zero) const
  {
    constexpr int  digits       = std::numeric_limits<double>::digits * 3 / 5;
    std::uintmax_t n_iterations = max_iterations;
    const double   multiplier   = boost::math::tools::newton_raphson_iterate(
      [this](const double x) {
        const Value value = evaluate(x);
        return std::make_pair(value.excess, value.slope);
      },
      -at_zero.excess / at_zero.slope,
      0.,
      (1. + rounding) * at_zero.excess / elastic_modulus,
      digits,
      n_iterations);
    return n_iterations < max_iterations ?
             multiplier :
             std::numeric_limits<double>::quiet_NaN();
  }



  double
  ReturnEquation::solve() const
  {
    const Value at_zero = evaluate(0.);
    if (!std::isfinite(at_zero.excess))
      return std::numeric_limits<double>::quiet_NaN();
    if (at_zero.excess <= 0)
      return 0.;
    if (is_monotone())
      return newton_iteration(at_zero);
    return positive_root([this](const double x) { return evaluate(x).excess; },
                         at_zero.excess,
                         at_zero.excess / elastic_modulus);
  }
} // namespace ElastoPlastic
