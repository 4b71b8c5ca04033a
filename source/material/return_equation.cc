// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>
#include <limits>

#include "base/exceptions.h"
#include "material/return_equation.h"

namespace ElastoPlastic
{
  namespace
  {
    constexpr double epsilon = std::numeric_limits<double>::epsilon();

    /// Far more than the bisections and Newton steps that can be needed.
    constexpr unsigned int max_iterations = 10000;
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



  double
  ReturnEquation::solve() const
  {
    Value value = evaluate(0.);
    if (std::isnan(value.excess))
      return value.excess;
    if (value.excess <= 0)
      return 0.;

    double multiplier = 0, lower = 0, upper = value.excess / elastic_modulus;
    for (unsigned int iteration = 0; iteration < max_iterations; ++iteration)
      {
        const double last_excess = value.excess;
        const double newton      = multiplier - value.excess / value.slope;
        const bool   is_inside   = newton > lower && newton < upper;
        multiplier               = is_inside ? newton : 0.5 * (lower + upper);
        value                    = evaluate(multiplier);
        if (is_inside && std::abs(value.excess) > 0.5 * std::abs(last_excess))
          {
            (value.excess > 0 ? lower : upper) = multiplier;
            multiplier                         = 0.5 * (lower + upper);
            value                              = evaluate(multiplier);
          }
        (value.excess > 0 ? lower : upper) = multiplier;
        if (std::abs(value.excess) <= 4. * epsilon * value.norm ||
            upper - lower <= 2. * epsilon * upper)
          return multiplier;
      }
    throw ConvergenceError(
      "The return of a stress to the yield surface has no solution: the back "
      "stresses of a point are larger than the material allows. Is this a "
      "state of the material in 'Material'?");
  }
} // namespace ElastoPlastic
