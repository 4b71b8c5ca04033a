// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include "equilibrium/velocity_field.h"

namespace ElastoPlastic
{
  double
  relative_divergence(const SplitMesh &mesh, const QuadraticField &velocity)
  {
    double divergence = 0, largest_rate = 0;
    for (unsigned int t = 0; t < mesh.triangles.size(); ++t)
      for (const auto &rate : strains(mesh, velocity, t))
        {
          divergence   = std::max(divergence, std::abs(trace(rate)));
          largest_rate = std::max(largest_rate, rate.norm());
        }
    return largest_rate > 0 ? divergence / largest_rate : 0.;
  }



  double
  plastic_rate(const PlaneBody &body, const SymmetricTensor<2, 2> &rate)
  {
    const double square = rate * rate;
    return std::sqrt(square +
                     (body.kinematics == Kinematics::plane_stress ? 1. : -0.5) *
                       trace(rate) * trace(rate));
  }
} // namespace ElastoPlastic
