// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_mesh_split_mesh_h
#define bounds_mesh_split_mesh_h

#include <deal.II/grid/cell_id.h>
#include <deal.II/grid/tria.h>

#include <algorithm>
#include <string>
#include <vector>

#include "bounds/mesh/simplex.h"

namespace ElastoPlastic
{
  /// The conforming mesh of simplices that results when the centre of every
  /// quadrilateral of an adaptively refined mesh is joined to its corners and
  /// to the hanging nodes on its sides. Stresses are equilibrated on the same
  /// mesh, with the same boundaries, as displacements are computed.
  ///
  ///     +-------+-------+
  ///     |\     /|\  |  /|
  ///     |  \ /  | \ | / |   left: a quadrilateral without hanging nodes,
  ///     |  / \  |  \|/  |   right: one with two, in the middle of its
  ///     |/     \|  /|\  |   upper and lower side
  ///     +-------+-------+
  ///
  /// In space, the faces of a hexahedron are cut in this way, those that are
  /// refined on the other side as the finer faces are, and what results is
  /// joined to the centre of the hexahedron. Without hanging nodes it becomes
  /// 24 tetrahedra.
  template <int dim>
  struct SplitMesh
  {
    /// The corners of a tetrahedron are in the order of their numbers; the last
    /// of a triangle is the centre of the quadrilateral. For faces and edges
    /// see corner_of_face() and ends_of_edge().
    struct Simplex
    {
      std::array<unsigned int, dim + 1>                vertices;
      std::array<unsigned int, dim + 1>                faces;
      std::array<unsigned int, edges_per_simplex<dim>> edges;
      unsigned int                                     cell; ///< see cells
      /// Where the corners are in the unit cell of the quadrilateral or
      /// hexahedron.
      Corners<dim> unit_corners;

      /// Which of the corners or faces has this number.
      unsigned int
      place_of_vertex(const unsigned int vertex) const
      {
        return std::find(vertices.begin(), vertices.end(), vertex) -
               vertices.begin();
      }
      unsigned int
      place_of_face(const unsigned int face) const
      {
        return std::find(faces.begin(), faces.end(), face) - faces.begin();
      }
    };

    /// A side has the direction of the first of its neighbours, which lies to
    /// its left; the corners of a triangle are in the order of their numbers.
    struct Face
    {
      std::array<unsigned int, dim> vertices;
      /// numbers::internal_face_boundary_id between two simplices
      types::boundary_id boundary_id;
      /// The second is invalid at the boundary.
      std::array<unsigned int, 2> neighbors;

      bool
      is_inside() const
      {
        return boundary_id == numbers::internal_face_boundary_id;
      }

      /// One, or two inside of the body.
      unsigned int
      n_neighbors() const
      {
        return is_inside() ? 2 : 1;
      }
    };

    /// An active cell of the mesh of quadrilaterals or hexahedra.
    struct Cell
    {
      CellId             id;
      types::material_id material_id;
    };

    std::vector<Point<dim>> vertices;
    std::vector<Simplex>    simplices;
    std::vector<Face>       faces;
    unsigned int            n_edges = 0;
    std::vector<Cell>       cells;

    Corners<dim>
    corners(const Simplex &simplex) const
    {
      Corners<dim> result;
      for (unsigned int i = 0; i <= dim; ++i)
        result[i] = vertices[simplex.vertices[i]];
      return result;
    }

    FaceCorners<dim>
    corners(const Face &face) const
    {
      FaceCorners<dim> result;
      for (unsigned int i = 0; i < dim; ++i)
        result[i] = vertices[face.vertices[i]];
      return result;
    }

    /// Where the corners of face @p k of a simplex, in the order of the face
    /// itself, are in part k of the simplex.
    std::array<unsigned int, dim>
    places_in_part(const unsigned int simplex, const unsigned int k) const;

    /// The largest distance of a vertex from the first one: with it, body
    /// forces are as large as the stresses that they cause.
    double
    size() const;
  };



  /// Splits the active cells of @p triangulation. Everything is gathered on the
  /// first rank, in an order that does not depend on the partition; the mesh
  /// of the others is empty. Collective.
  template <int dim>
  SplitMesh<dim>
  make_split_mesh(const Triangulation<dim> &triangulation);

  /// That such a mesh is not the body; empty if the boundary is not curved.
  template <int dim>
  std::string
  warning_of_curved_body(const Triangulation<dim> &triangulation);

} // namespace ElastoPlastic

#endif
