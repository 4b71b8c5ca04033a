// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mesh_gmsh_coarse_mesh_h
#define mesh_gmsh_coarse_mesh_h

#include <deal.II/grid/tria.h>

#include <map>
#include <vector>

#include "mesh/gmsh_contents.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// The cells of a mesh file and the nodes that they use, as deal.II wants
  /// them. Cells that meet at a corner or an edge only are not connected (see
  /// separate_pinched_vertices()).
  template <int dim>
  class GmshCoarseMesh
  {
  public:
    /// Gmsh's types of elements of first order.
    static constexpr unsigned int quadrilateral = 3, hexahedron = 5;
    static constexpr unsigned int cell_type =
      (dim == 2 ? quadrilateral : hexahedron);
    static constexpr unsigned int face_type = (dim == 2 ? 1 : quadrilateral);

    /// The material id of a cell is the number of its physical group.
    /// @p contents must live as long as this object.
    /// @throws InputError for cells that are distorted or overlap.
    explicit GmshCoarseMesh(const GmshContents &contents);

    /// Fill the empty @p triangulation.
    /// @throws InputError for cells that do not fit together.
    void
    create(Triangulation<dim> &triangulation);

    /// Numbers of vertices in increasing order, by which a face or a cell can
    /// be recognised.
    using Vertices = std::vector<unsigned int>;

    /// The vertices of the nodes with these indices.
    Vertices
    vertices_of(const std::vector<unsigned int> &nodes) const;

    /// The vertices of a face of the mesh that create() has made.
    Vertices
    vertices_of(const typename Triangulation<dim>::face_iterator &face) const;

  private:
    void
    add_cell(const GmshContents::Element &element);

    void
    check_shapes() const;

    void
    check_neighbours() const;

    const GmshContents                  &contents;
    std::map<unsigned int, unsigned int> vertex_of_node;
    std::vector<Point<dim>>              vertices;
    std::vector<CellData<dim>>           cells;
    std::vector<unsigned int> original_vertices; ///< those of the nodes
  };
} // namespace ElastoPlastic

#endif
