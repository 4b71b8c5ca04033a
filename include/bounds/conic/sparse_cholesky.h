// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_conic_sparse_cholesky_h
#define bounds_conic_sparse_cholesky_h

#include <deal.II/lac/vector.h>

#include <memory>
#include <optional>
#include <vector>

#include "base/process.h"
#include "bounds/conic/multifrontal_factor.h"

#include <suitesparse/cholmod.h>

namespace ElastoPlastic
{
  using namespace dealii;

  /// Factorises a symmetric positive definite matrix on one process again and
  /// again, always with the same sparsity pattern. CHOLMOD
  /// @cite chen_davis_hager_rajamanickam_2008 finds the order of elimination
  /// and the structure of the factor; MultifrontalFactor computes its entries,
  /// and solves. The matrix is given by its entries, in the memory of the
  /// factor, which then takes their place: clear(), entry() and factorize()
  /// come in this order.
  class SparseCholesky
  {
  public:
    /// Finds an ordering with little fill for a matrix of @p n unknowns, all of
    /// which in each of the lists are @p coupled with each other: for instance
    /// those on the sides of a triangle. @throws MemoryError if the factors are
    /// larger than the memory.
    SparseCholesky(const unsigned int                            n,
                   const std::vector<std::vector<unsigned int>> &coupled);

    SparseCholesky(const SparseCholesky &) = delete;
    SparseCholesky &
    operator=(const SparseCholesky &) = delete;

    /// Makes all entries of the matrix zero.
    void
    clear()
    {
      fronts->clear();
    }

    /// Of unknowns that are coupled, one for both orders; always at the same
    /// address.
    double &
    entry(const unsigned int row, const unsigned int column)
    {
      return fronts->entry(row, column);
    }

    /// @return false if the matrix is not positive definite.
    bool
    factorize();

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

    /// In which order to eliminate the unknowns of a matrix of this pattern.
    std::vector<SuiteSparse_long>
    find_order(cholmod_sparse pattern);

    Common                                         common;
    std::unique_ptr<cholmod_factor, FactorDeleter> factor;
    std::unique_ptr<MultifrontalFactor>            fronts;
    std::optional<ReservedMemory> reserved; ///< for the fronts' workspace
  };
} // namespace ElastoPlastic

#endif
