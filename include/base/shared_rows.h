// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef base_shared_rows_h
#define base_shared_rows_h

#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <memory>

namespace ElastoPlastic
{
  using namespace dealii;

  /// The conditions of active unknowns k that share their forces with unknowns
  /// j that are not: sum_j t_kj u_j comes on top of u_k, and of a force f_k on
  /// u_k, u_j takes the part t_kj f_k. Columns of active unknowns count as
  /// zero.
  class SharedRows
  {
  public:
    using Vector = LinearAlgebra::distributed::Vector<double>;
    using Matrix = TrilinosWrappers::SparseMatrix;

    /// t_kj = @p scale_k * @p weights_kj. There are ones in @p active at the
    /// active unknowns, zeros elsewhere.
    SharedRows(const std::shared_ptr<const Matrix> &weights,
               const std::shared_ptr<const Vector> &scale,
               const Vector                        &active);

    /// sum_j t_kj u_j at all unknowns k that have a row, active or not.
    /// Collective.
    Vector
    sums(const Vector &u) const;

    /// sum_k t_kj f_k of the active k, at the unknowns that are not active;
    /// zero elsewhere. Collective.
    Vector
    shares(const Vector &forces) const;

  private:
    std::shared_ptr<const Matrix> weights;
    std::shared_ptr<const Vector> scale;
    Vector                        active;
  };
} // namespace ElastoPlastic

#endif
