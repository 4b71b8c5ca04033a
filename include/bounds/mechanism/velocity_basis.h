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
} // namespace ElastoPlastic

#endif
