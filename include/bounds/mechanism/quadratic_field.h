// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_mechanism_quadratic_field_h
#define bounds_mechanism_quadratic_field_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/dofs/dof_handler.h>

#include <array>
#include <vector>

#include "bounds/mesh/split_mesh.h"
#include "mechanics/solid_operator.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// A displacement that is quadratic on each triangle of a
  /// SplitMesh and continuous: its strains are linear on each triangle.
  struct QuadraticField
  {
    std::vector<Tensor<1, 2>> at_vertices;
    std::vector<Tensor<1, 2>> at_sides; ///< in the middle
  };



  /// The gradients of the six quadratic shape functions at a @p corner of a
  /// triangle: of those that belong to its corners, then of those that belong
  /// to the middles of its sides.
  std::array<Tensor<1, 2>, 6>
  shape_gradients(const std::array<Point<2>, 3> &corners,
                  const unsigned int             corner);

  /// The strain of @p field at the corners of a @p triangle.
  std::array<SymmetricTensor<2, 2>, 3>
  strains(const SplitMesh      &mesh,
          const QuadraticField &field,
          const unsigned int    triangle);

  /// The value at a point of a triangle, given by barycentric coordinates.
  Tensor<1, 2>
  value(const QuadraticField        &field,
        const SplitMesh::Triangle   &triangle,
        const std::array<double, 3> &position);

  /// Its values at the corners and at the centre of gravity of a triangle.
  std::array<Tensor<1, 2>, 4>
  values_at_vertices(const QuadraticField      &field,
                     const SplitMesh::Triangle &triangle);

  /// Interpolates a finite element solution on the quadrilaterals, of which
  /// @p mesh is the triangulation. Bilinear displacements of parallelograms are
  /// reproduced. The values are gathered on the first rank; the field of the
  /// others is empty, as their mesh is.
  QuadraticField
  interpolate_displacement(const SplitMesh     &mesh,
                           const DoFHandler<2> &dof_handler,
                           const VectorType    &displacement);
} // namespace ElastoPlastic

#endif
