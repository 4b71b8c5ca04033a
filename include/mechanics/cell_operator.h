// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_cell_operator_h
#define mechanics_cell_operator_h

#include <deal.II/base/aligned_vector.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include "mechanics/stress_integration.h"

namespace ElastoPlastic
{
  /// Applies a linear cell kernel: @p integrate(phi) turns the dof values of a
  /// cell batch into nodal forces.
  template <int degree,
            int dim,
            typename Number,
            typename Kernel,
            typename Vector>
  void
  apply_cells(const MatrixFree<dim, Number, Simd<Number>> &matrix_free,
              const Kernel                                &integrate,
              Vector                                      &result,
              const Vector                                &vector)
  {
    matrix_free.template cell_loop<Vector, Vector>(
      [&](const auto &, auto &dst, const auto &src, const auto &range) {
        DisplacementEvaluation<dim, degree, Number> phi(matrix_free);
        for (unsigned int batch = range.first; batch < range.second; ++batch)
          {
            phi.reinit(batch);
            phi.read_dof_values(src);
            integrate(phi);
            phi.distribute_local_to_global(dst);
          }
      },
      result,
      vector,
      /* zero_dst_vector = */ true);
  }



  /// Adds the matrix of a linear cell kernel to @p matrix, condensed with
  /// @p constraints. The columns of the cell matrices are what
  /// @p integrate(phi), see apply_cells(), makes of unit vectors.
  ///
  /// (MatrixFreeTools::compute_matrix() of deal.II 9.4 takes the categories of
  /// cells for indices of finite elements.)
  template <int degree, int dim, typename Number, typename Kernel>
  void
  add_cell_matrices(const MatrixFree<dim, Number, Simd<Number>> &matrix_free,
                    const Kernel                                &integrate,
                    const AffineConstraints<double>             &constraints,
                    TrilinosWrappers::SparseMatrix              &matrix)
  {
    DisplacementEvaluation<dim, degree, Number> phi(matrix_free);
    constexpr unsigned int                      n = phi.static_dofs_per_cell;
    FullMatrix<double>                          cell_matrix(n, n);
    std::vector<types::global_dof_index>        dofs(n);
    AlignedVector<Simd<Number>>                 columns(n * n);
    const auto                                 &numbering =
      matrix_free.get_shape_info().lexicographic_numbering;
    for (unsigned int batch = 0; batch < matrix_free.n_cell_batches(); ++batch)
      {
        phi.reinit(batch);
        for (unsigned int j = 0; j < n; ++j)
          {
            std::fill_n(phi.begin_dof_values(), n, Simd<Number>(0.));
            phi.begin_dof_values()[j] = Number(1.);
            integrate(phi);
            std::copy_n(phi.begin_dof_values(), n, &columns[j * n]);
          }
        for (unsigned int lane = 0;
             lane < matrix_free.n_active_entries_per_cell_batch(batch);
             ++lane)
          {
            for (unsigned int i = 0; i < n; ++i)
              for (unsigned int j = 0; j < n; ++j)
                cell_matrix(numbering[i], numbering[j]) =
                  columns[j * n + i][lane];
            const typename DoFHandler<dim>::active_cell_iterator cell =
              matrix_free.get_cell_iterator(batch, lane);
            cell->get_dof_indices(dofs);
            constraints.distribute_local_to_global(cell_matrix, dofs, matrix);
          }
      }
    matrix.compress(VectorOperation::add);
  }
} // namespace ElastoPlastic

#endif
