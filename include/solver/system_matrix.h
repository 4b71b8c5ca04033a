// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef solver_system_matrix_h
#define solver_system_matrix_h

#include <deal.II/lac/la_parallel_vector.h>

#include <memory>
#include <vector>

#ifdef WITH_TRILINOS_SOLVERS
#  include <deal.II/lac/trilinos_sparse_matrix.h>
#  include <deal.II/lac/trilinos_sparsity_pattern.h>
#else
#  include <deal.II/lac/dynamic_sparsity_pattern.h>
#  include <deal.II/lac/sparse_matrix.h>
#  include <deal.II/lac/sparsity_pattern.h>
#endif

/// Assembled matrices, of one of two kinds: those of Trilinos' Epetra, or,
/// where deal.II has been configured without it, deal.II's own. All that
/// depends on it is here and in the files
/// source/solver/matrix_preconditioner_*.cc, of which one is compiled
/// (cmake/trilinos_solvers.cmake).

namespace ElastoPlastic
{
  using namespace dealii;



#ifdef WITH_TRILINOS_SOLVERS
  constexpr bool has_algebraic_multigrid = true;

  using SystemMatrix  = TrilinosWrappers::SparseMatrix;
  using SystemPattern = TrilinosWrappers::SparsityPattern;
  /// What deal.II adds the matrices of cells to.
  using AssembledMatrix = SystemMatrix;

  /// Still without entries. Those of @p writable rows will be added here.
  inline SystemPattern
  make_pattern(const IndexSet &owned,
               const IndexSet &writable,
               const MPI_Comm  communicator)
  {
    return {owned, owned, writable, communicator};
  }
#else
  constexpr bool has_algebraic_multigrid = false;

  using SystemPattern   = DynamicSparsityPattern;
  using AssembledMatrix = SparseMatrix<double>;

  /// What this rank has assembled: the matrix is the sum of those of all ranks.
  class SystemMatrix : public AssembledMatrix
  {
  public:
    using AssembledMatrix::operator=;

    ~SystemMatrix() override
    {
      clear();
    }

    void
    reinit(const SystemPattern &new_pattern)
    {
      clear();
      pattern.copy_from(new_pattern);
      AssembledMatrix::reinit(pattern);
    }

  private:
    SparsityPattern pattern;
  };

  inline SystemPattern
  make_pattern(const IndexSet &owned,
               const IndexSet &writable,
               const MPI_Comm /* communicator */)
  {
    return {owned.size(), owned.size(), writable};
  }
#endif



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
