// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef solver_matrix_preconditioner_h
#define solver_matrix_preconditioner_h

#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <memory>
#include <string>
#include <vector>

namespace ElastoPlastic
{
  using namespace dealii;

  /// Approximates the inverse of an assembled, symmetric positive definite
  /// matrix.
  class MatrixPreconditioner
  {
  public:
    using Vector = LinearAlgebra::distributed::Vector<double>;

    virtual ~MatrixPreconditioner() = default;

    /// Prepares for @p matrix: always the same object, which must outlive this
    /// one; @p pattern is another number whenever its pattern has been made
    /// anew, be it the same. Collective.
    /// @throws ConvergenceError if it is found to be singular, FileError if
    /// memory is missing.
    virtual void
    initialize(const TrilinosWrappers::SparseMatrix &matrix,
               const unsigned int                    pattern) = 0;

    virtual void
    vmult(Vector &result, const Vector &vector) const = 0;
  };



  /// Algebraic multigrid. @p near_null_space holds the rigid body motions of
  /// the body, which it must represent on its coarse levels.
  std::unique_ptr<MatrixPreconditioner>
  make_algebraic_multigrid(
    const std::vector<MatrixPreconditioner::Vector> &near_null_space);

  /// A sparse factorisation, which does for unsymmetric matrices, too: by KLU
  /// up to 5000 unknowns, by MUMPS beyond. To destroy it is collective.
  std::unique_ptr<MatrixPreconditioner>
  make_factorization();
} // namespace ElastoPlastic

#endif
