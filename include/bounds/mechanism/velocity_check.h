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
    /// Times the size of the simplex. Not in plane stress, where the sheet
    /// changes its thickness; with friction, what it lacks, see
    /// missing_dilatation().
    double divergence = 0;
    /// What passes through a face; in plane stress and with friction also what
    /// slides along it.
    double separation  = 0;
    double penetration = 0; ///< into the indenter

    double
    largest() const;
  };



  /// Looks at every simplex and every face of the mesh, using nothing but the
  /// velocities themselves.
  template <int dim>
  VelocityErrors
  check_velocity(const SplitBody<dim>                    &body,
                 const std::vector<SimplexVelocity<dim>> &velocity);

  /// How far the points under the indenter go down, at least, when it moves
  /// down by 1.
  template <int dim>
  double
  lowest_depth(const SplitBody<dim>                    &body,
               const std::vector<SimplexVelocity<dim>> &velocity);

  /// An upper bound, by simplices, of the plastic work int sqrt(2/3) sigma_0
  /// |e(v)| dx and, on faces, int k |[v_t]| ds, see VelocityField::dissipation:
  /// by the coefficients in Bernstein's basis, in the plane on each of sixteen
  /// parts of a triangle and four of a side.
  template <int dim>
  std::vector<double>
  plastic_work(const SplitBody<dim>                    &body,
               const std::vector<SimplexVelocity<dim>> &velocity);

  /// Uses nothing but the velocities and the loads themselves.
  template <int dim>
  LoadPower
  power_of_loads(const SplitBody<dim>                    &body,
                 const std::vector<SimplexVelocity<dim>> &velocity);
} // namespace ElastoPlastic

#endif
