// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <map>

#include "base/compatibility.h"
#include "bounds/mesh/tetrahedral_mesh.h"

namespace ElastoPlastic
{
  namespace
  {
    using VertexNumber = types::global_dof_index;
    using FaceKey      = std::array<VertexNumber, 4>;



    /// A vertex of the mesh of hexahedra.
    struct NumberedPoint
    {
      VertexNumber number; ///< the same for all cells around it
      Point<3>     position;
      Point<3>     unit_position;

      template <typename Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &number &position &unit_position;
      }
    };



    /// A quadrilateral face without children, which is cut from its centre to
    /// the vertices around it.
    struct FacePiece
    {
      FaceKey                    key; ///< its four corners, sorted
      Point<3>                   center;
      Point<3>                   unit_center;
      types::boundary_id         boundary_id;
      std::vector<NumberedPoint> around; ///< corners and hanging nodes

      template <typename Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &key &center &unit_center &boundary_id &around;
      }
    };



    struct Hexahedron
    {
      CellId                 id;
      types::material_id     material_id;
      Point<3>               center;
      std::vector<FacePiece> pieces;

      template <typename Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &id &material_id &center &pieces;
      }
    };



    /// Where vertices are in the unit cell of a hexahedron.
    using UnitPositions = std::map<VertexNumber, Point<3>>;



    Point<3>
    middle(const Point<3> &a, const Point<3> &b)
    {
      return Point<3>(0.5 * (a + b));
    }



    /// Of the corners, and of the middles of edges and faces that are refined.
    UnitPositions
    unit_positions_of(const DoFHandler<3>::active_cell_iterator &cell)
    {
      UnitPositions positions;
      for (const unsigned int v : cell->vertex_indices())
        positions[cell->vertex_dof_index(v, 0)] =
          ReferenceCells::Hexahedron.template vertex<3>(v);
      const auto at = [&](const auto &object, const unsigned int vertex) {
        return positions.at(object->vertex_dof_index(vertex, 0));
      };
      for (const unsigned int l : cell->line_indices())
        if (const auto line = cell->line(l); line->has_children())
          positions[line->child(0)->vertex_dof_index(1, 0)] =
            middle(at(line, 0), at(line, 1));
      for (const auto &face : cell->face_iterators())
        if (face->has_children())
          positions[face->child(0)->vertex_dof_index(3, 0)] =
            middle(at(face, 0), at(face, 3));
      return positions;
    }



    // deal.II numbers the vertices of a face lexicographically: around it, one
    // passes the vertices 0, 1, 3, 2 and the lines 2, 1, 3, 0.
    FacePiece
    piece_of(const DoFHandler<3>::face_iterator &face,
             const UnitPositions                &unit_positions)
    {
      constexpr std::array<unsigned int, 4> vertices = {{0, 1, 3, 2}};
      constexpr std::array<unsigned int, 4> lines    = {{2, 1, 3, 0}};

      const auto unit = [&](const unsigned int i) {
        return unit_positions.at(face->vertex_dof_index(vertices[i % 4], 0));
      };

      FacePiece piece;
      piece.center      = face->center();
      piece.unit_center = middle(unit(0), unit(2));
      piece.boundary_id = face->boundary_id();
      for (unsigned int i = 0; i < 4; ++i)
        {
          piece.key[i] = face->vertex_dof_index(vertices[i], 0);
          piece.around.push_back(
            {piece.key[i], face->vertex(vertices[i]), unit(i)});
          const auto line = face->line(lines[i]);
          if (line->has_children())
            piece.around.push_back({line->child(0)->vertex_dof_index(1, 0),
                                    line->child(0)->vertex(1),
                                    middle(unit(i), unit(i + 1))});
        }
      std::sort(piece.key.begin(), piece.key.end());
      return piece;
    }



    Hexahedron
    hexahedron_of(const DoFHandler<3>::active_cell_iterator &cell)
    {
      Hexahedron hexahedron;
      hexahedron.id                      = cell->id();
      hexahedron.material_id             = cell->material_id();
      hexahedron.center                  = cell->center();
      const UnitPositions unit_positions = unit_positions_of(cell);
      for (const auto &face : cell->face_iterators())
        if (face->has_children())
          for (unsigned int c = 0; c < face->n_children(); ++c)
            hexahedron.pieces.push_back(
              piece_of(face->child(c), unit_positions));
        else
          hexahedron.pieces.push_back(piece_of(face, unit_positions));
      return hexahedron;
    }



    /// Of all ranks, on the first of them.
    std::vector<Hexahedron>
    gather_hexahedra(const Triangulation<3> &triangulation)
    {
      const FE_Q<3> fe(1);
      DoFHandler<3> dof_handler(triangulation);
      dof_handler.distribute_dofs(fe);

      std::vector<Hexahedron> own;
      for (const auto &cell : dof_handler.active_cell_iterators())
        if (cell->is_locally_owned())
          own.push_back(hexahedron_of(cell));

      std::vector<Hexahedron> all;
      for (const auto &hexahedra :
           Utilities::MPI::gather(communicator_of(triangulation), own))
        all.insert(all.end(), hexahedra.begin(), hexahedra.end());
      std::sort(all.begin(), all.end(), [](const auto &a, const auto &b) {
        return a.id < b.id;
      });
      return all;
    }



    /// Puts tetrahedra together, one after the other.
    class TetrahedraAssembler
    {
    public:
      void
      add(const Hexahedron &hexahedron)
      {
        mesh.cells.push_back({hexahedron.id, hexahedron.material_id});
        const unsigned int center = mesh.vertices.size();
        mesh.vertices.push_back(hexahedron.center);
        for (const FacePiece &piece : hexahedron.pieces)
          {
            const unsigned int face_center =
              vertex(face_centers, piece.key, piece.center);
            const unsigned int n = piece.around.size();
            for (unsigned int i = 0; i < n; ++i)
              {
                const auto &a = piece.around[i], &b = piece.around[(i + 1) % n];
                add_tetrahedron(
                  {{{vertex(corners, a.number, a.position), a.unit_position},
                    {vertex(corners, b.number, b.position), b.unit_position},
                    {face_center, piece.unit_center},
                    {center, Point<3>(0.5, 0.5, 0.5)}}},
                  piece.boundary_id);
              }
          }
      }

      TetrahedralMesh mesh;

    private:
      template <typename Key>
      unsigned int
      vertex(std::map<Key, unsigned int> &numbering,
             const Key                   &key,
             const Point<3>              &position)
      {
        const auto [entry, is_new] =
          numbering.try_emplace(key, mesh.vertices.size());
        if (is_new)
          mesh.vertices.push_back(position);
        return entry->second;
      }

      /// A vertex of the mesh, and where it is in the unit cell.
      struct Corner
      {
        unsigned int vertex;
        Point<3>     unit_position;
      };

      // The last of the corners is the one in the interior of the hexahedron.
      void
      add_tetrahedron(std::array<Corner, 4>    points,
                      const types::boundary_id outer_boundary)
      {
        const unsigned int center = points[3].vertex;
        std::sort(points.begin(),
                  points.end(),
                  [](const Corner &a, const Corner &b) {
                    return a.vertex < b.vertex;
                  });
        TetrahedralMesh::Simplex tetrahedron;
        auto                    &vertices = tetrahedron.vertices;
        for (unsigned int i = 0; i < 4; ++i)
          {
            vertices[i]                 = points[i].vertex;
            tetrahedron.unit_corners[i] = points[i].unit_position;
          }
        tetrahedron.cell = mesh.cells.size() - 1;
        for (unsigned int i = 0; i < 4; ++i)
          for (unsigned int j = i + 1; j < 4; ++j)
            tetrahedron.edges[TetrahedralMesh::edge_between(i, j)] =
              edge(vertices[i], vertices[j]);
        for (unsigned int k = 0; k < 4; ++k)
          tetrahedron.faces[k] =
            face({{vertices[corner_of_face(k, 0)],
                   vertices[corner_of_face(k, 1)],
                   vertices[corner_of_face(k, 2)]}},
                 vertices[k] == center ? outer_boundary :
                                         numbers::internal_face_boundary_id);
        mesh.tetrahedra.push_back(tetrahedron);
      }

      unsigned int
      edge(const unsigned int a, const unsigned int b)
      {
        const auto [entry, is_new] = edges.try_emplace({{a, b}}, mesh.n_edges);
        if (is_new)
          ++mesh.n_edges;
        return entry->second;
      }

      unsigned int
      face(const std::array<unsigned int, 3> &vertices,
           const types::boundary_id           boundary_id)
      {
        const unsigned int here = mesh.tetrahedra.size();
        const auto [entry, is_new] =
          faces.try_emplace(vertices, mesh.faces.size());
        if (is_new)
          mesh.faces.push_back(
            {vertices, boundary_id, {{here, numbers::invalid_unsigned_int}}});
        else
          mesh.faces[entry->second].neighbors[1] = here;
        return entry->second;
      }

      std::map<VertexNumber, unsigned int>                corners;
      std::map<std::array<unsigned int, 2>, unsigned int> edges;
      std::map<FaceKey, unsigned int>                     face_centers;
      std::map<std::array<unsigned int, 3>, unsigned int> faces;
    };
  } // namespace



  TetrahedralMesh
  make_split_mesh(const Triangulation<3> &triangulation)
  {
    TetrahedraAssembler assembler;
    for (const Hexahedron &hexahedron : gather_hexahedra(triangulation))
      assembler.add(hexahedron);
    return assembler.mesh;
  }
} // namespace ElastoPlastic
