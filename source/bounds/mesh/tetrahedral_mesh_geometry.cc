// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>

#include "bounds/mesh/tetrahedral_mesh.h"

namespace ElastoPlastic
{
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
} // namespace ElastoPlastic
