// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_conic_yield_conditions_h
#define bounds_conic_yield_conditions_h

#include <deal.II/lac/full_matrix.h>

#include "bounds/conic/conic_program.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// The components 11, 22, 12, 33 of a stress.
  constexpr unsigned int n_stress_components = 4;



  /// The deviator of a stress, in an orthonormal basis (3 x 4).
  FullMatrix<double>
  deviator_matrix();

  /// Adds the cones |dev tau| <= @p radius to a @p block without any, for
  /// the stresses tau = @p point_stresses x: four components at each of several
  /// points.
  void
  add_yield_conditions(ConicBlock               &block,
                       const FullMatrix<double> &point_stresses,
                       const double              radius);
} // namespace ElastoPlastic

#endif
