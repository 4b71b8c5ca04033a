// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <array>
#include <cmath>

#include "mechanics/logarithm.h"

namespace ElastoPlastic::HalfLogarithm
{
  namespace
  {
    /// Where atanh(x) / x is 1 + x^2/3 + ... + x^8/9 in double precision.
    constexpr double small_square = 1e-3;
    /// Where three arguments are as close as this, relative to 1 + c, their
    /// divided difference is taken from the series about their mean.
    constexpr double       close   = 0.1;
    constexpr unsigned int n_terms = 14;



    /// sum_n f^(n+2)(m) / (n+2)! h_n(d_1, d_2, d_3), with the complete
    /// homogeneous polynomials h_n of the distances d_i from the mean m.
    double
    series_about_mean(const std::array<double, 3> &c)
    {
      const double mean = (c[0] + c[1] + c[2]) / 3.;
      const double m    = 1. + mean;
      const double x = (c[0] - mean) / m, y = (c[1] - mean) / m,
                   z   = (c[2] - mean) / m;
      const double e_2 = x * y + y * z + z * x, e_3 = x * y * z;

      // h_n = -e_2 h_(n-2) + e_3 h_(n-3), since x + y + z = 0
      std::array<double, n_terms> h   = {{1., 0., -e_2}};
      double                      sum = 0, sign = -0.5;
      for (unsigned int n = 0; n < n_terms; ++n, sign = -sign)
        {
          if (n >= 3)
            h[n] = -e_2 * h[n - 2] + e_3 * h[n - 3];
          sum += sign / (n + 2.) * h[n];
        }
      return sum / (m * m);
    }
  } // namespace



  double
  value(const double c)
  {
    return 0.5 * std::log1p(c);
  }



  // With x = (a - b) / (2 + a + b): (atanh(x) / x) / (2 + a + b).
  double
  difference(const double a, const double b)
  {
    const double sum    = 2. + a + b;
    const double x      = (a - b) / sum;
    const double square = x * x;
    const double ratio =
      square < small_square ?
        1. + square * (1. / 3. +
                       square * (1. / 5. + square * (1. / 7. + square / 9.))) :
        std::atanh(x) / x;
    return ratio / sum;
  }



  double
  difference(const double a, const double b, const double c)
  {
    std::array<double, 3> sorted = {{a, b, c}};
    std::sort(sorted.begin(), sorted.end());
    const auto &[low, middle, high] = sorted;
    if (high - low <= close * (1. + middle))
      return series_about_mean(sorted);
    return (difference(middle, high) - difference(low, middle)) / (high - low);
  }
} // namespace ElastoPlastic::HalfLogarithm
