// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include "contact/footprint.h"

namespace ElastoPlastic
{
  namespace
  {
    template <int dim, std::size_t n>
    using Corners = std::array<Point<dim>, n>;



    /// A disc that is an interval, too.
    Rectangle<1>
    interval(const Disc<1> &disc)
    {
      return {disc.centre, {{disc.radius}}};
    }



    template <int dim, std::size_t n>
    bool
    contains(const Rectangle<dim - 1> &rectangle,
             const Corners<dim, n>    &corners)
    {
      return std::all_of(corners.begin(), corners.end(), [&](const auto &x) {
        for (unsigned int d = 0; d < dim - 1; ++d)
          if (std::abs(x[d] - rectangle.centre[d]) >
              (1. + rounding_of_circle) * rectangle.half_widths[d])
            return false;
        return true;
      });
    }



    /// Whether a line across the @p direction separates the two.
    template <int dim, std::size_t n>
    bool
    are_separated(const Rectangle<dim - 1> &rectangle,
                  const Corners<dim, n>    &corners,
                  const Tensor<1, dim - 1> &direction)
    {
      double extent = 0;
      for (unsigned int d = 0; d < dim - 1; ++d)
        if (direction[d] != 0.)
          extent += std::abs(direction[d]) * rectangle.half_widths[d];
      std::array<double, n> positions;
      for (unsigned int i = 0; i < n; ++i)
        {
          positions[i] = 0;
          for (unsigned int d = 0; d < dim - 1; ++d)
            positions[i] +=
              direction[d] * (corners[i][d] - rectangle.centre[d]);
        }
      const auto [least, greatest] =
        std::minmax_element(positions.begin(), positions.end());
      return std::max(*least, -*greatest) >= (1. - rounding_of_circle) * extent;
    }



    bool
    overlaps(const Rectangle<1> &interval, const Corners<2, 2> &side)
    {
      return !are_separated<2, 2>(interval, side, Tensor<1, 1>({1.}));
    }



    // Two convex polygons are separated by a line along a side of one of them,
    // if by any.
    bool
    overlaps(const Rectangle<2> &rectangle, const Corners<3, 3> &triangle)
    {
      for (unsigned int d = 0; d < 2; ++d)
        if (are_separated<3, 3>(rectangle, triangle, Point<2>::unit_vector(d)))
          return false;
      for (unsigned int i = 0; i < 3; ++i)
        {
          const Tensor<1, 2> across = cross_product_2d(
            from_above(triangle[(i + 1) % 3]) - from_above(triangle[i]));
          if (across.norm() > 0. &&
              are_separated<3, 3>(rectangle, triangle, across))
            return false;
        }
      return true;
    }
  } // namespace



  bool
  contains(const Footprint<1> &footprint, const std::array<Point<2>, 2> &side)
  {
    return (!footprint.disc ||
            contains<2, 2>(interval(*footprint.disc), side)) &&
           (!footprint.rectangle || contains<2, 2>(*footprint.rectangle, side));
  }



  bool
  contains(const Footprint<2>            &footprint,
           const std::array<Point<3>, 3> &triangle)
  {
    return (!footprint.disc || contains(*footprint.disc, triangle)) &&
           (!footprint.rectangle ||
            contains<3, 3>(*footprint.rectangle, triangle));
  }



  bool
  overlaps(const Footprint<1> &footprint, const std::array<Point<2>, 2> &side)
  {
    return (!footprint.disc || overlaps(interval(*footprint.disc), side)) &&
           (!footprint.rectangle || overlaps(*footprint.rectangle, side));
  }



  bool
  overlaps(const Footprint<2>            &footprint,
           const std::array<Point<3>, 3> &triangle)
  {
    return (!footprint.disc || overlaps(*footprint.disc, triangle)) &&
           (!footprint.rectangle || overlaps(*footprint.rectangle, triangle));
  }
} // namespace ElastoPlastic
