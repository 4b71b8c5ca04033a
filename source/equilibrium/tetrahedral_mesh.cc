// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <map>

#include "equilibrium/tetrahedral_mesh.h"

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

      template <typename Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &number &position;
      }
    };



    /// A quadrilateral face without children, which is cut from its centre to
    /// the vertices around it.
    struct FacePiece
    {
      FaceKey                    key; ///< its four corners, sorted
      Point<3>                   center;
      types::boundary_id         boundary_id;
      std::vector<NumberedPoint> around; ///< corners and hanging nodes

      template <typename Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &key &center &boundary_id &around;
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



    // deal.II numbers the vertices of a face lexicographically: around it, one
    // passes the vertices 0, 1, 3, 2 and the lines 2, 1, 3, 0.
    FacePiece
    piece_of(const DoFHandler<3>::face_iterator &face)
    {
      constexpr std::array<unsigned int, 4> vertices = {{0, 1, 3, 2}};
      constexpr std::array<unsigned int, 4> lines    = {{2, 1, 3, 0}};

      FacePiece piece;
      piece.center      = face->center();
      piece.boundary_id = face->boundary_id();
      for (unsigned int i = 0; i < 4; ++i)
        {
          piece.key[i] = face->vertex_dof_index(vertices[i], 0);
          piece.around.push_back({piece.key[i], face->vertex(vertices[i])});
          const auto line = face->line(lines[i]);
          if (line->has_children())
            piece.around.push_back({line->child(0)->vertex_dof_index(1, 0),
                                    line->child(0)->vertex(1)});
        }
      std::sort(piece.key.begin(), piece.key.end());
      return piece;
    }



    Hexahedron
    hexahedron_of(const DoFHandler<3>::active_cell_iterator &cell)
    {
      Hexahedron hexahedron;
      hexahedron.id          = cell->id();
      hexahedron.material_id = cell->material_id();
      hexahedron.center      = cell->center();
      for (const auto &face : cell->face_iterators())
        if (face->has_children())
          for (unsigned int c = 0; c < face->n_children(); ++c)
            hexahedron.pieces.push_back(piece_of(face->child(c)));
        else
          hexahedron.pieces.push_back(piece_of(face));
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
           Utilities::MPI::gather(triangulation.get_communicator(), own))
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
                add_tetrahedron({{vertex(corners, a.number, a.position),
                                  vertex(corners, b.number, b.position),
                                  face_center,
                                  center}},
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

      // The last of the vertices is the one in the interior of the hexahedron.
      void
      add_tetrahedron(std::array<unsigned int, 4> vertices,
                      const types::boundary_id    outer_boundary)
      {
        const unsigned int center = vertices[3];
        std::sort(vertices.begin(), vertices.end());
        TetrahedralMesh::Simplex tetrahedron;
        tetrahedron.vertices = vertices;
        tetrahedron.cell     = mesh.cells.size() - 1;
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
      std::map<FaceKey, unsigned int>                     face_centers;
      std::map<std::array<unsigned int, 3>, unsigned int> faces;
    };
  } // namespace



  Tetrahedron
  TetrahedralMesh::corners(const Simplex &tetrahedron) const
  {
    Tetrahedron result;
    for (unsigned int i = 0; i < 4; ++i)
      result[i] = vertices[tetrahedron.vertices[i]];
    return result;
  }



  TriangleFace
  TetrahedralMesh::corners(const Face &face) const
  {
    TriangleFace result;
    for (unsigned int i = 0; i < 3; ++i)
      result[i] = vertices[face.vertices[i]];
    return result;
  }



  double
  volume(const Tetrahedron &corners)
  {
    return std::abs(cross_product_3d(corners[1] - corners[0],
                                     corners[2] - corners[0]) *
                    (corners[3] - corners[0])) /
           6.;
  }



  double
  area(const TriangleFace &corners)
  {
    return 0.5 *
           cross_product_3d(corners[1] - corners[0], corners[2] - corners[0])
             .norm();
  }



  Tensor<1, 3>
  normal(const TriangleFace &corners)
  {
    const Tensor<1, 3> product =
      cross_product_3d(corners[1] - corners[0], corners[2] - corners[0]);
    return product / product.norm();
  }



  std::array<Tensor<1, 3>, 2>
  tangents(const TriangleFace &corners)
  {
    const Tensor<1, 3> side  = corners[1] - corners[0];
    const Tensor<1, 3> first = side / side.norm();
    return {{first, cross_product_3d(normal(corners), first)}};
  }



  std::array<Tensor<1, 3>, 4>
  gradients(const Tetrahedron &corners)
  {
    std::array<Tensor<1, 3>, 4> result;
    for (unsigned int k = 0; k < 4; ++k)
      {
        const Point<3>    &a = corners[corner_of_face(k, 0)];
        const Tensor<1, 3> product =
          cross_product_3d(corners[corner_of_face(k, 1)] - a,
                           corners[corner_of_face(k, 2)] - a);
        result[k] = product / (product * (corners[k] - a));
      }
    return result;
  }



  Tensor<1, 3>
  outward_normal(const Tetrahedron &corners, const unsigned int k)
  {
    const Tensor<1, 3> gradient = gradients(corners)[k];
    return -gradient / gradient.norm();
  }



  TetrahedralMesh
  make_split_mesh(const Triangulation<3> &triangulation)
  {
    TetrahedraAssembler assembler;
    for (const Hexahedron &hexahedron : gather_hexahedra(triangulation))
      assembler.add(hexahedron);
    return assembler.mesh;
  }
} // namespace ElastoPlastic
