// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_conic_sparse_cholesky_h
#define bounds_conic_sparse_cholesky_h

#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include <memory>
#include <vector>

#include "bounds/conic/multifrontal_factor.h"

#include <suitesparse/cholmod.h>

namespace ElastoPlastic
{
  using namespace dealii;

  /// Factorises a symmetric positive definite matrix on one process again and
  /// again, always with the same sparsity pattern. CHOLMOD
  /// @cite chen_davis_hager_rajamanickam_2008 finds the order of elimination
  /// and the structure of the factor; MultifrontalFactor computes its entries,
  /// and solves.
  class SparseCholesky
  {
  public:
    /// Finds an ordering with little fill. @throws FileError if the factors are
    /// larger than the memory.
    explicit SparseCholesky(const SparsityPattern &pattern);

    SparseCholesky(const SparseCholesky &) = delete;
    SparseCholesky &
    operator=(const SparseCholesky &) = delete;

    /// @return false if the matrix is not positive definite. Only its lower
    /// half is read.
    bool
    factorize(const SparseMatrix<double> &matrix);

    /// With the last factors.
    void
    vmult(Vector<double>       &solution,
          const Vector<double> &right_hand_side) const;

  private:
    /// CHOLMOD's settings and workspace, which all calls change.
    struct Common : cholmod_common
    {
      Common();
      ~Common()
      {
        cholmod_l_finish(this);
      }
      Common(const Common &) = delete;
      Common &
      operator=(const Common &) = delete;
    };

    struct FactorDeleter
    {
      Common *common;
      void
      operator()(cholmod_factor *factor) const
      {
        cholmod_l_free_factor(&factor, common);
      }
    };

    Common                                         common;
    std::unique_ptr<cholmod_factor, FactorDeleter> factor;
    std::unique_ptr<MultifrontalFactor>            fronts;

    /// Where the entries of the lower half are in the array of the factor.
    std::vector<std::size_t> positions;
  };
} // namespace ElastoPlastic

#endif
