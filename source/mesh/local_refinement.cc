// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <sstream>

#include "base/compatibility.h"
#include "base/exceptions.h"
#include "base/process.h"
#include "mesh/local_refinement.h"

namespace ElastoPlastic
{
  namespace
  {
    /// As long as the ball of local refinement holds the whole mesh, all cells
    /// are refined, so that this many are known before any is. Collective.
    template <int dim>
    double
    n_cells_of_global_part(const GeometryParameters &parameters,
                           const Point<dim>         &centre,
                           const Triangulation<dim> &mesh)
    {
      double reach = 0;
      for (const Point<dim> &vertex : mesh.get_vertices())
        reach = std::max(reach, centre.distance(vertex));
      reach = Utilities::MPI::max(reach, communicator_of(mesh));

      const double n_times =
        std::clamp(std::ceil(std::log2(parameters.local_radius / reach)),
                   0.,
                   static_cast<double>(parameters.local_refinements));
      return mesh.n_global_active_cells() * std::pow(2., dim * n_times);
    }
  } // namespace



  double
  max_n_cells(const MPI_Comm communicator)
  {
    return std::min(1e8, machine_memory(communicator) / 2048);
  }



  void
  check_n_cells(const std::string &path,
                const unsigned int value,
                const double       n_cells,
                const double       max_n_cells)
  {
    if (n_cells <= max_n_cells)
      return;
    std::ostringstream remedy;
    remedy.precision(3);
    remedy << "the mesh would have " << n_cells << " cells or more. At most "
           << max_n_cells << " are possible here.";
    throw InputError(path, std::to_string(value), remedy.str());
  }



  // A cell is as near to a point as the nearest point of the ball around it.
  template <int dim>
  void
  refine_locally(const GeometryParameters &parameters,
                 const double              max_n_cells,
                 Triangulation<dim>       &triangulation)
  {
    Point<dim> centre;
    for (unsigned int d = 0; d < parameters.local_centre.size(); ++d)
      centre[d] = parameters.local_centre[d];
    check_n_cells("Geometry/Local refinements",
                  parameters.local_refinements,
                  n_cells_of_global_part(parameters, centre, triangulation),
                  max_n_cells);
    constexpr unsigned int n_new_cells =
      GeometryInfo<dim>::max_children_per_cell - 1;
    double radius = parameters.local_radius;
    for (unsigned int i = 0; i < parameters.local_refinements; ++i)
      {
        types::global_cell_index n_flagged = 0;
        for (const auto &cell : triangulation.active_cell_iterators())
          if (cell->is_locally_owned() &&
              cell->center().distance(centre) - 0.5 * cell->diameter() < radius)
            {
              cell->set_refine_flag();
              ++n_flagged;
            }
        check_n_cells("Geometry/Local refinements",
                      parameters.local_refinements,
                      triangulation.n_global_active_cells() +
                        n_new_cells *
                          Utilities::MPI::sum(n_flagged,
                                              communicator_of(triangulation)),
                      max_n_cells);
        triangulation.execute_coarsening_and_refinement();
        radius *= 0.5;
      }
  }



  template void
  refine_locally(const GeometryParameters &, const double, Triangulation<2> &);
  template void
  refine_locally(const GeometryParameters &, const double, Triangulation<3> &);
} // namespace ElastoPlastic
