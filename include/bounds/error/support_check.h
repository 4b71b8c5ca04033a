// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_error_support_check_h
#define bounds_error_support_check_h

#include "bounds/body/split_body.h"
#include "bounds/mechanism/quadratic_field.h"

// Whether displacements are admissible at the supports, without which they
// bound no energy, and whether there can be stresses in equilibrium with the
// tractions.

namespace ElastoPlastic
{
  /// That there can be an admissible displacement in QuadraticField: those that
  /// are prescribed are quadratic on each side. @throws InputError
  void
  require_quadratic_supports(const SplitBody<2> &body);

  /// That there can be stresses of the @p degree in equilibrium with the
  /// tractions: on each side, those are such polynomials, in a body of
  /// revolution when multiplied by r. @throws InputError
  void
  require_polynomial_tractions(const SplitBody<2> &body,
                               const unsigned int  degree);

  /// That @p displacement is what the supports prescribe. Where they are
  /// curved, the nodes of the displacement method move along the tangents of
  /// the curve, not along the faces. @throws ConvergenceError
  template <int dim>
  void
  require_supported(const SplitBody<dim>      &body,
                    const QuadraticField<dim> &displacement);
} // namespace ElastoPlastic

#endif
