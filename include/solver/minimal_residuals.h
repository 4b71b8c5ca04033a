// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef solver_minimal_residuals_h
#define solver_minimal_residuals_h

#include <deal.II/lac/solver_gmres.h>

#include "solver/krylov_method.h"

namespace ElastoPlastic
{
  /// krylov_method() for any regular matrix: flexible GMRES @cite saad_1993,
  /// restarted after 30 iterations. Flexible, because multigrid solves its
  /// coarsest systems by an iteration too.
  template <typename Matrix, typename Preconditioner>
  unsigned int
  minimal_residuals(const Matrix                                     &matrix,
                    LinearAlgebra::distributed::Vector<double>       &solution,
                    const LinearAlgebra::distributed::Vector<double> &rhs,
                    const Preconditioner &preconditioner,
                    const double          reduction,
                    const unsigned int    maximum_iterations)
  {
    using Solver = SolverFGMRES<LinearAlgebra::distributed::Vector<double>>;
    return krylov_method<Solver>(matrix,
                                 solution,
                                 rhs,
                                 preconditioner,
                                 reduction,
                                 maximum_iterations,
                                 typename Solver::AdditionalData(30));
  }
} // namespace ElastoPlastic

#endif
