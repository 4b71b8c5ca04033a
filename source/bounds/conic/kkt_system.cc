// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "bounds/conic/kkt_system.h"
#include "bounds/conic/tolerances.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Solves are repeated so often at most, while each halves the residual.
    constexpr unsigned int max_repetitions = 12;

    double
    square(const KktVector &v)
    {
      return v.x.norm_sqr() + v.y.norm_sqr() + v.z.norm_sqr() +
             v.load_factor * v.load_factor;
    }
  } // namespace



  KktSystem::KktSystem(ConicProgram &program, const ConicLayout &layout)
    : program(program)
    , n_sparse_rows(program.right_hand_side.size() -
                    (program.has_dense_row ? 1 : 0))
    , dense_row(n_sparse_rows)
  {
    std::vector<std::vector<unsigned int>> coupled;
    for (const ConicBlock &block : program.blocks)
      std::copy_if(block.rows.begin(),
                   block.rows.end(),
                   std::back_inserter(coupled.emplace_back()),
                   [&](const unsigned int row) { return row < n_sparse_rows; });
    batches       = BlockBatch::make(std::move(program.blocks), layout);
    sparse_factor = std::make_unique<SparseCholesky>(n_sparse_rows, coupled);
    for (BlockBatch &batch : batches)
      batch.set_targets([&](const unsigned int row, const unsigned int column) {
        return row < n_sparse_rows    ? &sparse_factor->entry(row, column) :
               column < n_sparse_rows ? &dense_row[column] :
                                        &dense_square;
      });
  }



  bool
  KktSystem::factorize(const Scalings &scalings)
  {
    if (!factorize_sum(scalings))
      return false;
    if (program.has_dense_row)
      {
        sparse_factor->vmult(dense_solution, dense_row);
        dense_square -= dense_row * dense_solution;
      }
    live_load_solution = program.live_load;
    if (program.live_load.size() > 0)
      solve_sparse_and_dense(live_load_solution);
    return true;
  }



  bool
  KktSystem::factorize_sum(const Scalings &scalings)
  {
    for (const double rounding : Tolerance::roundings_of_sum)
      {
        sparse_factor->clear();
        dense_row    = 0.;
        dense_square = 0.;
        for (BlockBatch &batch : batches)
          if (!batch.eliminate(scalings))
            return false;
        if (rounding > 0)
          for (unsigned int i = 0; i < n_sparse_rows; ++i)
            sparse_factor->entry(i, i) *= 1. + rounding;
        if (sparse_factor->factorize())
          return true;
      }
    return false;
  }



  void
  KktSystem::solve(KktVector   &solution,
                   KktVector    residual,
                   const double relative_residual) const
  {
    const double small =
      relative_residual * relative_residual * square(residual);
    double         last = std::numeric_limits<double>::max();
    Vector<double> y, reduced(residual.x.size());
    solution = KktVector();
    solution.x.reinit(residual.x.size());
    solution.y.reinit(residual.y.size());
    solution.z.reinit(residual.z.size());
    for (unsigned int k = 0; k <= max_repetitions; ++k)
      {
        y = residual.y;
        y *= -1.;
        for (const BlockBatch &batch : batches)
          batch.reduce(y, reduced, residual, workspace);
        solve_sparse_and_dense(y);
        const double lambda = add_live_load(y, residual.load_factor);
        solution.y += y;
        solution.load_factor += lambda;
        subtract_live_load_product(residual, y, lambda);
        for (const BlockBatch &batch : batches)
          batch.substitute(solution, residual, reduced, y, workspace);

        const double remainder = square(residual);
        if (remainder > 0.25 * last || remainder < small)
          break;
        last = remainder;
      }
  }



  void
  KktSystem::solve_sparse_and_dense(Vector<double> &y) const
  {
    Vector<double> sparse(n_sparse_rows), solution;
    std::copy(y.begin(), y.begin() + n_sparse_rows, sparse.begin());
    sparse_factor->vmult(solution, sparse);
    if (program.has_dense_row)
      {
        double &dense = y[n_sparse_rows];
        dense         = (dense - dense_row * solution) / dense_square;
        solution.add(-dense, dense_solution);
      }
    std::copy(solution.begin(), solution.end(), y.begin());
  }



  double
  KktSystem::add_live_load(Vector<double> &y, const double r_lambda) const
  {
    if (live_load_solution.size() == 0)
      return 0.;
    const double lambda = (r_lambda + program.live_load * y) /
                          (program.live_load * live_load_solution);
    y.add(-lambda, live_load_solution);
    return lambda;
  }



  void
  KktSystem::subtract_live_load_product(KktVector            &residual,
                                        const Vector<double> &y,
                                        const double          lambda) const
  {
    if (program.live_load.size() > 0)
      {
        residual.y.add(lambda, program.live_load);
        residual.load_factor += program.live_load * y;
      }
  }



  Vector<double>
  KktSystem::quadratic_slope(const Vector<double> &x) const
  {
    Vector<double> slope(x.size());
    for (const BlockBatch &batch : batches)
      batch.add_quadratic_slope(slope, x, workspace);
    return slope;
  }



  void
  KktSystem::subtract_product(KktVector       &residual,
                              const KktVector &solution) const
  {
    subtract_live_load_product(residual, solution.y, solution.load_factor);
    for (const BlockBatch &batch : batches)
      batch.subtract_product(residual, solution, workspace);
  }
} // namespace ElastoPlastic
