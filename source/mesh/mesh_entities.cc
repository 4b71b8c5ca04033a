// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "mesh/mesh_entities.h"

namespace ElastoPlastic
{
  template <>
  MeshEntities<2>::MeshEntities(const Triangulation<2> &triangulation)
    : n{{1. * triangulation.n_used_vertices(),
         1. * triangulation.n_active_lines(),
         1. * triangulation.n_active_cells()}}
  {}



  template <>
  MeshEntities<3>::MeshEntities(const Triangulation<3> &triangulation)
    : n{{1. * triangulation.n_used_vertices(),
         1. * triangulation.n_active_lines(),
         1. * triangulation.n_active_quads(),
         1. * triangulation.n_active_cells()}}
  {}



  // Each entity gets a vertex in its middle; those within a quadrilateral and
  // a hexahedron are joined with 4 and 6 others.
  template <>
  void
  MeshEntities<2>::refine()
  {
    const auto [vertices, lines, quads] = n;
    n = {{vertices + lines + quads, 2 * lines + 4 * quads, 4 * quads}};
  }



  template <>
  void
  MeshEntities<3>::refine()
  {
    const auto [vertices, lines, quads, hexes] = n;
    n = {{vertices + lines + quads + hexes,
          2 * lines + 4 * quads + 6 * hexes,
          4 * quads + 12 * hexes,
          8 * hexes}};
  }



  template <int dim>
  double
  MeshEntities<dim>::n_cells() const
  {
    return n[dim];
  }



  template <int dim>
  double
  MeshEntities<dim>::n_nodes(const unsigned int degree) const
  {
    double sum = 0, nodes_within = 1;
    for (const double n_of_dimension : n)
      {
        sum += n_of_dimension * nodes_within;
        nodes_within *= degree - 1;
      }
    return sum;
  }



  template class MeshEntities<2>;
  template class MeshEntities<3>;
} // namespace ElastoPlastic
