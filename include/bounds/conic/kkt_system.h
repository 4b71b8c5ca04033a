// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_conic_kkt_system_h
#define bounds_conic_kkt_system_h

#include <deal.II/lac/vector.h>

#include <memory>
#include <vector>

#include "bounds/conic/block_batch.h"
#include "bounds/conic/conic_program.h"
#include "bounds/conic/sparse_cholesky.h"
#include "bounds/conic/tolerances.h"

namespace ElastoPlastic
{
  /// The linear system of an interior point step,
  ///   P x + A^T y + G^T z   = r_x
  ///   A x - lambda d        = r_y
  ///       - d^T y           = r_lambda, if there is a load factor,
  ///   G x         - W^2 z   = r_z,
  /// W being the scalings of the cones. The blocks eliminate z and x, one by
  /// one: with the local matrices H = P + G^T W^-2 G, the sum of all A H^-1 A^T
  /// remains. It is sparse and positive definite, like the stiffness matrix of
  /// a displacement method with the unknowns y.
  class KktSystem
  {
  public:
    using Scalings = BlockBatch::Scalings;

    /// The program must live as long as this object, which takes its blocks
    /// away.
    KktSystem(ConicProgram &program, const ConicLayout &layout);

    /// The blocks know where their entries are in the matrix of this one.
    KktSystem(const KktSystem &) = delete;
    KktSystem &
    operator=(const KktSystem &) = delete;

    /// Eliminates and factorises. Blocks without quadratic cost may be
    /// singular: a rigid-plastic body has no compliance, and no yield condition
    /// bounds the mean stress. BlockBatch::eliminate() gives them some. The
    /// diagonals of the sum grow by rounding errors if it could not be
    /// factorised else.
    /// @return false if rounding has made the matrix indefinite all the same.
    bool
    factorize(const Scalings &scalings);

    /// Solves the system for the right-hand side @p residual, and again for
    /// what each solution leaves of it: this removes what has been added, and
    /// most of the rounding errors.
    void
    solve(KktVector   &solution,
          KktVector    residual,
          const double relative_residual = Tolerance::residual) const;

    /// P x
    Vector<double>
    quadratic_slope(const Vector<double> &x) const;

    /// residual -= (the matrix above without W) solution
    void
    subtract_product(KktVector &residual, const KktVector &solution) const;

  private:
    bool
    factorize_sum(const Scalings &scalings);

    void
    solve_sparse_and_dense(Vector<double> &y) const;

    void
    subtract_live_load_product(KktVector            &residual,
                               const Vector<double> &y,
                               const double          lambda) const;

    /// Takes d into the solution @p y of the sum of all blocks.
    /// @return lambda, such that -d^T y = @p r_lambda.
    double
    add_live_load(Vector<double> &y, const double r_lambda) const;

    const ConicProgram           &program;
    const unsigned int            n_sparse_rows;
    std::vector<BlockBatch>       batches;
    mutable BlockBatch::Workspace workspace;

    /// Of the sum of all blocks, but for its dense row.
    std::unique_ptr<SparseCholesky> sparse_factor;

    /// The dense row of the matrix, solved with the sparse part; and what is
    /// left of its own square.
    Vector<double> dense_row;
    Vector<double> dense_solution;
    double         dense_square;

    /// Solution for the right-hand side d.
    Vector<double> live_load_solution;
  };
} // namespace ElastoPlastic

#endif
