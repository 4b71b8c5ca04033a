// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mesh_owned_cells_h
#define mesh_owned_cells_h

#include <deal.II/base/partitioner.h>
#include <deal.II/distributed/tria_base.h>

#include <memory>

namespace ElastoPlastic
{
  using namespace dealii;

  /// The locally owned cells of a distributed mesh, numbered from zero in the
  /// order of the mesh, for data of cells: deal.II's partition of the active
  /// cells.
  template <int dim>
  class OwnedCells
  {
  public:
    /// The numbering is that of @p mesh as it is now.
    explicit OwnedCells(const Triangulation<dim> &mesh)
      : partition(dynamic_cast<const parallel::TriangulationBase<dim> &>(mesh)
                    .global_active_cell_index_partitioner()
                    .lock())
    {}

    unsigned int
    size() const
    {
      return partition->locally_owned_size();
    }

    /// The number of a locally owned cell.
    template <typename CellAccessor>
    unsigned int
    number(const CellAccessor &cell) const
    {
      return partition->global_to_local(cell.global_active_cell_index());
    }

    /// The same cells in a numbering of all cells of all ranks: rank by rank.
    const IndexSet &
    global_indices() const
    {
      return partition->locally_owned_range();
    }

  private:
    std::shared_ptr<const Utilities::MPI::Partitioner> partition;
  };
} // namespace ElastoPlastic

#endif
