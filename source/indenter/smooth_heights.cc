// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <array>
#include <cmath>

#include "indenter/indenter_height_map.h"

namespace ElastoPlastic
{
  namespace
  {
    /// What the value and the slope at an end of the interval (0, 1)
    /// contribute to a cubic: by the order of the derivative.
    struct Weights
    {
      std::array<double, 3> value, slope;
    };



    Weights
    weights_of_end(const unsigned int end, const double t)
    {
      if (end == 0)
        return {
          {{1. - t * t * (3. - 2. * t), 6. * t * (t - 1.), 12. * t - 6.}},
          {{t * (1. - t) * (1. - t), (1. - t) * (1. - 3. * t), 6. * t - 4.}}};
      return {{{t * t * (3. - 2. * t), 6. * t * (1. - t), 6. - 12. * t}},
              {{t * t * (t - 1.), t * (3. * t - 2.), 6. * t - 2.}}};
    }



    /// The harmonic mean of the slopes on both sides of a grid point, or that
    /// of one side at the ends; 0 where the heights turn.
    template <int n>
    double
    slope_at(const Table<n, double> &heights,
             const TableIndices<n>  &point,
             const unsigned int      axis)
    {
      const auto slope_from = [&](const unsigned int i) {
        TableIndices<n> left = point, right = point;
        left[axis]  = i;
        right[axis] = i + 1;
        return heights(right) - heights(left);
      };
      const unsigned int last   = heights.size(axis) - 1;
      const unsigned int i      = point[axis];
      const double       before = slope_from(i > 0 ? i - 1 : 0);
      const double       after  = slope_from(std::min(i, last - 1));
      return before * after > 0. ? 2. * before * after / (before + after) : 0.;
    }


    /// What the height at a corner of a cell of the grid, and the slopes along
    /// the lines through it, contribute to the surface.
    template <int n>
    struct Corner
    {
      double                 height;
      std::array<double, n>  slopes;
      std::array<Weights, n> weights;

      double
      derivative(const std::array<unsigned int, n> &orders) const
      {
        double of_values = 1., of_slopes = 0.;
        for (unsigned int d = 0; d < n; ++d)
          {
            const double value = weights[d].value[orders[d]];
            const double slope = weights[d].slope[orders[d]];
            of_slopes = of_slopes * value + of_values * slope * slopes[d];
            of_values *= value;
          }
        return height * of_values + of_slopes;
      }
    };



    template <int n>
    Corner<n>
    make_corner(const Table<n, double> &heights,
                const TableIndices<n>  &first,
                const unsigned int      number,
                const Point<n>         &t)
    {
      Corner<n>       result;
      TableIndices<n> point = first;
      for (unsigned int d = 0; d < n; ++d)
        {
          const unsigned int end = (number >> d) % 2;
          point[d] += end;
          result.weights[d] = weights_of_end(end, t[d]);
        }
      for (unsigned int d = 0; d < n; ++d)
        result.slopes[d] = slope_at<n>(heights, point, d);
      result.height = heights(point);
      return result;
    }
  } // namespace



  template <int dim>
  IndenterSurface<dim>
  smooth_surface(const Table<dim - 1, double> &heights,
                 const Tensor<1, dim - 1>     &spacing,
                 const Point<dim - 1>         &x)
  {
    constexpr unsigned int n = dim - 1;
    TableIndices<n>        first;
    Point<n>               t;
    for (unsigned int d = 0; d < n; ++d)
      {
        const double position = x[d] / spacing[d];
        first[d] = std::clamp(std::floor(position), 0., heights.size(d) - 2.);
        t[d]     = position - first[d];
      }

    IndenterSurface<dim> result{0., {}, {}};
    for (unsigned int i = 0; i < (1U << n); ++i)
      {
        const Corner<n> corner = make_corner<n>(heights, first, i, t);
        std::array<unsigned int, n> orders{};
        result.height += corner.derivative(orders);
        for (unsigned int d = 0; d < n; ++d)
          {
            ++orders[d];
            result.slope[d] += corner.derivative(orders) / spacing[d];
            for (unsigned int e = d; e < n; ++e)
              {
                ++orders[e];
                result.curvature[d][e] +=
                  corner.derivative(orders) / (spacing[d] * spacing[e]);
                --orders[e];
              }
            --orders[d];
          }
      }
    return result;
  }



  template IndenterSurface<2>
  smooth_surface(const Table<1, double> &,
                 const Tensor<1, 1> &,
                 const Point<1> &);
  template IndenterSurface<3>
  smooth_surface(const Table<2, double> &,
                 const Tensor<1, 2> &,
                 const Point<2> &);
} // namespace ElastoPlastic
