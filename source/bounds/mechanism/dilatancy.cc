// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include "base/largest_error.h"
#include "bounds/mechanism/velocity_check.h"

namespace ElastoPlastic
{
  namespace
  {
    /// A strain rate in the plane: the rate of volume, and that of shear
    /// |(e_11 - e_22, 2 e_12)|.
    struct Rate
    {
      double volume, shear;
    };



    /// Those of the coefficients of the strain rate, a quadratic polynomial.
    std::array<Rate, n_quadratics>
    rates_of(const SplitBody<2>       &body,
             const SimplexVelocity<2> &velocity,
             const unsigned int        t)
    {
      const auto corners = body.corners_of(t);
      std::array<SymmetricTensor<2, 2>, n_quadratics> at_points;
      for (unsigned int p = 0; p < n_quadratics; ++p)
        at_points[p] =
          polynomial_rate<2>(corners, velocity, Bernstein<2>::points(2)[p]);
      std::array<Rate, n_quadratics> rates;
      for (unsigned int i = 0; i < n_quadratics; ++i)
        {
          SymmetricTensor<2, 2> e;
          for (unsigned int p = 0; p < n_quadratics; ++p)
            e += Bernstein<2>::coefficients(2)(i, p) * at_points[p];
          rates[i] = {trace(e), std::hypot(e[0][0] - e[1][1], 2. * e[0][1])};
        }
      return rates;
    }
  } // namespace



  double
  missing_dilatation(const SplitBody<2>       &body,
                     const SimplexVelocity<2> &velocity,
                     const unsigned int        t)
  {
    const double sine    = body.friction_sines[t];
    double       missing = 0.;
    for (const auto &[volume, shear] : rates_of(body, velocity, t))
      keep_largest(missing,
                   sine > 0. ? sine * shear - volume : std::abs(volume));
    return missing;
  }



  double
  work_of_soil(const SplitBody<2>       &body,
               const SimplexVelocity<2> &velocity,
               const unsigned int        t)
  {
    const double sine = body.friction_sines[t];
    double       sum  = 0.;
    for (const auto &[volume, shear] : rates_of(body, velocity, t))
      sum += sine > 0. ? std::max(shear, volume / sine) : shear;
    return std::sqrt(0.5) * body.materials[t].yield_radius *
           volume(body.corners_of(t)) / n_quadratics * sum;
  }
} // namespace ElastoPlastic
