// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef solver_tangent_operator_h
#define solver_tangent_operator_h

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

namespace ElastoPlastic
{
  using namespace dealii;

  using VectorType = LinearAlgebra::distributed::Vector<double>;

  /// A stored tangent, as the linear solvers want to see it: all unknowns are
  /// free, but for eliminated ones (hanging nodes, skew rollers).
  class TangentOperator
  {
  public:
    virtual ~TangentOperator() = default;

    virtual bool
    is_symmetric() const = 0;

    virtual void
    initialize_vector(VectorType &vector) const = 0;

    /// The product with @p increment, which need not have ghost values;
    /// condensed. Collective.
    virtual void
    vmult(VectorType &forces, const VectorType &increment) const = 0;

    /// Adds the tangent to @p matrix, condensed with @p all_constraints, which
    /// contain at least its own. Collective.
    virtual void
    add_matrix(TrilinosWrappers::SparseMatrix  &matrix,
               const AffineConstraints<double> &all_constraints) const = 0;
  };
} // namespace ElastoPlastic

#endif
