// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

#include "bounds/body/gathered_solution.h"
#include "bounds/mechanism/space_quadratic_field.h"

namespace ElastoPlastic
{
  namespace
  {
    constexpr auto edge_between = TetrahedralMesh::edge_between;



    /// The gradient of @p field at a @p corner, where only the functions of
    /// the edges that begin there have one.
    Tensor<2, 3>
    gradient(const SpaceQuadraticField         &field,
             const TetrahedralMesh::Simplex    &tetrahedron,
             const std::array<Tensor<1, 3>, 4> &linear,
             const unsigned int                 corner)
    {
      Tensor<2, 3> result;
      for (unsigned int i = 0; i < 4; ++i)
        {
          result += (i == corner ? 3. : -1.) *
                    outer_product(field.at_vertices[tetrahedron.vertices[i]],
                                  linear[i]);
          if (i != corner)
            {
              const unsigned int edge =
                edge_between(std::min(i, corner), std::max(i, corner));
              result +=
                4. * outer_product(field.at_edges[tetrahedron.edges[edge]],
                                   linear[i]);
            }
        }
      return result;
    }
  } // namespace



  std::array<SymmetricTensor<2, 3>, 4>
  strains(const TetrahedralMesh     &mesh,
          const SpaceQuadraticField &field,
          const unsigned int         t)
  {
    const auto &tetrahedron = mesh.tetrahedra[t];
    const auto  linear      = gradients(mesh.corners(tetrahedron));
    std::array<SymmetricTensor<2, 3>, 4> result;
    for (unsigned int corner = 0; corner < 4; ++corner)
      result[corner] = symmetrize(gradient(field, tetrahedron, linear, corner));
    return result;
  }



  std::array<Tensor<1, 3>, 5>
  values_at_vertices(const SpaceQuadraticField      &field,
                     const TetrahedralMesh::Simplex &tetrahedron)
  {
    std::array<Tensor<1, 3>, 5> result;
    for (unsigned int i = 0; i < 4; ++i)
      {
        result[i] = field.at_vertices[tetrahedron.vertices[i]];
        result[4] -= 0.125 * result[i];
      }
    for (const unsigned int edge : tetrahedron.edges)
      result[4] += 0.25 * field.at_edges[edge];
    return result;
  }



  Tensor<1, 3>
  FaceValues::value(const std::array<double, 3> &position) const
  {
    Tensor<1, 3> result;
    for (unsigned int i = 0; i < 3; ++i)
      result += position[i] * (2. * position[i] - 1.) * at_corners[i] +
                4. * position[i] * position[(i + 1) % 3] * at_edges[i];
    return result;
  }



  FaceValues
  values_on_face(const TetrahedralMesh     &mesh,
                 const SpaceQuadraticField &field,
                 const unsigned int         f)
  {
    const auto &tetrahedron = mesh.tetrahedra[mesh.faces[f].neighbors[0]];
    const unsigned int k =
      std::find(tetrahedron.faces.begin(), tetrahedron.faces.end(), f) -
      tetrahedron.faces.begin();
    FaceValues values;
    for (unsigned int i = 0; i < 3; ++i)
      {
        const unsigned int a = corner_of_face(k, i),
                           b = corner_of_face(k, (i + 1) % 3);
        values.edges[i] =
          tetrahedron.edges[edge_between(std::min(a, b), std::max(a, b))];
        values.at_corners[i] = field.at_vertices[tetrahedron.vertices[a]];
        values.at_edges[i]   = field.at_edges[values.edges[i]];
      }
    return values;
  }



  SpaceQuadraticField
  interpolate_displacement(const TetrahedralMesh &mesh,
                           const DoFHandler<3>   &dof_handler,
                           const VectorType      &displacement)
  {
    const GatheredSolution<3> solution(dof_handler, displacement);
    SpaceQuadraticField       field;
    field.at_vertices.resize(mesh.vertices.size());
    field.at_edges.resize(mesh.n_edges);
    for (const auto &tetrahedron : mesh.tetrahedra)
      {
        const CellId &cell = mesh.cells[tetrahedron.cell].id;
        const auto   &unit = tetrahedron.unit_corners;
        for (unsigned int i = 0; i < 4; ++i)
          {
            field.at_vertices[tetrahedron.vertices[i]] =
              solution.value(cell, unit[i]);
            for (unsigned int j = i + 1; j < 4; ++j)
              field.at_edges[tetrahedron.edges[edge_between(i, j)]] =
                solution.value(cell, unit[i] + 0.5 * (unit[j] - unit[i]));
          }
      }
    return field;
  }
} // namespace ElastoPlastic
