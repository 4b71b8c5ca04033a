// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>

#include "bounds/conic/friction.h"
#include "bounds/conic/yield_conditions.h"

namespace ElastoPlastic
{
  // The deviator of a stress with s_33 = (s_11 + s_22) / 2 has sqrt(2) times
  // the norm of ((s_11 - s_22) / 2, s_12).
  void
  add_friction(ConicBlock                &block,
               const FullMatrix<double>  &point_stresses,
               const std::vector<double> &pressures,
               const double               sine)
  {
    constexpr unsigned int n_components = n_stress_components<2>;

    const double factor = std::sqrt(0.5) * sine;
    for (unsigned int p = 0; p < pressures.size(); ++p)
      {
        const unsigned int row = n_components * p;
        block.cone_offset[row] += 2. * factor * pressures[p];
        for (unsigned int j = 0; j < point_stresses.n(); ++j)
          block.cone_matrix(row, j) +=
            factor * (point_stresses(row, j) + point_stresses(row + 1, j));
      }
  }



  void
  add_growing_pressure(ConicBlock                &block,
                       const unsigned int         unknown,
                       const std::vector<double> &pressures,
                       const double               sine)
  {
    for (unsigned int p = 0; p < pressures.size(); ++p)
      block.cone_matrix(n_stress_components<2> * p, unknown) -=
        std::sqrt(2.) * sine * pressures[p];
  }
} // namespace ElastoPlastic
