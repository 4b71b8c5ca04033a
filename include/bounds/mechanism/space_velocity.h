// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_mechanism_space_velocity_h
#define bounds_mechanism_space_velocity_h

#include <deal.II/base/symmetric_tensor.h>

#include <vector>

#include "bounds/body/space_body.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// The velocity at the corners of a tetrahedron, between which it is linear.
  using CornerVelocities = std::array<Tensor<1, 3>, 4>;

  /// A mechanism of collapse in space, and the bound of the limit load that it
  /// gives.
  struct SpaceVelocityField
  {
    /// By tetrahedra; the indenter moves down by 1, or 1 is the largest
    /// velocity if other loads grow. Neighbours may slide along each other.
    std::vector<CornerVelocities> velocity;

    /// By tetrahedra: an upper bound of the plastic work in it and on its
    /// faces. Neighbours share that on the face between them.
    std::vector<double> dissipation;

    /// See VelocityField::bound.
    double bound = 0;
    /// See SpaceVelocityErrors::largest().
    double       error        = 0;
    unsigned int n_iterations = 0;
    /// False if rounding errors have ended the minimisation early.
    bool is_optimal = true;
  };

  inline void
  scale(SpaceVelocityField &field, const double factor)
  {
    for (CornerVelocities &velocity : field.velocity)
      for (Tensor<1, 3> &v : velocity)
        v *= factor;
  }



  /// Constant on a tetrahedron.
  SymmetricTensor<2, 3>
  strain_rate(const Tetrahedron &corners, const CornerVelocities &velocity);

  /// At the corners of a face: the velocity of its first neighbour less that of
  /// the second one, or of the indenter, or zero.
  std::array<Tensor<1, 3>, 3>
  velocity_jumps(const SpaceBody                     &body,
                 const std::vector<CornerVelocities> &velocity,
                 const unsigned int                   face);

  /// Whether the neighbours of a face, or the body and what is beside it, pay
  /// for sliding along it.
  bool
  slip_takes_work(const SpaceBody &body, const unsigned int face);



  /// The mechanism that takes least plastic work among velocities that are
  /// linear on each tetrahedron, change no volume, are zero at the supports and
  /// go down by 1 or more everywhere under the indenter. Their normal
  /// components are continuous (the element of Brezzi, Douglas and Marini
  /// @cite nedelec_1986); neighbours may slide along each other, which takes
  /// the work k |[v_t]| per area. So they may along fixed faces and along a
  /// rough indenter.
  ///
  /// Velocities are up to a factor, and almost without divergence. The force is
  /// what has been minimised; work and errors are not yet computed.
  /// @throws ConvergenceError, UnboundedError if there is no mechanism.
  SpaceVelocityField
  find_motion_in_space(const SpaceBody &body, const double tolerance);

  /// That mechanism, with the bound that follows from the velocities alone.
  /// @throws ConvergenceError, in particular if there is no mechanism.
  SpaceVelocityField
  minimize_plastic_work(const SpaceBody &body,
                        const double     tolerance = usual_space_tolerance);



  /// By how much a velocity whose size is 1, see SpaceVelocityField, violates
  /// the conditions of the kinematic theorem: all should be zero but for
  /// rounding.
  struct SpaceVelocityErrors
  {
    double divergence  = 0; ///< times the size of the tetrahedron
    double separation  = 0; ///< what passes through a face
    double penetration = 0; ///< into the indenter

    double
    largest() const;
  };

  /// Looks at every tetrahedron and every face of the mesh, using nothing but
  /// the velocities themselves.
  SpaceVelocityErrors
  check_velocity(const SpaceBody                     &body,
                 const std::vector<CornerVelocities> &velocity);

  /// How far the points under the indenter go down, at least, when it moves
  /// down by 1.
  double
  lowest_depth(const SpaceBody                     &body,
               const std::vector<CornerVelocities> &velocity);

  /// See SpaceVelocityField::dissipation.
  std::vector<double>
  plastic_work(const SpaceBody                     &body,
               const std::vector<CornerVelocities> &velocity);

  /// Uses nothing but the velocities and the loads themselves.
  LoadPower
  power_of_loads(const SpaceBody                     &body,
                 const std::vector<CornerVelocities> &velocity);

  double
  largest_velocity(const SpaceBody                     &body,
                   const std::vector<CornerVelocities> &velocity);
} // namespace ElastoPlastic

#endif
