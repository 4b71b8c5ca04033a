// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_stress_inverse_square_h
#define bounds_stress_inverse_square_h

#include <deal.II/base/numbers.h>

#include <cmath>

namespace ElastoPlastic
{
  using namespace dealii;

  /// A quadratic polynomial in place of 1 / r^2 on an interval: the one with
  /// the same values at Chebyshev's points.
  class InverseSquare
  {
  public:
    InverseSquare(const double r_min, const double r_max)
    {
      const double middle = 0.5 * (r_min + r_max),
                   radius = 0.5 * (r_max - r_min);
      for (unsigned int i = 0; i < 3; ++i)
        nodes[i] = middle + radius * std::cos((2. * i + 1.) * numbers::PI / 6.);
      // max |24 r^-5| / 3! times max |(r - r_0) (r - r_1) (r - r_2)|
      largest_error = std::pow(radius, 3) / std::pow(r_min, 5);
    }

    double
    operator()(const double r) const
    {
      double sum = 0;
      for (unsigned int i = 0; i < 3; ++i)
        {
          const double a = nodes[(i + 1) % 3], b = nodes[(i + 2) % 3];
          sum += (r - a) * (r - b) /
                 ((nodes[i] - a) * (nodes[i] - b) * nodes[i] * nodes[i]);
        }
      return sum;
    }

    /// An upper bound of the error in the interval.
    double
    error() const
    {
      return largest_error;
    }

  private:
    double nodes[3];
    double largest_error;
  };
} // namespace ElastoPlastic

#endif
