// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "material/flow_resistance.h"

namespace ElastoPlastic
{
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
