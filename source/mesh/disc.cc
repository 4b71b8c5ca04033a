// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/disc.h"

namespace ElastoPlastic
{
  namespace
  {
    double
    distance(const Disc<2> &disc, const Point<3> &x)
    {
      return disc.centre.distance(from_above(x));
    }



    /// Of the centre from a triangle seen from above: 0 inside.
    double
    distance(const Disc<2> &disc, const std::array<Point<3>, 3> &triangle)
    {
      double       least  = std::numeric_limits<double>::infinity();
      unsigned int n_left = 0, n_right = 0;
      for (unsigned int i = 0; i < 3; ++i)
        {
          const Point<2>     a    = from_above(triangle[i]);
          const Tensor<1, 2> side = from_above(triangle[(i + 1) % 3]) - a,
                             to   = disc.centre - a;
          const double length     = side.norm_square(),
                       t          = length > 0. ?
                                      std::clamp((to * side) / length, 0., 1.) :
                                      0.;
          least                   = std::min(least, (to - t * side).norm());
          const double turn       = cross_product_2d(side) * to;
          n_left += turn > 0.;
          n_right += turn < 0.;
        }
      return n_left == 3 || n_right == 3 ? 0. : least;
    }
  } // namespace



  bool
  contains(const Disc<2> &disc, const std::array<Point<3>, 3> &triangle)
  {
    return std::all_of(triangle.begin(), triangle.end(), [&](const auto &x) {
      return distance(disc, x) <= (1. + rounding_of_circle) * disc.radius;
    });
  }



  bool
  overlaps(const Disc<2> &disc, const std::array<Point<3>, 3> &triangle)
  {
    return distance(disc, triangle) < (1. - rounding_of_circle) * disc.radius;
  }



  bool
  is_on_edge(const Disc<2> &disc, const Point<3> &x)
  {
    return std::abs(distance(disc, x) - disc.radius) <=
           rounding_of_circle * disc.radius;
  }
} // namespace ElastoPlastic
