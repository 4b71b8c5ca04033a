// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

#include "base/memory.h"
#include "equilibrium/sparse_cholesky.h"

#include <omp.h>

namespace ElastoPlastic
{
  SparseCholesky::Common::Common()
  {
    cholmod_start(this);
    // Errors are reported by return values.
    print = 0;
    // CHOLMOD would start threads, for pieces that are too small for them,
    // where another rank may be at work.
    omp_set_max_active_levels(0);
  }



  SparseCholesky::Common::~Common()
  {
    cholmod_finish(this);
  }



  void
  SparseCholesky::FactorDeleter::operator()(cholmod_factor *factor) const
  {
    cholmod_free_factor(&factor, common);
  }



  SparseCholesky::SparseCholesky(const SparsityPattern &pattern)
    : row_begins(1, 0)
    , factor(nullptr, FactorDeleter{&common})
  {
    for (unsigned int row = 0; row < pattern.n_rows(); ++row)
      {
        for (auto entry = pattern.begin(row); entry != pattern.end(row);
             ++entry)
          if (entry->column() <= row)
            columns.push_back(entry->column());
        std::sort(columns.begin() + row_begins.back(), columns.end());
        row_begins.push_back(columns.size());
      }
    values.resize(columns.size());
    cholmod_sparse matrix = view();
    factor.reset(cholmod_analyze(&matrix, &common));
    if (!factor)
      throw std::bad_alloc();
    // The entries of the factor with their places, a permuted copy of the
    // matrix, and the largest update of a supernode.
    const double entry = sizeof(double) + sizeof(int);
    require_memory(entry * columns.size() +
                     (factor->is_super ?
                        sizeof(int) * static_cast<double>(factor->ssize) +
                          sizeof(double) *
                            (static_cast<double>(factor->xsize) +
                             static_cast<double>(factor->maxcsize)) :
                        entry * common.lnz),
                   "to factorise the equations of the equilibrium method");
  }



  cholmod_sparse
  SparseCholesky::view()
  {
    cholmod_sparse matrix = {};
    matrix.nrow = matrix.ncol = row_begins.size() - 1;
    matrix.nzmax              = columns.size();
    matrix.p                  = row_begins.data();
    matrix.i                  = columns.data();
    matrix.x                  = values.data();
    matrix.stype              = 1;
    matrix.itype              = CHOLMOD_INT;
    matrix.xtype              = CHOLMOD_REAL;
    matrix.dtype              = CHOLMOD_DOUBLE;
    matrix.sorted = matrix.packed = 1;
    return matrix;
  }



  bool
  SparseCholesky::factorize(const SparseMatrix<double> &matrix)
  {
    // deal.II stores the diagonal first, CHOLMOD wants it last.
    for (unsigned int row = 0; row < matrix.m(); ++row)
      {
        auto      entry = matrix.begin(row);
        const int last  = row_begins[row + 1] - 1;
        values[last]    = entry->value();
        for (int k = row_begins[row]; k < last; ++k)
          values[k] = (++entry)->value();
      }
    cholmod_sparse lower = view();
    cholmod_factorize(&lower, factor.get(), &common);
    if (common.status == CHOLMOD_OUT_OF_MEMORY)
      throw std::bad_alloc();
    return common.status == CHOLMOD_OK;
  }



  void
  SparseCholesky::vmult(Vector<double>       &solution,
                        const Vector<double> &right_hand_side) const
  {
    cholmod_dense view = {};
    view.nrow = view.nzmax = view.d = right_hand_side.size();
    view.ncol                       = 1;
    view.x     = const_cast<double *>(right_hand_side.begin());
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;

    cholmod_dense *result =
      cholmod_solve(CHOLMOD_A, factor.get(), &view, &common);
    if (result == nullptr)
      throw std::bad_alloc();
    const auto *const begin = static_cast<const double *>(result->x);
    solution.reinit(right_hand_side.size(), true);
    std::copy(begin, begin + solution.size(), solution.begin());
    cholmod_free_dense(&result, &common);
  }
} // namespace ElastoPlastic
