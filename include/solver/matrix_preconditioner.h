// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef solver_matrix_preconditioner_h
#define solver_matrix_preconditioner_h

#include <deal.II/lac/la_parallel_vector.h>

#include <memory>
#include <string>
#include <vector>

#include "solver/system_matrix.h"

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
    initialize(const SystemMatrix &matrix, const unsigned int pattern) = 0;

    virtual void
    vmult(Vector &result, const Vector &vector) const = 0;
  };



  /// Algebraic multigrid. @p near_null_space holds the rigid body motions of
  /// the body, which it must represent on its coarse levels. Only if there is
  /// one: has_algebraic_multigrid.
  std::unique_ptr<MatrixPreconditioner>
  make_algebraic_multigrid(
    const std::vector<MatrixPreconditioner::Vector> &near_null_space);

  /// A sparse factorisation, which does for unsymmetric matrices, too. With
  /// Trilinos by KLU up to 5000 unknowns, by MUMPS beyond; else by UMFPACK, on
  /// the first rank of @p communicator. To destroy it is collective.
  std::unique_ptr<MatrixPreconditioner>
  make_factorization(const MPI_Comm communicator);
} // namespace ElastoPlastic

#endif
