// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_solver.h>

#include <Epetra_MultiVector.h>
#include <Teuchos_ParameterList.hpp>

#include "solver/conjugate_gradients.h"
#include "solver/linear_solver.h"

namespace ElastoPlastic
{
  void
  LinearSolverParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Linear solver");
    prm.add_parameter(
      "Type",
      type,
      "multigrid: conjugate gradients without a matrix, preconditioned with "
      "geometric multigrid. AMG: conjugate gradients with an assembled matrix, "
      "preconditioned with algebraic multigrid that knows the rigid body "
      "motions. direct: a sparse factorisation, for small problems.",
      Patterns::Selection("multigrid|AMG|direct"));
    prm.add_parameter("Maximum number of iterations",
                      maximum_iterations,
                      "The conjugate gradient steps allowed per linear system. "
                      "When they are used up, Newton's method goes on with "
                      "what has been found.",
                      Patterns::Integer(1));
    prm.leave_subsection();
  }



  namespace
  {
    using Vector = LinearSolver::Vector;

    /// CG with Trilinos ML, smoothed aggregation.
    class AmgSolver : public LinearSolver
    {
    public:
      AmgSolver(const unsigned int         maximum_iterations,
                const std::vector<Vector> &near_null_space)
        : maximum_iterations(maximum_iterations)
        , near_null_space(near_null_space)
      {}

      void
      initialize(const TrilinosWrappers::SparseMatrix &new_matrix) override
      {
        matrix = &new_matrix;

        TrilinosWrappers::PreconditionAMG::AdditionalData data;
        data.elliptic              = true;
        data.higher_order_elements = false;
        data.smoother_sweeps       = 2;
        data.aggregation_threshold = 0.02;

        Teuchos::ParameterList              list;
        std::unique_ptr<Epetra_MultiVector> no_constant_modes;
        data.set_parameters(list, no_constant_modes, new_matrix);
        const Epetra_MultiVector modes = near_null_space_as_epetra();
        list.set("null space: type", "pre-computed");
        list.set("null space: dimension", modes.NumVectors());
        list.set("null space: vectors", modes.Values());
        preconditioner.initialize(new_matrix, list);
      }

      unsigned int
      solve(Vector       &solution,
            const Vector &rhs,
            const double  reduction) override
      {
        return conjugate_gradients(*matrix,
                                   solution,
                                   rhs,
                                   preconditioner,
                                   reduction,
                                   maximum_iterations);
      }

    private:
      Epetra_MultiVector
      near_null_space_as_epetra() const
      {
        Epetra_MultiVector modes(matrix->trilinos_matrix().RangeMap(),
                                 near_null_space.size());
        for (unsigned int mode = 0; mode < near_null_space.size(); ++mode)
          for (int i = 0; i < modes.MyLength(); ++i)
            modes[mode][i] = near_null_space[mode].local_element(i);
        return modes;
      }

      const unsigned int                    maximum_iterations;
      const std::vector<Vector>             near_null_space;
      const TrilinosWrappers::SparseMatrix *matrix = nullptr;
      TrilinosWrappers::PreconditionAMG     preconditioner;
    };



    class DirectSolver : public LinearSolver
    {
    public:
      void
      initialize(const TrilinosWrappers::SparseMatrix &matrix) override
      {
        factorization =
          std::make_unique<TrilinosWrappers::SolverDirect>(control);
        factorization->initialize(matrix);
      }

      unsigned int
      solve(Vector &solution, const Vector &rhs, const double) override
      {
        factorization->solve(solution, rhs);
        check_finite(solution.l2_norm());
        return 1;
      }

    private:
      SolverControl                                   control;
      std::unique_ptr<TrilinosWrappers::SolverDirect> factorization;
    };
  } // namespace



  std::unique_ptr<LinearSolver>
  make_linear_solver(const LinearSolverParameters &parameters,
                     const std::vector<Vector>    &near_null_space)
  {
    if (parameters.type == "direct")
      return std::make_unique<DirectSolver>();
    return std::make_unique<AmgSolver>(parameters.maximum_iterations,
                                       near_null_space);
  }
} // namespace ElastoPlastic
