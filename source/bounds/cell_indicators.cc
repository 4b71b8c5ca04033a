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
  template <int dim>
  Vector<float>
  cell_indicators(const SplitMesh<dim>      &mesh,
                  const std::vector<double> &of_simplices,
                  const Triangulation<dim>  &triangulation)
  {
    std::map<CellId, double> of_cell;
    for (unsigned int t = 0; t < of_simplices.size(); ++t)
      of_cell[mesh.cells[mesh.simplices[t].cell].id] +=
        std::max(0., of_simplices[t]);
    of_cell =
      Utilities::MPI::broadcast(communicator_of(triangulation), of_cell);

    Vector<float> indicators(triangulation.n_active_cells());
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        indicators[cell->active_cell_index()] =
          std::sqrt(of_cell.at(cell->id()));
    return indicators;
  }



  template Vector<float>
  cell_indicators(const SplitMesh<2> &,
                  const std::vector<double> &,
                  const Triangulation<2> &);
  template Vector<float>
  cell_indicators(const SplitMesh<3> &,
                  const std::vector<double> &,
                  const Triangulation<3> &);
} // namespace ElastoPlastic
