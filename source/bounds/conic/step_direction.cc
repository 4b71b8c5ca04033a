// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <limits>
#include <utility>

#include "bounds/conic/step_direction.h"

namespace ElastoPlastic
{
  namespace
  {
    /// By so much a step is to become longer.
    constexpr double lengthening = 0.3;

    /// The interval of eigenvalues, relative to the target.
    constexpr double smallest = 0.1;
    constexpr double largest  = 10.;



    /// Large eigenvalues are brought down by a limited amount.
    double
    correction(const double eigenvalue, const double target)
    {
      return std::max(std::clamp(eigenvalue,
                                 smallest * target,
                                 largest * target) -
                        eigenvalue,
                      -largest * target);
    }



    /// The vector with the same directions as @p v, and the corrections of its
    /// eigenvalues v_0 + |v_1| and v_0 - |v_1| as its own.
    void
    correct(const SecondOrderCone::View v, const double target)
    {
      const double tail  = SecondOrderCone::norm_of_tail(v);
      const double upper = correction(v[0] + tail, target),
                   lower = correction(v[0] - tail, target);
      v[0]               = 0.5 * (upper + lower);
      for (unsigned int i = 1; i < v.size(); ++i)
        v[i] *= tail > 0 ? 0.5 * (upper - lower) / tail : 0.;
    }
  } // namespace



  double
  largest_step(const ConicLayout    &layout,
               const Vector<double> &scaled,
               const StepDirection  &direction)
  {
    double inverse = std::numeric_limits<double>::min();
    for (const auto *const change : {&direction.scaled_s, &direction.scaled_z})
      for (unsigned int c = 0; c < layout.cones.size(); ++c)
        inverse =
          std::max(inverse,
                   SecondOrderCone::inverse_step(layout.cone(scaled, c),
                                                 layout.cone(*change, c)));
    return 1. / inverse;
  }



  Vector<double>
  centrality_correction(const ConicLayout    &layout,
                        const Vector<double> &scaled,
                        const StepDirection  &direction,
                        const double          length,
                        const Vector<double> &targets)
  {
    const double   longer = std::min(1., length + lengthening);
    Vector<double> result = scaled, scaled_z = scaled;
    result.add(longer, direction.scaled_s);
    scaled_z.add(longer, direction.scaled_z);
    for (unsigned int c = 0; c < layout.cones.size(); ++c)
      {
        const auto product = layout.cone(result, c);
        SecondOrderCone::multiply(product,
                                  product,
                                  layout.cone(std::as_const(scaled_z), c));
        correct(product, targets[c]);
      }
    return result;
  }
} // namespace ElastoPlastic
