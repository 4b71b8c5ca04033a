// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_mechanism_velocity_check_h
#define bounds_mechanism_velocity_check_h

#include <algorithm>

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
    /// slides along it. At supports, what is more than the faces may be tilted
    /// by, Tolerance::small_angle.
    double separation  = 0;
    double penetration = 0; ///< into the indenter

    double
    largest() const
    {
      return std::max({divergence, separation, penetration});
    }
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
  TwoLoads
  power_of_loads(const SplitBody<dim>                    &body,
                 const std::vector<SimplexVelocity<dim>> &velocity);



  // Of velocities of bodies whose strength depends on the pressure, see
  // SplitBody::friction_slopes. With the rate of volume theta, the rate of
  // shear g, which is sqrt(2) |dev e|, in plane strain |(e_11 - e_22, 2 e_12)|,
  // and the slope f, the plastic work is finite where theta >= f g, and then R
  // theta / (sqrt(2) f), which is c cot(phi) theta. Both functions look at the
  // coefficients of the strain rate in Bernstein's basis. They use nothing but
  // the velocities at points, of which they take differences: programs have
  // derivatives of their functions, see strain_rate_at().

  /// By how much the rate of volume violates that in a simplex, at most, times
  /// the size of the simplex: what it lacks to f g, or its absolute value
  /// without friction. Or, in a body of revolution, by how much v_r / r is not
  /// a quadratic polynomial, times that size, so that the rates would be none;
  /// or v_r on the axis.
  template <int dim>
  double
  missing_dilatation(const SplitBody<dim>       &body,
                     const SimplexVelocity<dim> &velocity,
                     const unsigned int          simplex);

  /// An upper bound of the plastic work in a simplex: exact with friction,
  /// where rates that lack a little dilatation count as if they did not; else
  /// that of int R g / sqrt(2) dx by the coefficients.
  template <int dim>
  double
  work_of_soil(const SplitBody<dim>       &body,
               const SimplexVelocity<dim> &velocity,
               const unsigned int          simplex);
} // namespace ElastoPlastic

#endif
