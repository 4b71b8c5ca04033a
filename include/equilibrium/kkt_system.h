// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef equilibrium_kkt_system_h
#define equilibrium_kkt_system_h

#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/sparsity_pattern.h>

#include <memory>
#include <vector>

#include "equilibrium/conic_program.h"
#include "equilibrium/local_algebra.h"
#include "equilibrium/second_order_cone.h"
#include "equilibrium/sparse_cholesky.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// The unknowns of the optimality conditions of a ConicProgram without the
  /// slack variables, or the residuals of these conditions.
  struct KktVector
  {
    Vector<double> x; ///< see ConicLayout::unknowns
    Vector<double> z; ///< see ConicLayout::rows
    Vector<double> y; ///< by equations
    double         load_factor = 0;
  };



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
    /// By cones.
    using Scalings = std::vector<SecondOrderCone::Scaling>;

    /// Both must live as long as this object.
    KktSystem(const ConicProgram &program, const ConicLayout &layout);

    /// Eliminates and factorises; @p scalings must live as long as solve() is
    /// called. Blocks without quadratic cost may be singular: a rigid-plastic
    /// body has no compliance, and no yield condition bounds the mean stress.
    /// Their H gets a small compliance in the directions that no cone sees, and
    /// in no others. All diagonals grow by the order of rounding errors, that
    /// of the sum by more if it could not be factorised else.
    /// @return false if rounding has made the matrix indefinite all the same.
    bool
    factorize(const Scalings &scalings);

    /// Solves the system, and repeats that with what is left: this removes what
    /// has been added, and most of the rounding errors.
    void
    solve(KktVector &solution, const KktVector &right_hand_side) const;

    /// residual -= (the matrix above without W) solution
    void
    subtract_product(KktVector &residual, const KktVector &solution) const;

  private:
    /// Finds the directions that no cone sees.
    void
    find_kernels();

    /// Finds where the cones' matrices G have entries, and which unknowns of a
    /// block are coupled neither by these nor by the cost.
    void
    find_strips();
    void
    find_parts();

    bool
    eliminate(const unsigned int block);

    bool
    factorize_sum();

    /// Of the @p contribution, only the lower half is used.
    void
    add_to_matrix(const std::vector<unsigned int> &rows,
                  const FullMatrix<double>        &contribution);

    void
    solve_once(KktVector &solution, const KktVector &right_hand_side) const;

    void
    solve_sparse_and_dense(Vector<double> &y) const;

    /// Takes d into the solution @p y of the sum of all blocks.
    /// @return lambda, such that -d^T y = @p r_lambda.
    double
    add_growth(Vector<double> &y, const double r_lambda) const;

    /// z := W^-2 z for the cones of a block
    void
    divide_by_square(Vector<double> &z, const unsigned int block) const;

    /// z += factor G x for a block, with pointers to its own entries.
    void
    add_cone_product(double            *z,
                     const unsigned int block,
                     const double      *x,
                     const double       factor) const;

    /// x += factor G^T z
    void
    add_transposed_cone_product(double            *x,
                                const unsigned int block,
                                const double      *z,
                                const double       factor) const;

    const ConicProgram &program;
    const ConicLayout  &layout;
    const unsigned int  n_sparse_rows;
    const Scalings     *scalings = nullptr;

    /// Of each block: L with H = L L^T, and A L^-T.
    std::vector<FullMatrix<double>> local_factors;
    std::vector<FullMatrix<double>> local_couplings;

    /// Of each block without quadratic cost: an orthonormal basis of the
    /// directions that no cone sees, one per row.
    std::vector<FullMatrix<double>> kernels;

    /// Rows of G, and the columns outside which they are zero.
    struct Strip
    {
      LocalAlgebra::Part rows;
      LocalAlgebra::Part columns;
    };

    /// Of each block: all strips; and the parts that H consists of, as it is
    /// block-diagonal.
    std::vector<std::vector<Strip>>              strips;
    std::vector<std::vector<LocalAlgebra::Part>> parts;

    SparsityPattern                 sparsity_pattern;
    SparseMatrix<double>            matrix;
    std::unique_ptr<SparseCholesky> sparse_factor;

    /// The dense rows of the matrix, solved with the sparse part; and the
    /// inverse of what is left of their own square.
    std::vector<Vector<double>> dense_rows;
    std::vector<Vector<double>> dense_solutions;
    FullMatrix<double>          dense_inverse;

    /// Solution for the right-hand side d.
    Vector<double> growth_solution;
  };
} // namespace ElastoPlastic

#endif
