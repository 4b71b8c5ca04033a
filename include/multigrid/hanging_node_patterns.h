// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef multigrid_hanging_node_patterns_h
#define multigrid_hanging_node_patterns_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>

namespace ElastoPlastic
{
  using namespace dealii;

  /// For each active cell, a bit for each of its vertices that is constrained.
  ///
  /// A hanging node makes work for the whole batch of cells that it is in; with
  /// these numbers as MatrixFree's cell_vectorization_category, cells that have
  /// the same pattern of hanging nodes form batches of their own.
  template <int dim>
  std::vector<unsigned int>
  hanging_node_patterns(const DoFHandler<dim>           &dof_handler,
                        const AffineConstraints<double> &constraints)
  {
    std::vector<unsigned int> patterns(
      dof_handler.get_triangulation().n_active_cells(), 0);
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int v : cell->vertex_indices())
          if (constraints.is_constrained(cell->vertex_dof_index(v, 0)))
            patterns[cell->active_cell_index()] |= 1 << v;
    return patterns;
  }
} // namespace ElastoPlastic

#endif
