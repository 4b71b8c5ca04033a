// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_mechanism_velocity_program_h
#define bounds_mechanism_velocity_program_h

#include "bounds/conic/tolerances.h"
#include "bounds/mechanism/velocity_field.h"

namespace ElastoPlastic
{
  /// The mechanism that takes least plastic work among velocities that are zero
  /// at the supports and go down by 1 or more everywhere under the indenter
  /// (find_stream(), in space find_flux(), or find_continuous_motion()). By the
  /// kinematic theorem, its work int sqrt(2/3) sigma_0 |e(v)| dx is an upper
  /// bound of the limit load @cite hill_1950. The bound follows from the
  /// velocities alone, by velocity_check.h.
  /// @param tolerance of the best bound of the mesh, relative
  /// @param expected_multipliers by simplices, or empty if nothing is known,
  /// see ConicProgram::expect_multipliers()
  /// @throws ConvergenceError, in particular if there is no mechanism.
  template <int dim>
  VelocityField<dim>
  minimize_plastic_work(const SplitBody<dim> &body,
                        const double tolerance = Tolerance::gap_of_bounds<dim>,
                        const std::vector<double> &expected_multipliers = {});



  // The programs of these mechanisms, see velocity_basis.h and field_of()
  // there. All throw a ConvergenceError, and UnboundedError if there is no
  // mechanism.


  /// The mechanism in space, without friction, that takes least plastic work
  /// among velocities that are linear on each tetrahedron and change no volume.
  /// Their normal components are continuous (the element of Brezzi, Douglas and
  /// Marini @cite nedelec_1986); neighbours may slide along each other, which
  /// takes the work k |[v_t]| per area. So they may along fixed faces and along
  /// a rough indenter.
  VelocityField<3>
  find_flux(const SplitBody<3>        &body,
            const double               tolerance,
            const std::vector<double> &expected_multipliers);



  /// The mechanism in plane strain or of a body of revolution, without
  /// friction, that takes least plastic work among those with a stream function
  /// (StreamElement). It is continuous, so nothing passes through the sides of
  /// triangles; but they may slide along each other, which takes the work k
  /// |[v_t]| per area, with the yield stress in shear k of the weaker material.
  /// So they may along fixed sides and along a rough indenter.
  VelocityField<2>
  find_stream(const SplitBody<2>        &body,
              const double               tolerance,
              const std::vector<double> &expected_multipliers);



  /// The mechanism in plane stress, or with friction in any other body, that
  /// takes least plastic work among all continuous_velocities(). The strain
  /// rate is a polynomial on a simplex: so the work is at most that of its
  /// coefficients in Bernstein's basis, because it is a convex function; and
  /// with friction, the rate is in the dual cone of the yield condition
  /// everywhere because its coefficients are.
  template <int dim>
  VelocityField<dim>
  find_continuous_motion(const SplitBody<dim>      &body,
                         const double               tolerance,
                         const std::vector<double> &expected_multipliers);
} // namespace ElastoPlastic

#endif
