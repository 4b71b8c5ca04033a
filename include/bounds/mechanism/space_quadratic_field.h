// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_mechanism_space_quadratic_field_h
#define bounds_mechanism_space_quadratic_field_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/dofs/dof_handler.h>

#include <array>
#include <vector>

#include "bounds/mesh/tetrahedral_mesh.h"
#include "mechanics/solid_operator.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// A displacement that is quadratic on each tetrahedron and continuous: what
  /// QuadraticField is in two dimensions.
  struct SpaceQuadraticField
  {
    std::vector<Tensor<1, 3>> at_vertices;
    std::vector<Tensor<1, 3>> at_edges; ///< in the middle
  };



  /// The strain of @p field at the corners of a @p tetrahedron, between which
  /// it is linear.
  std::array<SymmetricTensor<2, 3>, 4>
  strains(const TetrahedralMesh     &mesh,
          const SpaceQuadraticField &field,
          const unsigned int         tetrahedron);

  /// Its values at the corners and at the centre of gravity of a tetrahedron.
  std::array<Tensor<1, 3>, 5>
  values_at_vertices(const SpaceQuadraticField      &field,
                     const TetrahedralMesh::Simplex &tetrahedron);

  /// Its values on a face: at the corners, and in the middle of the edges that
  /// begin at these and end at the next corners.
  struct FaceValues
  {
    std::array<unsigned int, 3> edges;
    std::array<Tensor<1, 3>, 3> at_corners;
    std::array<Tensor<1, 3>, 3> at_edges;

    /// At a point of the face, given by barycentric coordinates.
    Tensor<1, 3>
    value(const std::array<double, 3> &position) const;
  };

  FaceValues
  values_on_face(const TetrahedralMesh     &mesh,
                 const SpaceQuadraticField &field,
                 const unsigned int         face);

  /// Interpolates a finite element solution on the hexahedra that have been
  /// split into the tetrahedra of @p mesh. The values are gathered on the first
  /// rank; the field of the others is empty, as their mesh is.
  SpaceQuadraticField
  interpolate_displacement(const TetrahedralMesh &mesh,
                           const DoFHandler<3>   &dof_handler,
                           const VectorType      &displacement);
} // namespace ElastoPlastic

#endif
