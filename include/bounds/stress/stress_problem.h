// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_stress_stress_problem_h
#define bounds_stress_stress_problem_h

#include "bounds/body/evaluated_bounds.h"
#include "bounds/stress/stress_field.h"

namespace ElastoPlastic
{
  /// The stresses of least complementary energy
  ///   J(tau) = int_Omega W*(tau) dx + int_Gamma_0 g p ds
  /// among all Johnson-Mercier stresses in equilibrium with a given @p force of
  /// the indenter, J (4.1) in @cite johnson_1978: one Hencky step from
  /// the virgin state.
  /// @throws ConvergenceError, in particular beyond the limit load.
  template <int dim>
  StressField<dim>
  equilibrate_with_force(const SplitBody<dim> &body, const double force);

  /// The same with a given @p depth of the indenter: the stresses minimise
  /// J - depth times force.
  template <int dim>
  StressField<dim>
  equilibrate_with_depth(const SplitBody<dim> &body, const double depth);

  /// The stresses with the largest load factor, or if no load grows, with the
  /// largest force of the indenter, that satisfy the yield condition
  /// everywhere. This is a lower bound of the limit load. In plane strain, the
  /// strength may depend on the pressure, see SplitBody::friction_sines.
  /// @param degree of the stresses, 1 or 2; in space 1
  /// @throws ConvergenceError, in particular if there is no limit.
  template <int dim>
  StressField<dim>
  maximize_load(const SplitBody<dim> &body,
                const unsigned int    degree,
                const double          tolerance = usual_tolerance<dim>);
} // namespace ElastoPlastic

#endif
