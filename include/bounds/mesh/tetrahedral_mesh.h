// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_mesh_tetrahedral_mesh_h
#define bounds_mesh_tetrahedral_mesh_h

#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>

#include <array>
#include <vector>

#include "bounds/mesh/split_mesh.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// The corners of a tetrahedron or of one of its faces.
  using Tetrahedron  = std::array<Point<3>, 4>;
  using TriangleFace = std::array<Point<3>, 3>;

  /// The conforming tetrahedra into which the hexahedra of an adaptively
  /// refined mesh are split, like the quadrilaterals of a SplitMesh: faces are
  /// cut from their centres to their corners and to the hanging nodes on their
  /// edges, those that are refined on the other side as the finer faces are;
  /// and what results is joined to the centre of the hexahedron. A hexahedron
  /// without hanging nodes becomes 24 tetrahedra.
  struct TetrahedralMesh
  {
    /// Its corners, in the order of their numbers. Face k is opposite to corner
    /// k; its corners are the other three.
    struct Simplex
    {
      std::array<unsigned int, 4> vertices;
      std::array<unsigned int, 4> faces;
      std::array<unsigned int, 6> edges; ///< see edge_between()
      unsigned int                cell;  ///< the hexahedron, see cells
      /// Where the corners are in the unit cell of the hexahedron.
      std::array<Point<3>, 4> unit_corners;
    };

    /// Which edge of a tetrahedron joins its corners i < j: the edges are those
    /// from 0 to 1, 2, 3, from 1 to 2, 3, and from 2 to 3.
    static constexpr unsigned int
    edge_between(const unsigned int i, const unsigned int j)
    {
      return i == 0 ? j - 1 : i + j;
    }

    /// Of one or two tetrahedra; its corners are in the order of their numbers.
    struct Face
    {
      std::array<unsigned int, 3> vertices;
      /// numbers::internal_face_boundary_id between two tetrahedra
      types::boundary_id boundary_id;
      /// The second is invalid at the boundary.
      std::array<unsigned int, 2> neighbors;

      bool
      is_inside() const
      {
        return boundary_id == numbers::internal_face_boundary_id;
      }
    };

    std::vector<Point<3>>        vertices;
    std::vector<Simplex>         tetrahedra;
    std::vector<Face>            faces;
    unsigned int                 n_edges = 0;
    std::vector<SplitMesh::Cell> cells;

    Tetrahedron
    corners(const Simplex &tetrahedron) const;

    TriangleFace
    corners(const Face &face) const;
  };



  inline const std::vector<TetrahedralMesh::Simplex> &
  simplices_of(const TetrahedralMesh &mesh)
  {
    return mesh.tetrahedra;
  }



  /// Always positive.
  double
  volume(const Tetrahedron &corners);

  double
  area(const TriangleFace &corners);

  /// A unit vector; its sign depends on the order of the corners.
  Tensor<1, 3>
  normal(const TriangleFace &corners);

  /// Two unit vectors at right angles to each other and to the normal.
  std::array<Tensor<1, 3>, 2>
  tangents(const TriangleFace &corners);

  /// The gradients of the linear functions that are 1 at one corner and 0 at
  /// the others: they point away from the opposite faces.
  std::array<Tensor<1, 3>, 4>
  gradients(const Tetrahedron &corners);

  /// The corner of a tetrahedron that is corner @p i of its face @p k.
  constexpr unsigned int
  corner_of_face(const unsigned int k, const unsigned int i)
  {
    return i < k ? i : i + 1;
  }

  /// The unit normal of face @p k that points out of the tetrahedron.
  Tensor<1, 3>
  outward_normal(const Tetrahedron &corners, const unsigned int k);



  /// Splits the active cells of @p triangulation. Everything is gathered on the
  /// first rank, in an order that does not depend on the partition; the mesh
  /// of the others is empty.
  TetrahedralMesh
  make_split_mesh(const Triangulation<3> &triangulation);
} // namespace ElastoPlastic

#endif
