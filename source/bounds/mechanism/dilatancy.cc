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
    using Rates = std::array<SymmetricTensor<2, 3>, n_quadratics>;

    /// The coefficients of the strain rate, a quadratic polynomial.
    Rates
    coefficients_of_rate(const SplitBody<2>       &body,
                         const SimplexVelocity<2> &velocity,
                         const unsigned int        t)
    {
      Rates coefficients;
      for (unsigned int p = 0; p < n_quadratics; ++p)
        {
          const auto at_point =
            strain_rate_at(body, velocity, t, Bernstein<2>::points(2)[p]);
          for (unsigned int i = 0; i < n_quadratics; ++i)
            coefficients[i] += Bernstein<2>::coefficients(2)(i, p) * at_point;
        }
      return coefficients;
    }



    double
    rate_of_shear(const SplitBody<2> &body, const SymmetricTensor<2, 3> &rate)
    {
      return body.is_axisymmetric() ?
               std::sqrt(2.) * deviator(rate).norm() :
               std::hypot(rate[0][0] - rate[1][1], 2. * rate[0][1]);
    }



    /// By how much v_r is not r times the polynomial e_tt with these
    /// coefficients: all rates are quadratic only if it is.
    double
    departure_from_quadratic(const SplitBody<2>       &body,
                             const SimplexVelocity<2> &velocity,
                             const unsigned int        t,
                             const Rates              &rates)
    {
      double largest = 0.;
      for (const auto &point : Bernstein<2>::points(velocity_degree<2>))
        {
          const auto functions = Bernstein<2>::functions(2, point);
          double     rate      = 0.;
          for (unsigned int i = 0; i < n_quadratics; ++i)
            rate += functions[i] * rates[i][2][2];
          keep_largest(largest,
                       std::abs(velocity_at(body, velocity, t, point)[0] -
                                interpolate(point, body.corners_of(t))[0] *
                                  rate));
        }
      return largest;
    }
  } // namespace



  double
  missing_dilatation(const SplitBody<2>       &body,
                     const SimplexVelocity<2> &velocity,
                     const unsigned int        t)
  {
    const double slope   = body.friction_slopes[t];
    const Rates  rates   = coefficients_of_rate(body, velocity, t);
    double       missing = 0.;
    for (const auto &rate : rates)
      keep_largest(missing,
                   slope > 0. ?
                     slope * rate_of_shear(body, rate) - trace(rate) :
                     std::abs(trace(rate)));
    missing *= std::sqrt(volume(body.corners_of(t)));
    if (body.is_axisymmetric())
      keep_largest(missing, departure_from_quadratic(body, velocity, t, rates));
    return missing;
  }



  double
  work_of_soil(const SplitBody<2>       &body,
               const SimplexVelocity<2> &velocity,
               const unsigned int        t)
  {
    const double          slope   = body.friction_slopes[t];
    const auto            corners = body.corners_of(t);
    const Rates           rates   = coefficients_of_rate(body, velocity, t);
    std::array<double, 3> weights;
    for (unsigned int i = 0; i < 3; ++i)
      weights[i] = body.weight(corners[i]);
    const auto moments = quadratic_moments(weights);
    double     sum     = 0.;
    for (unsigned int i = 0; i < n_quadratics; ++i)
      {
        const double shear = rate_of_shear(body, rates[i]);
        sum += moments[i] *
               (slope > 0. ? std::max(shear, trace(rates[i]) / slope) : shear);
      }
    return body.angle() * std::sqrt(0.5) * body.materials[t].yield_radius *
           volume(corners) * sum;
  }
} // namespace ElastoPlastic
