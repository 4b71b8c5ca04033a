// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef solver_krylov_methods_h
#define solver_krylov_methods_h

#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/solver_gmres.h>
#include <deal.II/lac/vector_memory.h>

#include <type_traits>
#include <utility>

#include "base/exceptions.h"

namespace ElastoPlastic
{
  using namespace dealii;

  [[noreturn]] inline void
  throw_singular()
  {
    throw ConvergenceError(
      "The linear solver has produced values that are not finite: the "
      "system is singular. Is the body supported against all rigid body "
      "motions, and is the load below the limit load?");
  }



  /// What a linear solver owes its caller.
  /// @throws ConvergenceError if @p norm is not finite.
  inline void
  check_finite(const double norm)
  {
    if (!std::isfinite(norm))
      throw_singular();
  }



  /// Solves matrix * solution = rhs by deal.II's Krylov method @p Solver, with
  /// a preconditioner, from zero, until the residual has fallen by the factor
  /// @p reduction or the iterations are used up. @return the number of
  /// iterations.
  /// @throws ConvergenceError if the result is not finite.
  template <typename Solver, typename Matrix, typename Preconditioner>
  unsigned int
  krylov_method(const Matrix                          &matrix,
                typename Solver::vector_type          &solution,
                const typename Solver::vector_type    &rhs,
                const Preconditioner                  &preconditioner,
                const double                           reduction,
                const unsigned int                     maximum_iterations,
                const typename Solver::AdditionalData &settings =
                  typename Solver::AdditionalData())
  {
    IterationNumberControl control(maximum_iterations,
                                   reduction * rhs.l2_norm());
    // (deal.II's default keeps the vectors for the next solve.)
    PrimitiveVectorMemory<typename Solver::vector_type> memory;
    solution = 0.;
    try
      {
        Solver(control, memory, settings)
          .solve(matrix, solution, rhs, preconditioner);
      }
    catch (const SolverControl::NoConvergence &failure)
      {
        check_finite(failure.last_residual);
        throw;
      }
    check_finite(solution.l2_norm());
    return control.last_step();
  }



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



  template <typename Settings, typename = void>
  constexpr bool offers_orthogonalizations = false;

  template <typename Settings>
  constexpr bool offers_orthogonalizations<
    Settings,
    std::void_t<
      decltype(std::declval<Settings>().orthogonalization_strategy)>> = true;

  /// Makes each basis vector orthogonal to the others before the preconditioner
  /// takes it. The default of newer versions of deal.II does so afterwards,
  /// when the preconditioned vector, of which flexible GMRES makes the
  /// solution, no longer changes: the residual is then not the one that it
  /// reports.
  template <typename Settings>
  void
  orthogonalize_at_once(Settings &settings)
  {
    if constexpr (offers_orthogonalizations<Settings>)
      {
        using Strategy = decltype(settings.orthogonalization_strategy);
        settings.orthogonalization_strategy = Strategy::modified_gram_schmidt;
      }
  }



  /// krylov_method() for any regular matrix: flexible GMRES @cite saad_1993,
  /// restarted after @p n_basis_vectors iterations, for each of which it keeps
  /// two vectors. Flexible, because multigrid solves its
  /// coarsest systems by an iteration too.
  template <typename Matrix, typename Vector, typename Preconditioner>
  unsigned int
  flexible_gmres(const Matrix         &matrix,
                 Vector               &solution,
                 const Vector         &rhs,
                 const Preconditioner &preconditioner,
                 const double          reduction,
                 const unsigned int    maximum_iterations,
                 const unsigned int    n_basis_vectors = 30)
  {
    using Solver = SolverFGMRES<Vector>;
    typename Solver::AdditionalData settings(n_basis_vectors);
    orthogonalize_at_once(settings);
    return krylov_method<Solver>(matrix,
                                 solution,
                                 rhs,
                                 preconditioner,
                                 reduction,
                                 maximum_iterations,
                                 settings);
  }
} // namespace ElastoPlastic

#endif
