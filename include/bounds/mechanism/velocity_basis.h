// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_mechanism_velocity_basis_h
#define bounds_mechanism_velocity_basis_h

#include <vector>

#include "bounds/conic/conic_program.h"
#include "bounds/mechanism/velocity_field.h"

// What the programs that look for a mechanism have in common: the functions
// that velocities are combined of, the power of loads, what happens on faces,
// and the mechanism that a solution stands for.

namespace ElastoPlastic
{
  /// One of the functions that velocities are combined of, on a simplex.
  template <int dim>
  struct VelocityFunction
  {
    unsigned int         number; ///< among those of the whole body
    SimplexVelocity<dim> velocity;
  };

  template <int dim>
  using VelocityFunctions = std::vector<VelocityFunction<dim>>;

  /// How many there are, and by simplices those that do not vanish there.
  template <int dim>
  struct VelocityBasis
  {
    unsigned int                        size = 0;
    std::vector<VelocityFunctions<dim>> on_simplices;
  };



  /// A program without blocks. Its equations belong to the functions, and say
  /// that the power of all forces vanishes in each; so far, these are tractions
  /// and body forces, some of which may grow. The multipliers of the equations
  /// are the factors of the functions with the opposite sign.
  template <int dim>
  ConicProgram
  program_of_loads(const SplitBody<dim> &body, const VelocityBasis<dim> &basis);

  /// Lets the indenter press, and faces along which velocities slide resist,
  /// with the yield stress in shear of the weaker neighbour. Normal velocities
  /// must be continuous. Of the weighted velocities, which are polynomials of
  /// this @p degree on faces, all coefficients in Bernstein's basis pay for how
  /// they slide, and go down with the indenter.
  template <int dim>
  void
  add_faces(ConicProgram             &program,
            const SplitBody<dim>     &body,
            const VelocityBasis<dim> &basis,
            const unsigned int        degree);

  /// The mechanism that a @p solution stands for, up to a factor. Its bound is
  /// what has been minimised; work and errors are not computed.
  template <int dim>
  VelocityField<dim>
  field_of(const SplitBody<dim>     &body,
           const VelocityBasis<dim> &basis,
           const ConicSolution      &solution);



  /// The directions in which continuous velocities are free at the vertices of
  /// the mesh, and after these in the middles of its edges: unit vectors at
  /// right angles to each other. The velocity is zero in others, where
  /// SplitBody::support_of() asks for it: across closed faces, and along those
  /// that resist a slip, also of a rough indenter where it reaches. Normals
  /// that differ by Tolerance::small_angle or less hold in one direction, that
  /// of the first.
  template <int dim>
  std::vector<std::vector<Tensor<1, dim>>>
  free_directions_of_nodes(const SplitBody<dim> &body);



  /// Continuous velocities that may change the volume. They are zero at
  /// supports, see free_directions_of_nodes().
  ///
  /// In the plane and in space, they are quadratic on each simplex, and the
  /// strain rate is linear. In a body of revolution, v_r = (r / L) w with a
  /// quadratic w and the length unit L, and v_z is cubic. So the rates e_rr =
  /// (w + r d_r w) / L, e_tt = w / L, e_zz = d_z v_z and 2 e_rz = r d_z w / L +
  /// d_r v_z are quadratic polynomials, and those without a change of volume,
  /// v_r = -r d_z chi and v_z = 2 chi + r d_r chi with a cubic chi, are among
  /// them: so they are not lost as the angle of friction tends to zero.
  template <int dim>
  VelocityBasis<dim>
  continuous_velocities(const SplitBody<dim> &body);

  /// Those of a body of revolution.
  VelocityBasis<2>
  revolution_velocities(const SplitBody<2> &body);
} // namespace ElastoPlastic

#endif
