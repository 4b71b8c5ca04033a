// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/lac/trilinos_precondition.h>

// (Trilinos 16 calls them deprecated.)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wcpp"
#include <Amesos.h>
#include <Amesos_Mumps.h>
#include <Epetra_LinearProblem.h>
#include <Epetra_MultiVector.h>
#include <Epetra_Vector.h>
#include <Teuchos_ParameterList.hpp>
#pragma GCC diagnostic pop

#include <cmath>
#include <set>

#include "base/process.h"
#include "solver/krylov_methods.h"
#include "solver/system_matrix.h"

namespace ElastoPlastic
{
  namespace
  {
    using Vector = MatrixPreconditioner::Vector;

    /// A V-cycle of Trilinos ML, smoothed aggregation.
    class AlgebraicMultigrid : public MatrixPreconditioner
    {
    public:
      explicit AlgebraicMultigrid(const std::vector<Vector> &near_null_space)
        : near_null_space(near_null_space)
      {}

      void
      initialize(const SystemMatrix &matrix,
                 const unsigned int /* pattern */) override
      {
        TrilinosWrappers::PreconditionAMG::AdditionalData data;
        data.elliptic              = true;
        data.higher_order_elements = false;
        data.smoother_sweeps       = 2;
        data.aggregation_threshold = 0.02;

        Teuchos::ParameterList              list;
        std::unique_ptr<Epetra_MultiVector> no_constant_modes;
        data.set_parameters(list, no_constant_modes, matrix);
        const Epetra_MultiVector modes =
          as_epetra(near_null_space, matrix.trilinos_matrix().RangeMap());
        list.set("null space: type", "pre-computed");
        list.set("null space: dimension", modes.NumVectors());
        list.set("null space: vectors", modes.Values());
        preconditioner.initialize(matrix, list);
      }

      void
      vmult(Vector &result, const Vector &vector) const override
      {
        preconditioner.vmult(result, vector);
      }

    private:
      static Epetra_MultiVector
      as_epetra(const std::vector<Vector> &vectors, const Epetra_BlockMap &map)
      {
        Epetra_MultiVector result(map, vectors.size());
        for (unsigned int v = 0; v < vectors.size(); ++v)
          for (int i = 0; i < result.MyLength(); ++i)
            result[v][i] = vectors[v].local_element(i);
        return result;
      }

      const std::vector<Vector>         near_null_space;
      TrilinosWrappers::PreconditionAMG preconditioner;
    };



    /// Beyond that, MUMPS is faster than KLU. In small systems, that are solved
    /// many times, its calls take longer than the work.
    constexpr long long largest_small_system = 5000;



    /// By Amesos. (deal.II's SolverDirect analyses the pattern again for each
    /// matrix, and cannot say why MUMPS has failed.)
    class Factorization : public MatrixPreconditioner
    {
    public:
      // MUMPS would wait for the other ranks.
      ~Factorization() override
      {
        if (solver && std::uncaught_exceptions() > 0)
          {
            Teuchos::ParameterList list;
            list.set("NoDestroy", true);
            solver->SetParameters(list);
          }
      }

      void
      initialize(const SystemMatrix &matrix,
                 const unsigned int  pattern) override
      {
        if (!std::isfinite(matrix.frobenius_norm()))
          throw_singular();
        if (!solver || pattern != analyzed_pattern)
          analyze(matrix);
        analyzed_pattern = pattern;
        check(factorize(matrix));
      }

      void
      vmult(Vector &result, const Vector &vector) const override
      {
        const Epetra_BlockMap &map = problem.GetMatrix()->OperatorRangeMap();
        Epetra_Vector          lhs(View, map, result.begin());
        Epetra_Vector rhs(View, map, const_cast<double *>(vector.begin()));
        problem.SetLHS(&lhs);
        problem.SetRHS(&rhs);
        const SilentErrorStream silence;
        const int               status = solver->Solve();
        problem.SetLHS(nullptr);
        problem.SetRHS(nullptr);
        check(status);
      }

    private:
      void
      analyze(const SystemMatrix &matrix)
      {
        problem.SetOperator(
          const_cast<Epetra_CrsMatrix *>(&matrix.trilinos_matrix()));
        solver.reset(Amesos().Create(matrix.m() <= largest_small_system ?
                                       "Amesos_Klu" :
                                       "Amesos_Mumps",
                                     problem));
        mumps = dynamic_cast<Amesos_Mumps *>(solver.get());

        // KLU keeps its pivots, unless they have become small; MUMPS gets more
        // workspace than it has estimated.
        Teuchos::ParameterList list;
        list.set("Refactorize", true);
        list.sublist("mumps").set("ICNTL(14)", additional_workspace);
        solver->SetParameters(list);
        const SilentErrorStream silence;
        check(solver->SymbolicFactorization());
      }

      /// The pivots may want another order than that of the analysis, with
      /// other entries. The more of them are postponed, the more workspace
      /// MUMPS needs: in a matrix that is nearly singular, without end.
      /// @return what the last call has returned.
      int
      factorize(const SystemMatrix &matrix)
      {
        while (true)
          {
            int status;
            {
              const SilentErrorStream silence;
              status = solver->NumericFactorization();
            }
            if (lacks_workspace.count(status_of_mumps()) == 0 ||
                additional_workspace >= largest_additional_workspace)
              return status;
            additional_workspace *= 2;
            analyze(matrix);
          }
      }

      /// INFOG(1), on all ranks; 0 if the solver is another one.
      int
      status_of_mumps() const
      {
        int status = mumps != nullptr ? mumps->GetINFOG()[0] : 0;
        problem.GetMatrix()->Comm().Broadcast(&status, 1, 0);
        return status;
      }

      /// Collective. @p status is what a call has returned. (After a solution,
      /// MUMPS' is always zero.)
      void
      check(const int status) const
      {
        const int of_mumps = status_of_mumps();
        if (of_mumps < 0 && singular.count(of_mumps) == 0 &&
            lacks_workspace.count(of_mumps) == 0)
          throw FileError(
            "MUMPS cannot factorise the system. Its manual says "
            "what INFOG(1) = " +
            std::to_string(of_mumps) +
            " means: mostly, that there is not enough memory. "
            "More machines, a coarser mesh, or another 'Linear "
            "solver/Type' need less.");
        if (status != 0 || of_mumps < 0)
          throw_singular();
      }

      // Values of INFOG(1).
      inline static const std::set<int> singular        = {-6, -10};
      inline static const std::set<int> lacks_workspace = {
        -8, -9, -11, -14, -15, -17, -20};

      /// In percent of what MUMPS has estimated.
      int                  additional_workspace         = 50;
      static constexpr int largest_additional_workspace = 1600;

      mutable Epetra_LinearProblem       problem;
      std::unique_ptr<Amesos_BaseSolver> solver;
      unsigned int                       analyzed_pattern = 0;
      /// The solver, if it is that.
      Amesos_Mumps *mumps = nullptr;
    };
  } // namespace



  std::unique_ptr<MatrixPreconditioner>
  make_algebraic_multigrid(const std::vector<Vector> &near_null_space)
  {
    return std::make_unique<AlgebraicMultigrid>(near_null_space);
  }



  std::unique_ptr<MatrixPreconditioner>
  make_factorization(const MPI_Comm /* communicator */)
  {
    return std::make_unique<Factorization>();
  }
} // namespace ElastoPlastic
