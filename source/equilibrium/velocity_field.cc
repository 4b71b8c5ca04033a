// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>

#include "equilibrium/velocity_field.h"

namespace ElastoPlastic
{
  double
  plastic_rate(const PlaneBody &body, const SymmetricTensor<2, 2> &rate)
  {
    const double square = rate * rate;
    return std::sqrt(square + (body.plane_stress ? 1. : -0.5) * trace(rate) *
                                trace(rate));
  }

} // namespace ElastoPlastic
