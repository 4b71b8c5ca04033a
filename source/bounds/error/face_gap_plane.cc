// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "bounds/error/face_gap.h"

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



  template <>
  FaceGap<2>::FaceGap(const std::function<double(const Point<2> &)> &gap,
                      const FaceCorners<2>                          &corners)
  {
    lower_at_corners.fill(std::numeric_limits<double>::infinity());
    double     begin = 0., end = 1.; // of what the indenter reaches
    const auto position = [&](const int i) {
      return begin + (end - begin) * i / n_intervals;
    };
    const auto g = [&](const double t) {
      return gap(Point<2>(corners[0] + t * (corners[1] - corners[0])));
    };
    const auto is_finite = [&](const double t) {
      return std::isfinite(g(t));
    };
    int first = 0, last = n_intervals;
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

    std::array<double, n_intervals + 1> values;
    for (int i = 0; i <= n_intervals; ++i)
      values[i] = g(position(i));

    // The chord before an interval, continued to its end, is below the value
    // there by the second difference at its beginning, and vice versa.
    const auto bend = [&](const int i) {
      return values[i - 1] - 2. * values[i] + values[i + 1];
    };
    double below = 0, above = 0;
    for (int i = 0; i < n_intervals; ++i)
      {
        const double before = bend(std::max(i, 1)),
                     after  = bend(std::min(i + 1, n_intervals - 1));
        below               = std::max(below, std::min(before, after));
        above               = std::max(above, -std::max(before, after));
      }

    for (int i = 0; i < n_intervals; ++i)
      {
        SmallSimplex<2> &interval = small_simplices.emplace_back();
        for (int k = 0; k < 2; ++k)
          {
            const double t      = position(i + k);
            interval.corners[k] = {{1. - t, t}};
            interval.lower[k]   = values[i + k] - below;
            interval.upper[k]   = values[i + k] + above;
          }
        interval.part = position(i + 1) - position(i);
      }
    constexpr double rounding = 1. / n_intervals;
    if (begin < rounding)
      lower_at_corners[0] = values.front() - below;
    if (end > 1. - rounding)
      lower_at_corners[1] = values.back() - below;
  }
} // namespace ElastoPlastic
