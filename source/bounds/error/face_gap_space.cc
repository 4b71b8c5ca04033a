// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/table.h>

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



    /// How many steps beyond the corner 0 of the face its lattice begins, and
    /// beyond the opposite edge it ends.
    constexpr unsigned int margin = 5;

    constexpr unsigned int n_steps = FaceGap<3>::n_intervals,
                           width   = n_steps + 2 * margin + 1;

    /// How many steps to corner 1 and to corner 2.
    using LatticePoint  = dealii::TableIndices<2>;
    using LatticeValues = dealii::Table<2, double>;
    using SmallTriangle = std::array<LatticePoint, 3>;

    std::vector<SmallTriangle>
    all_small_triangles()
    {
      std::vector<SmallTriangle> triangles;
      for (unsigned int i = margin; i < margin + n_steps; ++i)
        for (unsigned int j = margin; i + j < 2 * margin + n_steps; ++j)
          {
            triangles.push_back({{{i, j}, {i + 1, j}, {i, j + 1}}});
            if (i + j + 1 < 2 * margin + n_steps)
              triangles.push_back({{{i + 1, j + 1}, {i, j + 1}, {i + 1, j}}});
          }
      return triangles;
    }



    // The bounds at a lattice point must do for all small triangles around it.
    void
    enclose(LatticeValues       &lower,
            LatticeValues       &upper,
            const LatticeValues &gap,
            const SmallTriangle &corners)
    {
      constexpr unsigned int distance = 2; // of c
      std::array<double, 3>  values, below, above;
      for (unsigned int k = 0; k < 3; ++k)
        values[k] = gap(corners[k]);
      below = {{-infinity, -infinity, -infinity}};
      above = values;

      bool              is_first = true;
      const std::size_t x = corners[0][0], y = corners[0][1];
      for (unsigned int i = x - distance; i <= x + distance; ++i)
        for (unsigned int j = y - distance; j <= y + distance; ++j)
          {
            std::array<double, 3> reflected, low, high;
            for (unsigned int k = 0; k < 3; ++k)
              {
                const LatticePoint mirrored = {2 * i - corners[k][0],
                                               2 * j - corners[k][1]};
                reflected[k]                = 2. * gap(i, j) - gap(mirrored);
                low[k]                      = std::min(values[k], reflected[k]);
                high[k]                     = std::max(values[k], reflected[k]);
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
          double &low = lower(corners[k]), &high = upper(corners[k]);
          if (!is_first)
            low = std::min(low, below[k]);
          high = std::max(high, above[k]);
        }
    }
  } // namespace



  template <>
  FaceGap<3>::FaceGap(const std::function<double(const Point<3> &)> &g,
                      const FaceCorners<3>                          &corners)
  {
    static const auto triangles = all_small_triangles();

    const auto steps = [](const LatticePoint &point, const unsigned int d) {
      return (double(point[d]) - margin) / n_steps;
    };
    LatticeValues gap(width, width), lower(width, width), upper(width, width);
    gap.fill(infinity);
    lower.fill(infinity);
    upper.fill(-infinity);
    for (unsigned int i = 0; i < width; ++i)
      for (unsigned int j = 0; j < width && i + j < margin + width; ++j)
        gap(i, j) =
          g(corners[0] + steps({i, j}, 0) * (corners[1] - corners[0]) +
            steps({i, j}, 1) * (corners[2] - corners[0]));
    for (const SmallTriangle &triangle : triangles)
      enclose(lower, upper, gap, triangle);

    for (const SmallTriangle &points : triangles)
      {
        SmallSimplex<3> &triangle = small_simplices.emplace_back();
        triangle.part             = 1. / (n_steps * n_steps);
        for (unsigned int k = 0; k < 3; ++k)
          {
            const double first  = steps(points[k], 0),
                         second = steps(points[k], 1);
            triangle.corners[k] = {{1. - first - second, first, second}};
            triangle.lower[k]   = lower(points[k]);
            triangle.upper[k]   = upper(points[k]);
          }
      }
    constexpr unsigned int end = margin + n_steps;
    lower_at_corners           = {
                {lower(margin, margin), lower(end, margin), lower(margin, end)}};
  }
} // namespace ElastoPlastic
