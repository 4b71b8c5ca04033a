// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mesh_owned_cells_h
#define mesh_owned_cells_h

#include <deal.II/base/index_set.h>
#include <deal.II/base/mpi.h>
#include <deal.II/grid/tria.h>

#include <vector>

namespace ElastoPlastic
{
  using namespace dealii;

  /// The locally owned cells of a mesh, numbered from zero in the order of the
  /// mesh, for data of cells.
  template <int dim>
  class OwnedCells
  {
  public:
    /// All ranks must call this.
    explicit OwnedCells(const Triangulation<dim> &mesh)
      : numbers(mesh.n_active_cells())
      , indices(mesh.n_global_active_cells())
    {
      unsigned int n = 0;
      for (const auto &cell : mesh.active_cell_iterators())
        if (cell->is_locally_owned())
          numbers[cell->active_cell_index()] = n++;
      unsigned int begin = 0;
      const int    ierr  = MPI_Exscan(
        &n, &begin, 1, MPI_UNSIGNED, MPI_SUM, mesh.get_communicator());
      AssertThrowMPI(ierr);
      if (Utilities::MPI::this_mpi_process(mesh.get_communicator()) == 0)
        begin = 0; // which MPI_Exscan leaves undefined
      indices.add_range(begin, begin + n);
    }

    unsigned int
    size() const
    {
      return indices.n_elements();
    }

    /// The number of a locally owned cell.
    template <typename CellAccessor>
    unsigned int
    number(const CellAccessor &cell) const
    {
      return numbers[cell.active_cell_index()];
    }

    /// The same cells in a numbering of all cells of all ranks: rank by rank.
    const IndexSet &
    global_indices() const
    {
      return indices;
    }

  private:
    std::vector<unsigned int> numbers;
    IndexSet                  indices;
  };
} // namespace ElastoPlastic

#endif
