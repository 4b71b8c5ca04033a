// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef solver_linear_solver_h
#define solver_linear_solver_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <memory>
#include <string>
#include <vector>

namespace ElastoPlastic
{
  using namespace dealii;

  /// The entries of the section "Linear solver".
  struct LinearSolverParameters
  {
    std::string  type               = "multigrid";
    unsigned int maximum_iterations = 1000;

    void
    add_parameters(ParameterHandler &prm);
  };



  /// Solves systems with an assembled, symmetric positive definite matrix.
  class LinearSolver
  {
  public:
    using Vector = LinearAlgebra::distributed::Vector<double>;

    virtual ~LinearSolver() = default;

    /// Prepares for solving with @p matrix, which must outlive the solves.
    virtual void
    initialize(const TrilinosWrappers::SparseMatrix &matrix) = 0;

    /// Solves until the residual has fallen by the factor @p reduction.
    /// @return the number of iterations. If they are used up before, the last
    /// iterate is the answer: what CG has found by then is still a direction
    /// of descent for the energy.
    /// @throws ConvergenceError if the result is not finite.
    virtual unsigned int
    solve(Vector &solution, const Vector &rhs, const double reduction) = 0;
  };



  /// The solver for matrices that @p parameters ask for, of type AMG or direct.
  /// @p near_null_space holds the rigid
  /// body motions of the body, which algebraic multigrid must represent on its
  /// coarse levels.
  std::unique_ptr<LinearSolver>
  make_linear_solver(const LinearSolverParameters            &parameters,
                     const std::vector<LinearSolver::Vector> &near_null_space);
} // namespace ElastoPlastic

#endif
