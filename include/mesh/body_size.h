// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mesh_body_size_h
#define mesh_body_size_h

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <limits>
#include <set>

#include "base/compatibility.h"
#include "mesh/boundary_faces.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// The largest side of the box around the coarse mesh, which all ranks know.
  template <int dim>
  double
  body_size(const parallel::distributed::Triangulation<dim> &triangulation)
  {
    const BoundingBox<dim> box(triangulation.get_vertices());
    double                 size = 0;
    for (unsigned int d = 0; d < dim; ++d)
      size = std::max(size, box.side_length(d));
    return size;
  }



  /// From the lowest point of the body to the highest one. Collective.
  template <int dim>
  double
  body_height(const Triangulation<dim> &triangulation)
  {
    const auto [lower, upper] =
      GridTools::compute_bounding_box(triangulation).get_boundary_points();
    const MPI_Comm communicator = communicator_of(triangulation);
    return Utilities::MPI::max(upper[dim - 1], communicator) -
           Utilities::MPI::min(lower[dim - 1], communicator);
  }



  /// The lowest and the highest point of the given @p boundaries, on all ranks.
  template <int dim>
  std::pair<double, double>
  range_of_heights(
    const parallel::distributed::Triangulation<dim> &triangulation,
    const std::set<types::boundary_id>              &boundaries)
  {
    double lowest  = std::numeric_limits<double>::max();
    double highest = std::numeric_limits<double>::lowest();
    for (const auto &[cell, f] : owned_faces(triangulation, boundaries))
      for (const unsigned int v : cell->face(f)->vertex_indices())
        {
          const double height = cell->face(f)->vertex(v)[dim - 1];
          lowest              = std::min(lowest, height);
          highest             = std::max(highest, height);
        }
    return {Utilities::MPI::min(lowest, communicator_of(triangulation)),
            Utilities::MPI::max(highest, communicator_of(triangulation))};
  }



  /// Whether all points of the given @p boundaries are at one height, on all
  /// ranks.
  template <int dim>
  bool
  are_level(const parallel::distributed::Triangulation<dim> &triangulation,
            const std::set<types::boundary_id>              &boundaries)
  {
    const auto [lowest, highest] = range_of_heights(triangulation, boundaries);
    return highest - lowest <= 1e-10 * body_size(triangulation);
  }
} // namespace ElastoPlastic

#endif
