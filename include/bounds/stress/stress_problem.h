// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_stress_stress_problem_h
#define bounds_stress_stress_problem_h

#include "bounds/body/plane_body.h"
#include "bounds/stress/space_stress.h"
#include "bounds/stress/stress_field.h"

namespace ElastoPlastic
{
  /// The stresses of least complementary energy
  ///   J(tau) = int_Omega W*(tau) dx + int_Gamma_0 g p ds
  /// among all Johnson-Mercier stresses in equilibrium with a given @p force of
  /// the indenter, J (4.1) in @cite johnson_1978: one Hencky step from
  /// the virgin state.
  /// @throws ConvergenceError, in particular beyond the limit load.
  StressField
  equilibrate_with_force(const PlaneBody &body, const double force);
  SpaceStressField
  equilibrate_with_force(const SpaceBody &body, const double force);

  /// The same with a given @p depth of the indenter: the stresses minimise
  /// J - depth times force.
  StressField
  equilibrate_with_depth(const PlaneBody &body, const double depth);
  SpaceStressField
  equilibrate_with_depth(const SpaceBody &body, const double depth);

  /// The stresses with the largest load factor, or if no load grows, with the
  /// largest force of the indenter, that satisfy the yield condition
  /// everywhere. This is a lower bound of the limit load.
  /// @param degree of the stresses, 1 or 2
  /// @throws ConvergenceError, in particular if there is no limit.
  StressField
  maximize_load(const PlaneBody &body, const unsigned int degree);
  SpaceStressField
  maximize_load(const SpaceBody &body,
                const double     tolerance = usual_space_tolerance);
} // namespace ElastoPlastic

#endif
