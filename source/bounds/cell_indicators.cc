// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <boost/serialization/map.hpp>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/compatibility.h"
#include "bounds/cell_indicators.h"

namespace ElastoPlastic
{
  namespace
  {
    /// @p simplices are those of the @p cells.
    template <int dim, typename Simplex>
    Vector<float>
    root_of_sums(const std::vector<SplitMesh::Cell> &cells,
                 const std::vector<Simplex>         &simplices,
                 const std::vector<double>          &of_simplices,
                 const Triangulation<dim>           &triangulation)
    {
      std::map<CellId, double> of_cell;
      for (unsigned int t = 0; t < of_simplices.size(); ++t)
        of_cell[cells[simplices[t].cell].id] += std::max(0., of_simplices[t]);
      of_cell =
        Utilities::MPI::broadcast(communicator_of(triangulation), of_cell);

      Vector<float> indicators(triangulation.n_active_cells());
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned())
          indicators[cell->active_cell_index()] =
            std::sqrt(of_cell.at(cell->id()));
      return indicators;
    }
  } // namespace



  Vector<float>
  cell_indicators(const SplitMesh           &mesh,
                  const std::vector<double> &of_triangles,
                  const Triangulation<2>    &triangulation)
  {
    return root_of_sums(mesh.cells,
                        mesh.triangles,
                        of_triangles,
                        triangulation);
  }



  Vector<float>
  cell_indicators(const TetrahedralMesh     &mesh,
                  const std::vector<double> &of_tetrahedra,
                  const Triangulation<3>    &triangulation)
  {
    return root_of_sums(mesh.cells,
                        mesh.tetrahedra,
                        of_tetrahedra,
                        triangulation);
  }
} // namespace ElastoPlastic
