// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_tangent_matrix_h
#define mechanics_tangent_matrix_h

#include <deal.II/lac/trilinos_sparse_matrix.h>

#include "mechanics/solid_operator.h"

namespace ElastoPlastic
{
  /// The assembled consistent tangent, with hanging nodes condensed and held
  /// unknowns eliminated (their rows and columns are diagonal).
  template <int dim>
  class TangentMatrix
  {
  public:
    /// Sets up the sparsity pattern; both arguments must outlive this object
    /// or the next call.
    void
    reinit(const DoFHandler<dim>           &dof_handler,
           const AffineConstraints<double> &constraints);

    /// Assembles the tangent that @p solid has stored: a SolidOperator or
    /// LevelOperator. @p held has ones at the held unknowns that this rank
    /// owns, zeros elsewhere.
    template <typename Operator>
    void
    assemble(const Operator &solid, const VectorType &held)
    {
      system_matrix = 0;
      solid.add_matrix(system_matrix, with_held(held));
    }

    const TrilinosWrappers::SparseMatrix &
    matrix() const;

  private:
    /// The constraints and, as homogeneous ones, the held unknowns.
    AffineConstraints<double>
    with_held(const VectorType &held) const;

    const DoFHandler<dim>           *dof_handler = nullptr;
    const AffineConstraints<double> *constraints = nullptr;
    IndexSet                         relevant_dofs;
    TrilinosWrappers::SparseMatrix   system_matrix;
  };
} // namespace ElastoPlastic

#endif
