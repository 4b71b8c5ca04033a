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
  ReturnEquation::evaluate(const double unknown) const
  {
    const FlowResistance::Value flow = resistance.at(unknown);
    const unsigned int          n    = resistance.back_stresses.size();

    double weight[max_back_stresses + 1]       = {1.};
    double weight_slope[max_back_stresses + 1] = {0.};
    for (unsigned int k = 0; k < n; ++k)
      {
        const auto &law = resistance.back_stresses[k];
        weight[k + 1]   = law.recovery * law.length(flow.multiplier);
        weight_slope[k + 1] =
          law.recovery * (1. - weight[k + 1]) * flow.multiplier_slope;
      }

    double square = 0, half_square_slope = 0;
    for (unsigned int i = 0; i <= n; ++i)
      for (unsigned int j = 0; j <= n; ++j)
        {
          square += weight[i] * weight[j] * products[i][j];
          half_square_slope += weight[i] * weight_slope[j] * products[i][j];
        }
    const double norm = std::sqrt(std::max(square, 1e-200));
    return {norm - flow.resistance,
            half_square_slope / norm - flow.slope,
            norm};
  }



  bool
  ReturnEquation::is_monotone() const
  {
    for (unsigned int k = 0; k < resistance.back_stresses.size(); ++k)
      {
        const auto &[c, g] = resistance.back_stresses[k];
        if (g * g * products[k + 1][k + 1] > (1. + rounding) * c * c)
          return false;
      }
    return true;
  }



  // The step that ends the iteration is so small that its square is rounding.
  double
  ReturnEquation::newton_iteration(const Value &at_zero) const
  {
    constexpr int digits = std::numeric_limits<double>::digits * 3 / 5;
    const double  upper =
      (1. + rounding) * resistance.upper_bound(at_zero.excess);
    std::uintmax_t n_iterations = max_iterations;
    const double   unknown      = boost::math::tools::newton_raphson_iterate(
      [this](const double y) {
        const Value value = evaluate(y);
        return std::make_pair(value.excess, value.slope);
      },
      std::min(upper, -at_zero.excess / at_zero.slope),
      0.,
      upper,
      digits,
      n_iterations);
    return n_iterations < max_iterations ?
             unknown :
             std::numeric_limits<double>::quiet_NaN();
  }



  double
  ReturnEquation::solve() const
  {
    const Value at_zero = evaluate(0.);
    if (!std::isfinite(at_zero.excess))
      return std::numeric_limits<double>::quiet_NaN();
    if (at_zero.excess <= 0 || !resistance.flow_stress.can_flow())
      return 0.;
    const double unknown =
      is_monotone() ?
        newton_iteration(at_zero) :
        positive_root([this](const double y) { return evaluate(y).excess; },
                      at_zero.excess,
                      resistance.upper_bound(at_zero.excess));
    return resistance.at(unknown).multiplier;
  }
} // namespace ElastoPlastic
