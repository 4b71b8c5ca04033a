// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Factorisations solve what all ranks have assembled together, with another
// matrix of the same pattern, too, be it unsymmetric; they refuse a singular
// matrix and one that is not finite. Algebraic multigrid is there, or is
// refused. All this with Trilinos' solvers and without.

#include "base/exceptions.h"
#include "solver/krylov_methods.h"
#include "solver/solver_parameters.h"
#include "solver/system_matrix.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  using Vector = MatrixPreconditioner::Vector;

  /// A chain of springs, each of which pulls at its second end more than at
  /// the first by a factor, on a ground of springs.
  class Chain
  {
  public:
    explicit Chain(const types::global_dof_index n)
      : n(n)
      , owned(
          Utilities::MPI::create_evenly_distributed_partitioning(MPI_COMM_WORLD,
                                                                 n))
    {
      // The last spring of a rank pulls at the next one's first unknown.
      IndexSet writable = owned;
      for (const auto i : owned)
        writable.add_index(std::min(i + 1, n - 1));
      SystemPattern pattern = make_pattern(owned, writable, MPI_COMM_WORLD);
      for (const auto i : owned)
        for (const auto row : {i, std::min(i + 1, n - 1)})
          for (const auto column : {i, std::min(i + 1, n - 1)})
            pattern.add(row, column);
      pattern.compress();
      matrix.reinit(pattern);
    }

    void
    assemble(const double stiffness, const double ground, const double factor)
    {
      matrix = 0.;
      for (const auto i : owned)
        {
          matrix.add(i, i, ground);
          if (i + 1 < n)
            {
              matrix.add(i, i, stiffness);
              matrix.add(i, i + 1, -stiffness);
              matrix.add(i + 1, i + 1, factor * stiffness);
              matrix.add(i + 1, i, -factor * stiffness);
            }
        }
      matrix.compress(VectorOperation::add);
    }

    /// How far the solution is from u_i = (-1)^i, for which each spring of the
    /// chain is stretched by 2.
    double
    error(MatrixPreconditioner &factorization,
          const double          stiffness,
          const double          ground,
          const double          factor) const
    {
      Vector exact(owned, MPI_COMM_WORLD), forces = exact, solution = exact;
      for (const auto i : owned)
        {
          exact(i)  = i % 2 == 0 ? 1. : -1.;
          forces(i) = exact(i) * (ground + (i + 1 < n ? 2 * stiffness : 0.) +
                                  (i > 0 ? 2 * factor * stiffness : 0.));
        }
      factorization.vmult(solution, forces);
      solution -= exact;
      return solution.linfty_norm();
    }

    const types::global_dof_index n;
    const IndexSet                owned;
    SystemMatrix                  matrix;
  };



  void
  test_solutions(const types::global_dof_index n)
  {
    output() << n << " unknowns" << std::endl;
    Chain      chain(n);
    const auto factorization = make_factorization(MPI_COMM_WORLD);
    for (const double factor : {1., 3.})
      {
        chain.assemble(2., 0.5, factor);
        factorization->initialize(chain.matrix, 1);
        verify("  the solution is that of the springs of all ranks",
               chain.error(*factorization, 2., 0.5, factor),
               1e-12);
      }
  }



  /// Whether a chain is found to have no solution. (Without a ground, a uniform
  /// motion stretches nothing.)
  bool
  is_refused(const types::global_dof_index n,
             const double                  stiffness,
             const double                  ground)
  {
    Chain chain(n);
    chain.assemble(stiffness, ground, 1.);
    const auto factorization = make_factorization(MPI_COMM_WORLD);
    Vector     rhs(chain.owned, MPI_COMM_WORLD), solution = rhs;
    rhs = 1.;
    try
      {
        factorization->initialize(chain.matrix, 1);
        factorization->vmult(solution, rhs);
        check_finite(solution.l2_norm());
      }
    catch (const ConvergenceError &)
      {
        return true;
      }
    return false;
  }



  bool
  algebraic_multigrid_is_refused()
  {
    LinearSolverParameters parameters;
    parameters.type = Preconditioner::amg;
    try
      {
        parameters.check();
      }
    catch (const InputError &)
      {
        return true;
      }
    return false;
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  // (Of two sizes, for which other libraries may be chosen.)
  for (const types::global_dof_index n : {100, 6000})
    {
      test_solutions(n);
      verify("  unknowns without stiffness are refused", is_refused(n, 0., 0.));
      // (beyond the largest number, when it is assembled)
      verify("  a matrix that is not finite is refused",
             is_refused(n, 1.5e308, 1.));
    }
  verify("algebraic multigrid is refused where it is missing",
         algebraic_multigrid_is_refused() == !has_algebraic_multigrid);
}
