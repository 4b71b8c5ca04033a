// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_mesh_split_mesh_h
#define bounds_mesh_split_mesh_h

#include <deal.II/base/point.h>
#include <deal.II/grid/cell_id.h>
#include <deal.II/grid/tria.h>

#include <array>
#include <vector>

namespace ElastoPlastic
{
  using namespace dealii;

  /// The conforming triangulation that results when the centre of every
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
  struct SplitMesh
  {
    /// Its corners, in positive orientation; the last is the centre of the
    /// quadrilateral. Side k joins the corners k and k + 1 (modulo 3).
    struct Triangle
    {
      std::array<unsigned int, 3> vertices;
      std::array<unsigned int, 3> sides;
      unsigned int                cell; ///< the quadrilateral, see cells
      /// Where the corners are in the unit cell of the quadrilateral.
      std::array<Point<2>, 3> unit_corners;
    };

    /// A side, in the direction of the first of its one or two triangles,
    /// which lies to its left.
    struct Side
    {
      std::array<unsigned int, 2> vertices;
      /// numbers::internal_face_boundary_id between two triangles
      types::boundary_id boundary_id;
    };

    /// An active cell of the mesh of quadrilaterals.
    struct Cell
    {
      CellId             id;
      types::material_id material_id;
    };

    std::vector<Point<2>> vertices;
    std::vector<Triangle> triangles;
    std::vector<Side>     sides;
    std::vector<Cell>     cells;

    std::array<Point<2>, 3>
    corners(const Triangle &triangle) const;

    double
    length(const Side &side) const;

    /// To the right of the direction of the side: out of its first triangle.
    Tensor<1, 2>
    normal(const Side &side) const;
  };



  inline const std::vector<SplitMesh::Triangle> &
  simplices_of(const SplitMesh &mesh)
  {
    return mesh.triangles;
  }



  /// Twice the signed area is the cross product of two sides.
  double
  area(const std::array<Point<2>, 3> &corners);



  /// Splits the active cells of @p triangulation. Everything is gathered on the
  /// first rank, in an order that does not depend on the partition; the mesh
  /// of the others is empty.
  SplitMesh
  make_split_mesh(const Triangulation<2> &triangulation);
} // namespace ElastoPlastic

#endif
