// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mesh_mesh_entities_h
#define mesh_mesh_entities_h

#include <deal.II/grid/tria.h>

#include <array>

namespace ElastoPlastic
{
  using namespace dealii;

  /// How many vertices, lines, quadrilaterals and hexahedra a mesh has, from
  /// which follows how many those have that are made from it by halving all
  /// cells, without making them.
  template <int dim>
  class MeshEntities
  {
  public:
    /// Counts those of all active cells of the serial mesh, or of this rank.
    explicit MeshEntities(const Triangulation<dim> &triangulation)
    {
      n[0]       = triangulation.n_used_vertices();
      n[1]       = triangulation.n_active_lines();
      n[dim - 1] = triangulation.n_active_faces();
      n[dim]     = triangulation.n_active_cells();
    }

    /// Halves all cells. Each entity gets a vertex in its middle; those within
    /// a quadrilateral and a hexahedron are joined with 4 and 6 others.
    void
    refine()
    {
      if constexpr (dim == 2)
        {
          const auto [vertices, lines, quads] = n;
          n = {{vertices + lines + quads, 2 * lines + 4 * quads, 4 * quads}};
        }
      else
        {
          const auto [vertices, lines, quads, hexes] = n;
          n = {{vertices + lines + quads + hexes,
                2 * lines + 4 * quads + 6 * hexes,
                4 * quads + 12 * hexes,
                8 * hexes}};
        }
    }

    double
    n_cells() const
    {
      return n[dim];
    }

    /// The degrees of freedom of FE_Q(@p degree), without those of quadratic
    /// elements on lines and faces that have hanging nodes.
    double
    n_nodes(const unsigned int degree) const
    {
      double sum = 0, nodes_within = 1;
      for (const double n_of_dimension : n)
        {
          sum += n_of_dimension * nodes_within;
          nodes_within *= degree - 1;
        }
      return sum;
    }

  private:
    /// The numbers by dimension.
    std::array<double, dim + 1> n;
  };
} // namespace ElastoPlastic

#endif
