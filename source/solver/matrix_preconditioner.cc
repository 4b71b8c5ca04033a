// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/lac/trilinos_precondition.h>

#include <Amesos.h>
#include <Epetra_LinearProblem.h>
#include <Epetra_MultiVector.h>
#include <Epetra_Vector.h>
#include <Teuchos_ParameterList.hpp>

#include "solver/krylov_methods.h"
#include "solver/matrix_preconditioner.h"

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
      initialize(const TrilinosWrappers::SparseMatrix &matrix) override
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



    /// Beyond that, MUMPS is faster than KLU: three times with 90,000 unknowns
    /// in the plane. In small systems, that are solved many times, its calls
    /// take longer than the work.
    constexpr long long largest_small_system = 5000;



    /// By Amesos. (deal.II's SolverDirect analyses the pattern again for each
    /// matrix, which takes nearly half of the time.)
    class Factorization : public MatrixPreconditioner
    {
    public:
      void
      initialize(const TrilinosWrappers::SparseMatrix &matrix) override
      {
        auto *const rows =
          const_cast<Epetra_CrsMatrix *>(&matrix.trilinos_matrix());
        if (problem.GetMatrix() != rows)
          analyze(*rows);
        if (solver->NumericFactorization() != 0)
          throw_singular();
      }

      void
      vmult(Vector &result, const Vector &vector) const override
      {
        const Epetra_BlockMap &map = problem.GetMatrix()->OperatorRangeMap();
        Epetra_Vector          lhs(View, map, result.begin());
        Epetra_Vector rhs(View, map, const_cast<double *>(vector.begin()));
        problem.SetLHS(&lhs);
        problem.SetRHS(&rhs);
        if (solver->Solve() != 0)
          throw_singular();
      }

    private:
      void
      analyze(Epetra_CrsMatrix &matrix)
      {
        problem.SetOperator(&matrix);
        solver.reset(
          Amesos().Create(matrix.NumGlobalRows64() <= largest_small_system ?
                            "Amesos_Klu" :
                            "Amesos_Mumps",
                          problem));
        Teuchos::ParameterList list;
        list.set("OutputLevel", 0);
        list.set("Refactorize", true); // with the pivots of the last matrix
        solver->SetParameters(list);
        if (solver->SymbolicFactorization() != 0)
          throw_singular();
      }

      mutable Epetra_LinearProblem       problem;
      std::unique_ptr<Amesos_BaseSolver> solver;
    };
  } // namespace



  std::unique_ptr<MatrixPreconditioner>
  make_algebraic_multigrid(const std::vector<Vector> &near_null_space)
  {
    return std::make_unique<AlgebraicMultigrid>(near_null_space);
  }



  std::unique_ptr<MatrixPreconditioner>
  make_factorization()
  {
    return std::make_unique<Factorization>();
  }
} // namespace ElastoPlastic
