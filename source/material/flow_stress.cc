// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "material/flow_stress.h"

namespace ElastoPlastic
{
  double
  FlowStress::yield_stress(const double increment) const
  {
    const double end = alpha + increment;
    return initial_yield_stress + linear_modulus * end +
           (curve ? curve->value(end) : 0.);
  }



  FlowStress::Value
  FlowStress::at(const double unknown) const
  {
    const double secant =
      increment_of_one *
      (exponent == 1. ? 1. : std::pow(unknown, exponent - 1.));
    const double increment       = secant * unknown;
    const double increment_slope = secant * exponent;
    const auto   flow = rate_law.flow_stress(yield_stress(increment), unknown);
    return {increment,
            flow.stress,
            increment_slope,
            flow.by_yield_stress * yield_slope(increment) * increment_slope +
              flow.by_ratio};
  }



  double
  FlowStress::slope(const double increment) const
  {
    const Value value = at(unknown(increment));
    return value.stress_slope / value.increment_slope;
  }



  // With the power law D y, the second term is D y increment / (n + 1).
  double
  FlowStress::complement(const double increment) const
  {
    const double end = alpha + increment;
    double sum = curve ? curve->value(end) * increment - curve->integral(end) +
                           curve->integral(alpha) :
                         0.;
    if (rate_law.has_ratio() && increment > 0.)
      sum += rate_law.stress * unknown(increment) * increment / (exponent + 1.);
    return sum;
  }



  namespace
  {
    const double sqrt_two_thirds = std::sqrt(2. / 3.);
  }



  FlowResistance::Value
  FlowResistance::at(const double unknown) const
  {
    const FlowStress::Value flow = flow_stress.at(unknown);
    const double            x    = flow.increment / sqrt_two_thirds;

    double elastic_and_kinematic = elastic_modulus * x, slope = elastic_modulus;
    for (const auto &law : back_stresses)
      {
        const double length = law.length(x);
        elastic_and_kinematic += law.modulus * length;
        slope += law.modulus * (1. - law.recovery * length);
      }
    const double multiplier_slope = flow.increment_slope / sqrt_two_thirds;
    return {x,
            elastic_and_kinematic + sqrt_two_thirds * flow.stress,
            multiplier_slope,
            slope * multiplier_slope + sqrt_two_thirds * flow.stress_slope};
  }



  double
  FlowResistance::upper_bound(const double excess) const
  {
    return flow_stress.unknown(sqrt_two_thirds * excess / elastic_modulus);
  }
} // namespace ElastoPlastic
