// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_mechanism_velocity_check_h
#define bounds_mechanism_velocity_check_h

#include "bounds/mechanism/velocity_field.h"

namespace ElastoPlastic
{
  /// By how much a velocity whose size is 1, see VelocityField, violates the
  /// conditions of the kinematic theorem: all should be zero but for rounding.
  struct VelocityErrors
  {
    /// Times the size of the triangle. Not in plane stress, where the sheet
    /// changes its thickness.
    double divergence = 0;
    /// What passes through a side; in plane stress also what slides along it.
    double separation  = 0;
    double penetration = 0; ///< into the indenter

    double
    largest() const;
  };



  /// Looks at every triangle and every side of the mesh, using nothing but the
  /// velocities themselves.
  VelocityErrors
  check_velocity(const PlaneBody                     &body,
                 const std::vector<TriangleVelocity> &velocity);

  /// How far the points under the indenter go down, at least, when it moves
  /// down by 1.
  double
  lowest_depth(const PlaneBody                     &body,
               const std::vector<TriangleVelocity> &velocity);

  /// An upper bound, by triangles, of the plastic work int sqrt(2/3) sigma_0
  /// |e(v)| dx and, on sides, int k |[v_t]| ds, see VelocityField::dissipation:
  /// by the coefficients in Bernstein's basis on each of sixteen parts of a
  /// triangle and four of a side.
  std::vector<double>
  plastic_work(const PlaneBody                     &body,
               const std::vector<TriangleVelocity> &velocity);
} // namespace ElastoPlastic

#endif
