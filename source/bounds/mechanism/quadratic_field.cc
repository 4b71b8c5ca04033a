// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "bounds/body/gathered_solution.h"
#include "bounds/mechanism/quadratic_field.h"
#include "bounds/stress/johnson_mercier.h"

namespace ElastoPlastic
{
  std::array<Tensor<1, 2>, 6>
  shape_gradients(const std::array<Point<2>, 3> &corners,
                  const unsigned int             corner)
  {
    const auto                  linear = JohnsonMercier::gradients(corners);
    std::array<Tensor<1, 2>, 6> result;
    for (unsigned int i = 0; i < 3; ++i)
      result[i] = (i == corner ? 3. : -1.) * linear[i];
    result[3 + corner]           = 4. * linear[(corner + 1) % 3];
    result[3 + (corner + 2) % 3] = 4. * linear[(corner + 2) % 3];
    return result;
  }



  std::array<SymmetricTensor<2, 2>, 3>
  strains(const SplitMesh      &mesh,
          const QuadraticField &field,
          const unsigned int    t)
  {
    const auto                          &triangle = mesh.triangles[t];
    const auto                           corners  = mesh.corners(triangle);
    std::array<SymmetricTensor<2, 2>, 3> result;
    for (unsigned int corner = 0; corner < 3; ++corner)
      {
        const auto   gradients = shape_gradients(corners, corner);
        Tensor<2, 2> gradient;
        for (unsigned int i = 0; i < 3; ++i)
          gradient +=
            outer_product(field.at_vertices[triangle.vertices[i]],
                          gradients[i]) +
            outer_product(field.at_sides[triangle.sides[i]], gradients[3 + i]);
        result[corner] = symmetrize(gradient);
      }
    return result;
  }



  Tensor<1, 2>
  value(const QuadraticField        &field,
        const SplitMesh::Triangle   &triangle,
        const std::array<double, 3> &position)
  {
    Tensor<1, 2> result;
    for (unsigned int i = 0; i < 3; ++i)
      result += position[i] * (2. * position[i] - 1.) *
                  field.at_vertices[triangle.vertices[i]] +
                4. * position[i] * position[(i + 1) % 3] *
                  field.at_sides[triangle.sides[i]];
    return result;
  }



  std::array<Tensor<1, 2>, 4>
  values_at_vertices(const QuadraticField      &field,
                     const SplitMesh::Triangle &triangle)
  {
    return {{value(field, triangle, {{1., 0., 0.}}),
             value(field, triangle, {{0., 1., 0.}}),
             value(field, triangle, {{0., 0., 1.}}),
             value(field, triangle, {{1. / 3., 1. / 3., 1. / 3.}})}};
  }



  QuadraticField
  interpolate_displacement(const SplitMesh     &mesh,
                           const DoFHandler<2> &dof_handler,
                           const VectorType    &displacement)
  {
    const GatheredSolution<2> solution(dof_handler, displacement);
    QuadraticField            field;
    field.at_vertices.resize(mesh.vertices.size());
    field.at_sides.resize(mesh.sides.size());
    for (const auto &triangle : mesh.triangles)
      {
        const CellId &cell = mesh.cells[triangle.cell].id;
        for (unsigned int i = 0; i < 3; ++i)
          {
            const Point<2> &here  = triangle.unit_corners[i],
                           &there = triangle.unit_corners[(i + 1) % 3];
            field.at_vertices[triangle.vertices[i]] =
              solution.value(cell, here);
            field.at_sides[triangle.sides[i]] =
              solution.value(cell, here + 0.5 * (there - here));
          }
      }
    return field;
  }
} // namespace ElastoPlastic
