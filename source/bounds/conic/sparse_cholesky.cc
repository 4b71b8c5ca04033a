// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

#include "base/process.h"
#include "bounds/conic/sparse_cholesky.h"

namespace ElastoPlastic
{
  SparseCholesky::Common::Common()
  {
    cholmod_l_start(this);
    // Errors are reported by return values.
    print      = 0;
    supernodal = CHOLMOD_SUPERNODAL;
    // METIS' own ordering would catch SIGTERM.
    default_nesdis = 1;
  }



  SparseCholesky::SparseCholesky(const SparsityPattern &pattern)
    : factor(nullptr, FactorDeleter{&common})
  {
    // The lower half by rows is, for CHOLMOD, the upper half by columns.
    std::vector<SuiteSparse_long> row_begins(1, 0), columns;
    for (unsigned int row = 0; row < pattern.n_rows(); ++row)
      {
        for (auto entry = pattern.begin(row); entry != pattern.end(row);
             ++entry)
          if (entry->column() <= row)
            columns.push_back(entry->column());
        std::sort(columns.begin() + row_begins.back(), columns.end());
        row_begins.push_back(columns.size());
      }
    cholmod_sparse matrix = {};
    matrix.nrow = matrix.ncol = pattern.n_rows();
    matrix.nzmax              = columns.size();
    matrix.p                  = row_begins.data();
    matrix.i                  = columns.data();
    matrix.stype              = 1;
    matrix.itype              = CHOLMOD_LONG;
    matrix.xtype              = CHOLMOD_PATTERN;
    matrix.dtype              = CHOLMOD_DOUBLE;
    matrix.sorted = matrix.packed = 1;
    factor.reset(cholmod_l_analyze(&matrix, &common));
    if (!factor)
      throw std::bad_alloc();
    fronts = std::make_unique<MultifrontalFactor>(*factor);
    require_memory(sizeof(double) * static_cast<double>(factor->xsize) +
                     fronts->workspace() + sizeof(std::size_t) * columns.size(),
                   "to factorise the equations of the equilibrium method");
    positions = fronts->positions(pattern);
    if (!cholmod_l_change_factor(
          CHOLMOD_REAL, 1, 1, 1, 1, factor.get(), &common))
      throw std::bad_alloc();
    // (Memory that has not been touched does not count as used: another factor
    // would find room in it, too.)
    std::fill_n(static_cast<double *>(factor->x), factor->xsize, 0.);
  }



  // deal.II stores the diagonal first, then the rest in the order of columns.
  bool
  SparseCholesky::factorize(const SparseMatrix<double> &matrix)
  {
    auto *const values = static_cast<double *>(factor->x);
    std::fill_n(values, factor->xsize, 0.);
    auto position = positions.begin();
    for (unsigned int row = 0; row < matrix.m(); ++row)
      for (auto entry = matrix.begin(row);
           entry != matrix.end(row) && entry->column() <= row;
           ++entry)
        values[*position++] = entry->value();
    return fronts->factorize();
  }



  void
  SparseCholesky::vmult(Vector<double>       &solution,
                        const Vector<double> &right_hand_side) const
  {
    const auto *const order =
      static_cast<const SuiteSparse_long *>(factor->Perm);
    Vector<double> ordered(right_hand_side.size());
    for (unsigned int i = 0; i < ordered.size(); ++i)
      ordered[i] = right_hand_side[order[i]];
    fronts->solve(ordered.begin());
    solution.reinit(right_hand_side.size(), true);
    for (unsigned int i = 0; i < ordered.size(); ++i)
      solution[order[i]] = ordered[i];
  }
} // namespace ElastoPlastic
