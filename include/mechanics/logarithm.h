// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_logarithm_h
#define mechanics_logarithm_h

#include <algorithm>
#include <array>
#include <cmath>

#include "base/simd.h"

namespace ElastoPlastic
{
  /// f(c) = ln(1 + c) / 2, the logarithm of a stretch whose square is 1 + c,
  /// and its divided differences, which without cancellation tend to its
  /// derivatives when their arguments, all above -1, tend to each other. Number
  /// is double, or a batch of them: as long as the arguments in each lane are
  /// close to each other, all lanes take the same series at once.
  namespace HalfLogarithm
  {
    /// Where so many terms of atanh(x) / x = 1 + x^2/3 + x^4/5 + ... are it in
    /// double precision: where the ratio of two squares of stretches is below
    /// 1.4.
    constexpr double       small_square     = 0.03;
    constexpr unsigned int n_terms_of_atanh = 10;

    /// Where three arguments are as close as this, relative to 1 + c, their
    /// divided difference is taken from the series about their mean.
    constexpr double       close   = 0.1;
    constexpr unsigned int n_terms = 14;

    /// f' = f[c, c]
    template <typename Number>
    Number
    slope(const Number &c)
    {
      return 0.5 / (1. + c);
    }



    /// f'' / 2 = f[c, c, c]
    template <typename Number>
    Number
    half_curvature(const Number &c)
    {
      const Number square = 1. + c;
      return -0.25 / (square * square);
    }



    /// f[a, b] = (f(b) - f(a)) / (b - a); with x = (a - b) / (2 + a + b):
    /// (atanh(x) / x) / (2 + a + b).
    template <typename Number>
    Number
    difference(const Number &a, const Number &b)
    {
      const Number sum    = 2. + a + b;
      const Number x      = (a - b) / sum;
      const Number square = x * x;
      Number       ratio  = Number(0.);
      for (unsigned int n = n_terms_of_atanh; n-- > 0;)
        ratio = ratio * square + 1. / (2. * n + 1.);
      for (unsigned int lane = 0; lane < n_lanes<Number>; ++lane)
        if (!(lane_of(square, lane) < small_square))
          lane_of(ratio, lane) =
            std::atanh(lane_of(x, lane)) / lane_of(x, lane);
      return ratio / sum;
    }



    template <typename Number>
    Number
    value(const Number &c)
    {
      return c * difference(c, Number(0.));
    }



    /// sum_n f^(n+2)(m) / (n+2)! h_n(d_1, d_2, d_3), with the complete
    /// homogeneous polynomials h_n of the distances d_i from the mean m.
    template <typename Number>
    Number
    series_about_mean(const Number &a, const Number &b, const Number &c)
    {
      const Number mean = (a + b + c) * (1. / 3.);
      const Number m    = 1. + mean;
      const Number x = (a - mean) / m, y = (b - mean) / m, z = (c - mean) / m;
      const Number e_2 = x * y + y * z + z * x, e_3 = x * y * z;

      // h_n = -e_2 h_(n-2) + e_3 h_(n-3), since x + y + z = 0
      std::array<Number, n_terms> h;
      h[0]       = Number(1.);
      h[1]       = Number(0.);
      h[2]       = -e_2;
      Number sum = h[0] * (-1. / 2.) + h[2] * (-1. / 4.);
      for (unsigned int n = 3; n < n_terms; ++n)
        {
          h[n] = e_3 * h[n - 3] - e_2 * h[n - 2];
          sum += h[n] * ((n % 2 == 0 ? -1. : 1.) / (n + 2.));
        }
      return 0.5 * sum / (m * m);
    }



    /// f[a, b, c] = (f[b, c] - f[a, b]) / (c - a)
    template <typename Number>
    Number
    difference(const Number &a, const Number &b, const Number &c)
    {
      const Number low    = std::min(std::min(a, b), c);
      const Number high   = std::max(std::max(a, b), c);
      const Number middle = (a - low) + (b - high) + c;
      const Number excess = (high - low) - close * (1. + middle);
      Number       result = series_about_mean(a, b, c);
      for (unsigned int lane = 0; lane < n_lanes<Number>; ++lane)
        if (!(lane_of(excess, lane) <= 0.))
          lane_of(result, lane) =
            (difference(lane_of(middle, lane), lane_of(high, lane)) -
             difference(lane_of(low, lane), lane_of(middle, lane))) /
            lane_of(high - low, lane);
      return result;
    }
  } // namespace HalfLogarithm
} // namespace ElastoPlastic

#endif
