// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_error_support_check_h
#define bounds_error_support_check_h

#include "bounds/body/plane_body.h"
#include "bounds/body/space_body.h"
#include "bounds/mechanism/quadratic_field.h"
#include "bounds/mechanism/space_quadratic_field.h"

// Whether displacements are admissible at the supports, without which they
// bound no energy, and whether there can be stresses in equilibrium with the
// tractions.

namespace ElastoPlastic
{
  /// That there can be an admissible displacement in QuadraticField: those that
  /// are prescribed are quadratic on each side. @throws InputError
  void
  require_quadratic_supports(const PlaneBody &body);

  /// That there can be stresses of the @p degree in equilibrium with the
  /// tractions: on each side, those are such polynomials, in a body of
  /// revolution when multiplied by r. @throws InputError
  void
  require_polynomial_tractions(const PlaneBody   &body,
                               const unsigned int degree);

  /// That @p displacement is what the supports prescribe. Where they are
  /// curved, the nodes of the displacement method move along the tangents of
  /// the curve, not along the sides. @throws ConvergenceError
  void
  require_supported(const PlaneBody &body, const QuadraticField &displacement);

  /// The same in space, on faces, which are flat.
  void
  require_supported(const SpaceBody           &body,
                    const SpaceQuadraticField &displacement);
} // namespace ElastoPlastic

#endif
