// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include "bounds/error/side_gap.h"

namespace ElastoPlastic
{
  namespace
  {
    /// The last position where @p is_finite, from @p inside, where it is,
    /// towards @p outside, where it is not.
    template <typename Predicate>
    double
    last_finite(double inside, double outside, const Predicate &is_finite)
    {
      constexpr unsigned int n_bisections = 52;
      for (unsigned int k = 0; k < n_bisections; ++k)
        {
          const double middle                    = 0.5 * (inside + outside);
          (is_finite(middle) ? inside : outside) = middle;
        }
      return inside;
    }
  } // namespace



  SideGap::SideGap(const std::function<double(const Point<2> &)> &gap,
                   const Point<2>                                &a,
                   const Point<2>                                &b)
  {
    const auto g = [&](const double t) {
      return gap(Point<2>(a + t * (b - a)));
    };
    const auto is_finite = [&](const double t) {
      return std::isfinite(g(t));
    };
    unsigned int first = 0, last = n_intervals;
    while (first <= n_intervals && !is_finite(position(first)))
      ++first;
    if (first > n_intervals)
      return;
    while (!is_finite(position(last)))
      --last;
    const double left =
      first == 0 ? 0. :
                   last_finite(position(first), position(first - 1), is_finite);
    end   = last == n_intervals ?
              1. :
              last_finite(position(last), position(last + 1), is_finite);
    begin = left;

    for (unsigned int i = 0; i <= n_intervals; ++i)
      values.push_back(g(position(i)));

    // The chord before an interval, continued to its end, is below the value
    // there by the second difference at its beginning, and vice versa.
    const auto bend = [this](const unsigned int i) {
      return values[i - 1] - 2. * values[i] + values[i + 1];
    };
    for (unsigned int i = 0; i < n_intervals; ++i)
      {
        const double before = bend(std::max(i, 1u)),
                     after  = bend(std::min(i + 1, n_intervals - 1));
        below               = std::max(below, std::min(before, after));
        above               = std::max(above, -std::max(before, after));
      }
  }



  double
  SideGap::position(const unsigned int i) const
  {
    return begin + (end - begin) * i / n_intervals;
  }
} // namespace ElastoPlastic
