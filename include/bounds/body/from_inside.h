// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_body_from_inside_h
#define bounds_body_from_inside_h

#include <deal.II/base/point.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ElastoPlastic
{
  using namespace dealii;

  /// The point @p x of a side or face, moved towards its @p centre by little
  /// more than rounding. A load that jumps at a vertex has one value there for
  /// all sides that meet: what it is on one of them is found inside it.
  template <int dim>
  Point<dim>
  from_inside(const Point<dim> &x, const Point<dim> &centre)
  {
    constexpr double smallest_share = 1e-12, largest_share = 1e-2;
    constexpr double rounding = 64. * std::numeric_limits<double>::epsilon();

    const double distance = x.distance(centre);
    if (distance == 0.)
      return x;
    double coordinate = 0;
    for (unsigned int d = 0; d < dim; ++d)
      coordinate = std::max(coordinate, std::abs(x[d]));
    const double share = std::clamp(rounding * coordinate / distance,
                                    smallest_share,
                                    largest_share);
    return Point<dim>(x + share * (centre - x));
  }
} // namespace ElastoPlastic

#endif
