// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>

#include "bounds/conic/yield_conditions.h"

namespace ElastoPlastic
{
  FullMatrix<double>
  deviator_matrix()
  {
    FullMatrix<double> d(3, n_stress_components);
    d(0, 0) = std::sqrt(0.5);
    d(0, 1) = -std::sqrt(0.5);
    d(1, 2) = std::sqrt(2.);
    d(2, 0) = d(2, 1) = -std::sqrt(1. / 6.);
    d(2, 3)           = std::sqrt(2. / 3.);
    return d;
  }



  void
  add_yield_conditions(ConicBlock               &block,
                       const FullMatrix<double> &point_stresses,
                       const double              radius)
  {
    const FullMatrix<double> deviator = deviator_matrix();
    const unsigned int n_points = point_stresses.m() / n_stress_components;
    const unsigned int n        = point_stresses.n();

    block.cone_matrix.reinit(4 * n_points, n);
    block.cone_offset.reinit(4 * n_points);
    block.cone_sizes.assign(n_points, 4);
    block.cone_scales.assign(n_points, ConeScale());
    for (unsigned int p = 0; p < n_points; ++p)
      {
        block.cone_offset[4 * p] = radius;
        for (unsigned int d = 0; d < 3; ++d)
          for (unsigned int c = 0; c < n_stress_components; ++c)
            for (unsigned int j = 0; j < n; ++j)
              block.cone_matrix(4 * p + 1 + d, j) -=
                deviator(d, c) * point_stresses(n_stress_components * p + c, j);
      }
  }
} // namespace ElastoPlastic
