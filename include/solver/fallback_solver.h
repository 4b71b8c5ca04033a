// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef solver_fallback_solver_h
#define solver_fallback_solver_h

#include <functional>
#include <memory>
#include <string>

#include "base/exceptions.h"
#include "solver/tangent_solver.h"

namespace ElastoPlastic
{
  /// A fast solver, and a slower one that takes over for good, and says so,
  /// when the fast one has failed.
  template <int dim>
  class FallbackSolver : public TangentSolver<dim>
  {
  public:
    /// @p fast_solver has failed if it throws a ConvergenceError or needs
    /// @p maximum_iterations. Then @p warn gets a sentence for the user, and
    /// @p make_fallback is called.
    FallbackSolver(
      std::unique_ptr<TangentSolver<dim>> fast_solver,
      const unsigned int                  maximum_iterations,
      const std::function<std::unique_ptr<TangentSolver<dim>>()> &make_fallback,
      const std::function<void(const std::string &)>             &warn)
      : solver(std::move(fast_solver))
      , maximum_iterations(maximum_iterations)
      , make_fallback(make_fallback)
      , warn(warn)
    {}

    void
    prepare(const SolidOperator<dim> &new_solid,
            const VectorType         &new_held) override
    {
      solid = &new_solid;
      held  = new_held;
      solver->prepare(*solid, held);
    }

    unsigned int
    solve(VectorType       &solution,
          const VectorType &rhs,
          const double      reduction) override
    {
      if (has_fallen_back)
        return solver->solve(solution, rhs, reduction);
      try
        {
          const unsigned int n_iterations =
            solver->solve(solution, rhs, reduction);
          if (n_iterations < maximum_iterations)
            return n_iterations;
        }
      catch (const ConvergenceError &)
        {}

      warn(
        "Geometric multigrid does not converge here: algebraic multigrid "
        "takes over on this mesh.");
      solver          = make_fallback();
      has_fallen_back = true;
      solver->prepare(*solid, held);
      return solver->solve(solution, rhs, reduction);
    }

  private:
    std::unique_ptr<TangentSolver<dim>> solver;
    const unsigned int                  maximum_iterations;
    const std::function<std::unique_ptr<TangentSolver<dim>>()> make_fallback;
    const std::function<void(const std::string &)>             warn;

    bool                      has_fallen_back = false;
    const SolidOperator<dim> *solid           = nullptr;
    VectorType                held;
  };
} // namespace ElastoPlastic

#endif
