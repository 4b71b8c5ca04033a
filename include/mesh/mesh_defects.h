// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mesh_mesh_defects_h
#define mesh_mesh_defects_h

#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>
#include <deal.II/grid/tria_description.h>

#include <optional>
#include <vector>

namespace ElastoPlastic
{
  using namespace dealii;

  /// A vertex of the coarse mesh @p mesh that lies inside an edge of a cell, if
  /// there is one. Such cells touch each other without having a face in common,
  /// and are not connected.
  template <int dim>
  std::optional<Point<dim>>
  find_hanging_vertex(const Triangulation<dim> &mesh);



  /// The centre of a boundary face of the coarse mesh @p mesh in whose place
  /// there is another one, if there is such a face: the body has a slit, a
  /// crack or parts whose common nodes have been written twice.
  template <int dim>
  std::optional<Point<dim>>
  find_slit(const Triangulation<dim> &mesh);



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
