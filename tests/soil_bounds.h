// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tests_soil_bounds_h
#define tests_soil_bounds_h

#include <algorithm>
#include <cmath>
#include <numeric>

#include "bounds/limit_load.h"
#include "bounds/mechanism/velocity_check.h"
#include "bounds/stress/stress_check.h"
#include "material/yield_criterion_parameters.h"
#include "verdict.h"

// Bounds of limit loads of material that obeys Drucker and Prager's yield
// condition, looked at.

namespace SoilBounds
{
  using namespace ElastoPlastic;

  /// With the cohesion 1.
  inline SoilStrength
  strength(const double degrees)
  {
    SoilParameters parameters;
    parameters.cohesions       = {1.};
    parameters.friction_angles = {degrees};
    return parameters.drucker_prager(0);
  }



  /// Verifies that stress and velocity are admissible, and that the gaps of the
  /// simplices are not negative and add up to the difference of the bounds,
  /// which are those of stresses of this @p degree.
  template <int dim>
  LimitLoad<dim>
  checked_bounds(const SplitBody<dim> &body, const unsigned int degree)
  {
    const auto bounds = bound_limit_load(body, degree);
    verify("admissible stress",
           check_stress(body, bounds.stress).largest(),
           1e-9);
    verify("admissible velocity", bounds.velocity.error, 1e-12);
    const double power =
      body.load_factor_unit > 0 ?
        power_of_loads(body, bounds.velocity.velocity).growing :
        1.;
    verify("gaps",
           std::all_of(bounds.gaps.begin(),
                       bounds.gaps.end(),
                       [](const double gap) { return gap > -1e-6; }));
    verify("sum of the gaps",
           std::abs(
             std::accumulate(bounds.gaps.begin(), bounds.gaps.end(), 0.) /
               power -
             (bounds.upper_bound - bounds.lower_bound)),
           1e-5 * bounds.upper_bound);
    return bounds;
  }
} // namespace SoilBounds

#endif
