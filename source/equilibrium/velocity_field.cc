// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>

#include "equilibrium/johnson_mercier.h"
#include "equilibrium/velocity_field.h"

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



  double
  plastic_rate(const PlaneBody &body, const SymmetricTensor<2, 2> &rate)
  {
    const double square = rate * rate;
    return std::sqrt(square + (body.plane_stress ? 1. : -0.5) * trace(rate) *
                                trace(rate));
  }



  std::array<SymmetricTensor<2, 2>, 3>
  strain_rates(const PlaneBody     &body,
               const VelocityField &field,
               const unsigned int   t)
  {
    const auto                          &triangle = body.mesh.triangles[t];
    const auto                           corners  = body.mesh.corners(triangle);
    std::array<SymmetricTensor<2, 2>, 3> rates;
    for (unsigned int corner = 0; corner < 3; ++corner)
      {
        const auto   gradients = shape_gradients(corners, corner);
        Tensor<2, 2> gradient;
        for (unsigned int i = 0; i < 3; ++i)
          gradient +=
            outer_product(field.at_vertices[triangle.vertices[i]],
                          gradients[i]) +
            outer_product(field.at_sides[triangle.sides[i]], gradients[3 + i]);
        rates[corner] = symmetrize(gradient);
      }
    return rates;
  }
} // namespace ElastoPlastic
