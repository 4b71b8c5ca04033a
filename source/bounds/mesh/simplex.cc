// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>

#include "bounds/mesh/simplex.h"

namespace ElastoPlastic
{
  double
  volume(const Corners<2> &corners)
  {
    return 0.5 * (cross_product_2d(corners[1] - corners[0]) *
                  (corners[0] - corners[2]));
  }



  double
  volume(const Corners<3> &corners)
  {
    return std::abs(cross_product_3d(corners[1] - corners[0],
                                     corners[2] - corners[0]) *
                    (corners[3] - corners[0])) /
           6.;
  }



  double
  area(const FaceCorners<2> &corners)
  {
    return corners[0].distance(corners[1]);
  }



  double
  area(const FaceCorners<3> &corners)
  {
    return 0.5 *
           cross_product_3d(corners[1] - corners[0], corners[2] - corners[0])
             .norm();
  }



  Tensor<1, 2>
  normal(const FaceCorners<2> &corners)
  {
    return cross_product_2d(corners[1] - corners[0]) / area(corners);
  }



  Tensor<1, 3>
  normal(const FaceCorners<3> &corners)
  {
    const Tensor<1, 3> product =
      cross_product_3d(corners[1] - corners[0], corners[2] - corners[0]);
    return product / product.norm();
  }



  std::array<Tensor<1, 2>, 1>
  tangents(const FaceCorners<2> &corners)
  {
    return {{-cross_product_2d(normal(corners))}};
  }



  std::array<Tensor<1, 3>, 2>
  tangents(const FaceCorners<3> &corners)
  {
    const Tensor<1, 3> side  = corners[1] - corners[0];
    const Tensor<1, 3> first = side / side.norm();
    return {{first, cross_product_3d(normal(corners), first)}};
  }



  std::array<Tensor<1, 2>, 3>
  gradients(const Corners<2> &corners)
  {
    std::array<Tensor<1, 2>, 3> result;
    for (unsigned int i = 0; i < 3; ++i)
      result[i] =
        -cross_product_2d(corners[(i + 2) % 3] - corners[(i + 1) % 3]) /
        (2. * volume(corners));
    return result;
  }



  std::array<Tensor<1, 3>, 4>
  gradients(const Corners<3> &corners)
  {
    std::array<Tensor<1, 3>, 4> result;
    for (unsigned int k = 0; k < 4; ++k)
      {
        const Point<3>    &a = corners[corner_of_face<3>(k, 0)];
        const Tensor<1, 3> product =
          cross_product_3d(corners[corner_of_face<3>(k, 1)] - a,
                           corners[corner_of_face<3>(k, 2)] - a);
        result[k] = product / (product * (corners[k] - a));
      }
    return result;
  }

} // namespace ElastoPlastic
