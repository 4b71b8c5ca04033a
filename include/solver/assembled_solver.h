// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef solver_assembled_solver_h
#define solver_assembled_solver_h

#include <memory>

#include "mechanics/tangent_matrix.h"
#include "solver/linear_solver.h"
#include "solver/tangent_solver.h"

namespace ElastoPlastic
{
  /// Assembles the tangent for a LinearSolver.
  template <int dim>
  class AssembledSolver : public TangentSolver<dim>
  {
  public:
    /// @p dof_handler and @p constraints must outlive this object.
    AssembledSolver(std::unique_ptr<LinearSolver>    linear_solver,
                    const DoFHandler<dim>           &dof_handler,
                    const AffineConstraints<double> &constraints)
      : linear_solver(std::move(linear_solver))
    {
      matrix.reinit(dof_handler, constraints);
    }

    void
    prepare(const SolidOperator<dim> &solid, const VectorType &held) override
    {
      matrix.assemble(solid, held);
      linear_solver->initialize(matrix.matrix());
    }

    unsigned int
    solve(VectorType       &solution,
          const VectorType &rhs,
          const double      reduction) override
    {
      return linear_solver->solve(solution, rhs, reduction);
    }

  private:
    const std::unique_ptr<LinearSolver> linear_solver;
    TangentMatrix<dim>                  matrix;
  };
} // namespace ElastoPlastic

#endif
