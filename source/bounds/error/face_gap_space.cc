// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/exceptions.h"
#include "bounds/error/face_gap.h"

namespace ElastoPlastic
{
  namespace
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();

    double
    sum(const std::array<double, 3> &values)
    {
      return values[0] + values[1] + values[2];
    }
  } // namespace



  FaceGap<3>::FaceGap(const std::function<double(const Point<3> &)> &g,
                      const FaceCorners<3>                          &corners)
  {
    constexpr int      width  = n_intervals + 2 * margin + 1;
    const Tensor<1, 3> first  = (corners[1] - corners[0]) / n_intervals,
                       second = (corners[2] - corners[0]) / n_intervals;
    gap.assign(width * width, infinity);
    lower.assign(width * width, infinity);
    upper.assign(width * width, -infinity);
    for (int i = -margin; i <= n_intervals + margin; ++i)
      for (int j = -margin; j <= n_intervals + margin; ++j)
        if (i + j <= n_intervals + margin)
          gap[index({i, j})] = g(corners[0] + i * first + j * second);
    for_small_triangles([this](const auto &triangle) { enclose(triangle); });
  }



  template <typename Action>
  void
  FaceGap<3>::for_small_triangles(const Action &action)
  {
    using Corners = std::array<LatticePoint, 3>;
    for (int i = 0; i < n_intervals; ++i)
      for (int j = 0; i + j < n_intervals; ++j)
        {
          action(Corners{{{i, j}, {i + 1, j}, {i, j + 1}}});
          if (i + j + 1 < n_intervals)
            action(Corners{{{i + 1, j + 1}, {i, j + 1}, {i + 1, j}}});
        }
  }



  // The bounds at a lattice point must do for all small triangles around it.
  void
  FaceGap<3>::enclose(const std::array<LatticePoint, 3> &corners)
  {
    constexpr int         distance = 2; // of c
    std::array<double, 3> values, below, above;
    for (unsigned int k = 0; k < 3; ++k)
      values[k] = gap[index(corners[k])];
    below = {{-infinity, -infinity, -infinity}};
    above = values;

    bool is_first = true;
    for (int i = corners[0].i - distance; i <= corners[0].i + distance; ++i)
      for (int j = corners[0].j - distance; j <= corners[0].j + distance; ++j)
        {
          std::array<double, 3> reflected, low, high;
          for (unsigned int k = 0; k < 3; ++k)
            {
              const LatticePoint mirrored = {2 * i - corners[k].i,
                                             2 * j - corners[k].j};
              reflected[k] = 2. * gap[index({i, j})] - gap[index(mirrored)];
              low[k]       = std::min(values[k], reflected[k]);
              high[k]      = std::max(values[k], reflected[k]);
            }
          if (!std::isfinite(sum(reflected)))
            continue; // c or a mirror image is out of reach
          if (is_first || sum(low) > sum(below))
            below = low;
          if (is_first || sum(high) < sum(above))
            above = high;
          is_first = false;
        }

    const bool is_touched =
      std::any_of(values.begin(), values.end(), [](const double value) {
        return std::isfinite(value);
      });
    if (is_first && is_touched)
      throw ConvergenceError(
        "The indenter reaches a small part of a face of the mesh only, where "
        "the gap cannot be bounded. Change the mesh, or 'Indenter/Reach'.");
    for (unsigned int k = 0; k < 3; ++k)
      {
        const std::size_t n = index(corners[k]);
        if (!is_first)
          lower[n] = std::min(lower[n], below[k]);
        upper[n] = std::max(upper[n], above[k]);
      }
  }



  std::vector<SmallSimplex<3>>
  FaceGap<3>::small_simplices() const
  {
    std::vector<SmallSimplex<3>> result;
    for_small_triangles([&](const std::array<LatticePoint, 3> &points) {
      SmallSimplex<3> triangle;
      triangle.part = 1. / (n_intervals * n_intervals);
      for (unsigned int k = 0; k < 3; ++k)
        {
          const double first  = points[k].i / double(n_intervals),
                       second = points[k].j / double(n_intervals);
          triangle.corners[k] = {{1. - first - second, first, second}};
          triangle.lower[k]   = lower[index(points[k])];
          triangle.upper[k]   = upper[index(points[k])];
        }
      result.push_back(triangle);
    });
    return result;
  }
} // namespace ElastoPlastic
