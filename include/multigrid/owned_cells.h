// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef multigrid_owned_cells_h
#define multigrid_owned_cells_h

#include <deal.II/base/index_set.h>
#include <deal.II/grid/tria.h>

namespace ElastoPlastic
{
  using namespace dealii;

  /// The locally owned cells of a mesh, numbered from zero, for data of cells
  /// that multigrid hands from level to level.
  template <int dim>
  class OwnedCells
  {
  public:
    explicit OwnedCells(const Triangulation<dim> &mesh)
      : cells(mesh.n_global_active_cells())
    {
      types::global_cell_index begin = numbers::invalid_unsigned_int, end = 0;
      for (const auto &cell : mesh.active_cell_iterators())
        if (cell->is_locally_owned())
          {
            begin = std::min(begin, cell->global_active_cell_index());
            end   = std::max(end, cell->global_active_cell_index() + 1);
          }
      if (end > 0)
        cells.add_range(begin, end);
    }

    unsigned int
    size() const
    {
      return cells.n_elements();
    }

    /// The number of a locally owned cell.
    template <typename CellAccessor>
    unsigned int
    index(const CellAccessor &cell) const
    {
      return cells.index_within_set(cell.global_active_cell_index());
    }

    /// The same cells in the numbering of all cells of all ranks.
    const IndexSet &
    global_indices() const
    {
      return cells;
    }

  private:
    IndexSet cells;
  };
} // namespace ElastoPlastic

#endif
