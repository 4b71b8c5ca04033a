// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_mechanism_dilatancy_h
#define bounds_mechanism_dilatancy_h

#include "bounds/mechanism/velocity_field.h"

namespace ElastoPlastic
{
  // Of velocities in plane strain whose strength depends on the pressure, see
  // SplitBody::friction_sines. With the rate of volume theta and the rate of
  // shear g = |(e_11 - e_22, 2 e_12)|, the plastic work is finite where
  // theta >= sin(phi) g, and then c cot(phi) theta. Both functions look at the
  // coefficients of the strain rate in Bernstein's basis, and use nothing but
  // the velocities.

  /// By how much the rate of volume violates that in a triangle, at most: what
  /// it lacks to sin(phi) g, or its absolute value without friction.
  double
  missing_dilatation(const SplitBody<2>       &body,
                     const SimplexVelocity<2> &velocity,
                     const unsigned int        triangle);

  /// An upper bound of the plastic work in a triangle: exact with friction,
  /// where rates that lack a little dilatation count as if they did not; else
  /// that of int c g dx by the coefficients.
  double
  work_of_soil(const SplitBody<2>       &body,
               const SimplexVelocity<2> &velocity,
               const unsigned int        triangle);
} // namespace ElastoPlastic

#endif
