// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef equilibrium_velocity_program_h
#define equilibrium_velocity_program_h

#include "equilibrium/velocity_field.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// The mechanism that takes least plastic work among all continuous piecewise
  /// quadratic velocities v that are zero at the supports, go down by 1 or
  /// more everywhere under the indenter, and, in plane strain, have no
  /// divergence. By the kinematic theorem, its work int sqrt(2/3) sigma_0
  /// |e(v)| dx is an upper bound of the limit load @cite hill_1950.
  ///
  /// The strain rate is linear on a triangle. So there is no divergence if
  /// there is none at its corners, and the work is at most a third of the area
  /// times the sum of that at the corners, because it is a convex function.
  /// Unlike linear ones, such velocities do not lock.
  /// @throws ConvergenceError, in particular if there is no mechanism.
  VelocityField
  minimize_plastic_work(const PlaneBody &body);
} // namespace ElastoPlastic

#endif
