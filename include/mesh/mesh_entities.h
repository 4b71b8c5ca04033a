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
    /// Those of all active cells of the serial mesh, or of this rank.
    explicit MeshEntities(const Triangulation<dim> &triangulation);

    /// Halves all cells.
    void
    refine();

    double
    n_cells() const;

    /// The degrees of freedom of FE_Q(@p degree), without those of quadratic
    /// elements on lines and faces that have hanging nodes.
    double
    n_nodes(const unsigned int degree) const;

  private:
    /// By dimension.
    std::array<double, dim + 1> n;
  };
} // namespace ElastoPlastic

#endif
