// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef solver_system_matrix_h
#define solver_system_matrix_h

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
} // namespace ElastoPlastic

#endif
