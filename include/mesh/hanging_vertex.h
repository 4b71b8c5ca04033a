// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mesh_hanging_vertex_h
#define mesh_hanging_vertex_h

#include <deal.II/grid/tria.h>

#include <optional>

namespace ElastoPlastic
{
  using namespace dealii;

  /// A vertex of the coarse mesh @p mesh that lies inside an edge of a cell, if
  /// there is one. Such cells touch each other without having a face in common,
  /// and are not connected.
  template <int dim>
  std::optional<Point<dim>>
  find_hanging_vertex(const Triangulation<dim> &mesh);
} // namespace ElastoPlastic

#endif
