// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <new>
#include <string>

#include "base/exceptions.h"
#include "base/shared_rows.h"
#include "solver/krylov_methods.h"
#include "solver/system_matrix.h"

namespace ElastoPlastic
{
  namespace
  {
    /// The first rank gathers the matrix and factorises it by UMFPACK.
    /// (deal.II's SparseDirectMUMPS, from 9.7 on, keeps the status of MUMPS to
    /// itself: for a matrix of zeros, it returns the right-hand side.)
    class GatheredFactorization : public MatrixPreconditioner
    {
    public:
      explicit GatheredFactorization(const MPI_Comm communicator)
        : communicator(communicator)
      {}

      void
      initialize(const SystemMatrix &matrix,
                 const unsigned int /* pattern */) override
      {
        std::vector<Entry> entries;
        for (const auto &entry : matrix)
          entries.push_back({entry.row(), entry.column(), entry.value()});
        const auto of_ranks =
          Utilities::MPI::gather(communicator, entries, first);
        rethrow_collectively(communicator, [&]() {
          if (!of_ranks.empty())
            factorize(of_ranks, matrix.m());
        });
      }

      /// Ranks own one range of unknowns after the other.
      void
      vmult(Vector &result, const Vector &vector) const override
      {
        const std::vector<double> own(vector.begin(),
                                      vector.begin() +
                                        vector.locally_owned_size());
        dealii::Vector<double>    solution;
        for (const auto &of_rank :
             Utilities::MPI::gather(communicator, own, first))
          append(solution, of_rank);
        rethrow_collectively(communicator, [&]() {
          if (solution.size() > 0)
            run_umfpack([&]() { factors.solve(solution); });
        });
        solution = Utilities::MPI::broadcast(communicator, solution, first);
        for (unsigned int i = 0; i < result.locally_owned_size(); ++i)
          result.local_element(i) =
            solution[result.locally_owned_elements().nth_index_in_set(i)];
      }

    private:
      static constexpr unsigned int first = 0;

      using Entry = SharedRows::Entry;

      static void
      append(dealii::Vector<double> &to, const std::vector<double> &numbers)
      {
        const unsigned int n = to.size();
        to.grow_or_shrink(n + numbers.size());
        std::copy(numbers.begin(), numbers.end(), to.begin() + n);
      }

      void
      factorize(const std::vector<std::vector<Entry>> &of_ranks,
                const types::global_dof_index          n)
      {
        DynamicSparsityPattern entries(n, n);
        for (const auto &of_rank : of_ranks)
          for (const Entry &entry : of_rank)
            entries.add(entry.row, entry.column);
        SparsityPattern pattern;
        pattern.copy_from(entries);
        SparseMatrix<double> sum(pattern);
        for (const auto &of_rank : of_ranks)
          for (const Entry &entry : of_rank)
            sum.add(entry.row, entry.column, entry.value);
        if (!std::isfinite(sum.frobenius_norm()))
          throw_singular();
        run_umfpack([&]() { factors.factorize(sum); });
      }

      /// (The exception keeps the status, of which -1 is lack of memory, to
      /// itself, but for its text.)
      static void
      run_umfpack(const std::function<void()> &call)
      {
        try
          {
            call();
          }
        catch (const SparseDirectUMFPACK::ExcUMFPACKError &error)
          {
            if (std::string(error.what()).find("error status -1.") !=
                std::string::npos)
              throw std::bad_alloc();
            throw_singular();
          }
      }

      const MPI_Comm              communicator;
      mutable SparseDirectUMFPACK factors;
    };
  } // namespace



  std::unique_ptr<MatrixPreconditioner>
  make_algebraic_multigrid(
    const std::vector<MatrixPreconditioner::Vector> & /* near_null_space */)
  {
    AssertThrow(has_algebraic_multigrid,
                ExcMessage("Algebraic multigrid is that of Trilinos."));
    return {};
  }



  std::unique_ptr<MatrixPreconditioner>
  make_factorization(const MPI_Comm communicator)
  {
    return std::make_unique<GatheredFactorization>(communicator);
  }
} // namespace ElastoPlastic
