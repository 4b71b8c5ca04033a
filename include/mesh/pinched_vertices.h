// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mesh_pinched_vertices_h
#define mesh_pinched_vertices_h

#include <deal.II/base/point.h>
#include <deal.II/grid/tria_description.h>

#include <vector>

namespace ElastoPlastic
{
  using namespace dealii;

  /// Cells that meet at a corner or an edge only are not connected: a
  /// continuum passes no force there. Each group of cells around a vertex that
  /// are connected through faces with that vertex gets a vertex of its own, in
  /// the same place; the first group keeps the old one. New ones are appended
  /// to @p vertices.
  /// @return for each vertex the number of the one that it was made of, or its
  /// own.
  template <int dim>
  std::vector<unsigned int>
  separate_pinched_vertices(std::vector<Point<dim>>    &vertices,
                            std::vector<CellData<dim>> &cells);
} // namespace ElastoPlastic

#endif
