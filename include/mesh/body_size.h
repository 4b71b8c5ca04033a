// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mesh_body_size_h
#define mesh_body_size_h

#include <deal.II/distributed/tria.h>

#include <algorithm>

namespace ElastoPlastic
{
  using namespace dealii;

  /// The largest side of the box around the coarse mesh, which all ranks know.
  template <int dim>
  double
  body_size(const parallel::distributed::Triangulation<dim> &triangulation)
  {
    Point<dim> lower = triangulation.get_vertices()[0], upper = lower;
    for (const Point<dim> &vertex : triangulation.get_vertices())
      for (unsigned int d = 0; d < dim; ++d)
        {
          lower[d] = std::min(lower[d], vertex[d]);
          upper[d] = std::max(upper[d], vertex[d]);
        }
    double size = 0;
    for (unsigned int d = 0; d < dim; ++d)
      size = std::max(size, upper[d] - lower[d]);
    return size;
  }
} // namespace ElastoPlastic

#endif
