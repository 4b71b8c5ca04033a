// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef solver_conjugate_gradients_h
#define solver_conjugate_gradients_h

#include <deal.II/lac/solver_cg.h>

#include "solver/krylov_method.h"

namespace ElastoPlastic
{
  /// krylov_method() for a symmetric positive definite matrix and
  /// preconditioner: conjugate gradients.
  template <typename Matrix, typename Preconditioner>
  unsigned int
  conjugate_gradients(const Matrix                               &matrix,
                      LinearAlgebra::distributed::Vector<double> &solution,
                      const LinearAlgebra::distributed::Vector<double> &rhs,
                      const Preconditioner &preconditioner,
                      const double          reduction,
                      const unsigned int    maximum_iterations)
  {
    using Solver = SolverCG<LinearAlgebra::distributed::Vector<double>>;
    return krylov_method<Solver>(
      matrix, solution, rhs, preconditioner, reduction, maximum_iterations);
  }
} // namespace ElastoPlastic

#endif
