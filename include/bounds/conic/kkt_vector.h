// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_conic_kkt_vector_h
#define bounds_conic_kkt_vector_h

#include <deal.II/lac/vector.h>

namespace ElastoPlastic
{
  using namespace dealii;

  /// The unknowns of the optimality conditions of a ConicProgram without the
  /// slack variables, or the residuals of these conditions.
  struct KktVector
  {
    Vector<double> x;               ///< see ConicLayout::unknowns
    Vector<double> z;               ///< see ConicLayout::rows
    Vector<double> y;               ///< by equations
    double         load_factor = 0; ///< lambda
  };
} // namespace ElastoPlastic

#endif
