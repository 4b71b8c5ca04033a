// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>

#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <map>
#include <utility>

#include "base/compatibility.h"
#include "bounds/mesh/split_mesh.h"

namespace ElastoPlastic
{
  namespace
  {
    /// A point of the boundary of a quadrilateral, with the boundary that
    /// begins there.
    struct Corner
    {
      types::global_dof_index number; ///< the same for all cells around it
      Point<2>                position;
      Point<2>                unit_position;
      types::boundary_id      boundary_id;

      template <typename Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &number &position &unit_position &boundary_id;
      }
    };

    /// A quadrilateral with its corners and hanging nodes, in positive
    /// orientation.
    struct Polygon
    {
      CellId              id;
      types::material_id  material_id;
      Point<2>            center;
      std::vector<Corner> corners;

      template <typename Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &id &material_id &center &corners;
      }
    };



    // deal.II numbers vertices and faces lexicographically: around the cell,
    // one passes the vertices 0, 1, 3, 2 and the faces 2 (below), 1, 3, 0.
    Polygon
    polygon_of(const DoFHandler<2>::active_cell_iterator &cell)
    {
      constexpr std::array<unsigned int, 4> vertices = {{0, 1, 3, 2}};
      constexpr std::array<unsigned int, 4> faces    = {{2, 1, 3, 0}};
      const auto unit_vertex = [&vertices](const unsigned int i) {
        return ReferenceCells::Quadrilateral.template vertex<2>(vertices[i]);
      };

      Polygon polygon;
      polygon.id          = cell->id();
      polygon.material_id = cell->material_id();
      polygon.center      = cell->center();
      for (unsigned int i = 0; i < 4; ++i)
        {
          const auto face = cell->face(faces[i]);
          polygon.corners.push_back({cell->vertex_dof_index(vertices[i], 0),
                                     cell->vertex(vertices[i]),
                                     unit_vertex(i),
                                     face->boundary_id()});
          if (face->has_children())
            polygon.corners.push_back(
              {face->child(0)->vertex_dof_index(1, 0),
               face->child(0)->vertex(1),
               unit_vertex(i) +
                 0.5 * (unit_vertex((i + 1) % 4) - unit_vertex(i)),
               face->boundary_id()});
        }
      return polygon;
    }



    /// Of all ranks, on the first of them.
    std::vector<Polygon>
    gather_polygons(const Triangulation<2> &triangulation)
    {
      const FE_Q<2> fe(1);
      DoFHandler<2> dof_handler(triangulation);
      dof_handler.distribute_dofs(fe);

      std::vector<Polygon> own;
      for (const auto &cell : dof_handler.active_cell_iterators())
        if (cell->is_locally_owned())
          own.push_back(polygon_of(cell));

      std::vector<Polygon> all;
      for (const auto &polygons :
           Utilities::MPI::gather(communicator_of(triangulation), own))
        all.insert(all.end(), polygons.begin(), polygons.end());
      std::sort(all.begin(), all.end(), [](const auto &a, const auto &b) {
        return a.id < b.id;
      });
      return all;
    }



    /// Puts triangles together, one after the other.
    class Assembler
    {
    public:
      void
      add(const Polygon &polygon)
      {
        mesh.cells.push_back({polygon.id, polygon.material_id});
        const unsigned int center = mesh.vertices.size();
        mesh.vertices.push_back(polygon.center);

        for (unsigned int i = 0; i < polygon.corners.size(); ++i)
          {
            const Corner &first = polygon.corners[i];
            const Corner &last =
              polygon.corners[(i + 1) % polygon.corners.size()];
            const unsigned int a = vertex(first), b = vertex(last);

            SplitMesh::Triangle triangle;
            triangle.vertices = {{a, b, center}};
            triangle.sides    = {
                 {side(a, b, first.boundary_id),
                  side(b, center, numbers::internal_face_boundary_id),
                  side(center, a, numbers::internal_face_boundary_id)}};
            triangle.cell         = mesh.cells.size() - 1;
            triangle.unit_corners = {
              {first.unit_position, last.unit_position, Point<2>(0.5, 0.5)}};
            mesh.triangles.push_back(triangle);
          }
      }

      SplitMesh mesh;

    private:
      unsigned int
      vertex(const Corner &corner)
      {
        const auto [entry, is_new] =
          vertex_numbers.try_emplace(corner.number, mesh.vertices.size());
        if (is_new)
          mesh.vertices.push_back(corner.position);
        return entry->second;
      }

      unsigned int
      side(const unsigned int       a,
           const unsigned int       b,
           const types::boundary_id boundary_id)
      {
        const auto [entry, is_new] =
          side_numbers.try_emplace(std::minmax(a, b), mesh.sides.size());
        if (is_new)
          mesh.sides.push_back({{{a, b}}, boundary_id});
        return entry->second;
      }

      std::map<types::global_dof_index, unsigned int> vertex_numbers;
      std::map<std::pair<unsigned int, unsigned int>, unsigned int>
        side_numbers;
    };
  } // namespace



  std::array<Point<2>, 3>
  SplitMesh::corners(const Triangle &triangle) const
  {
    return {{vertices[triangle.vertices[0]],
             vertices[triangle.vertices[1]],
             vertices[triangle.vertices[2]]}};
  }



  double
  SplitMesh::length(const Side &side) const
  {
    return vertices[side.vertices[0]].distance(vertices[side.vertices[1]]);
  }



  Tensor<1, 2>
  SplitMesh::normal(const Side &side) const
  {
    return cross_product_2d(vertices[side.vertices[1]] -
                            vertices[side.vertices[0]]) /
           length(side);
  }



  double
  area(const std::array<Point<2>, 3> &corners)
  {
    return 0.5 * (cross_product_2d(corners[1] - corners[0]) *
                  (corners[0] - corners[2]));
  }



  SplitMesh
  make_split_mesh(const Triangulation<2> &triangulation)
  {
    Assembler assembler;
    for (const Polygon &polygon : gather_polygons(triangulation))
      assembler.add(polygon);
    return assembler.mesh;
  }
} // namespace ElastoPlastic
