// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

#include "bounds/mesh/integration.h"

namespace ElastoPlastic
{
  // Lines from the corner nearest to the axis to the opposite side: with a
  // position s on the line and t of its end on the side, dx = 2 |K| s ds dt.
  // On a line, s f / r is a polynomial and, from the root of r on the other
  // side of the corner, a multiple of 1 / r that is not positive: Gauss'
  // formula makes that too large. For each s, f / r as a function of t is a
  // polynomial and a multiple of 1 / r that is not negative: Lobatto's formula
  // does.
  std::vector<WeightedPoint>
  quadrature_over(const std::array<double, 3> &r)
  {
    static const QGauss<1>        along_lines(4);
    static const QGaussLobatto<1> across(4);

    const unsigned int tip = std::min_element(r.begin(), r.end()) - r.begin();
    std::vector<WeightedPoint> points;
    for (unsigned int i = 0; i < along_lines.size(); ++i)
      for (unsigned int j = 0; j < across.size(); ++j)
        {
          const double  s = along_lines.point(i)[0], t = across.point(j)[0];
          WeightedPoint point;
          point.position[tip]           = 1. - s;
          point.position[(tip + 1) % 3] = s * (1. - t);
          point.position[(tip + 2) % 3] = s * t;
          const double r_here           = point.interpolate(r);
          if (r_here == 0.)
            continue;
          point.weight =
            2. * s * along_lines.weight(i) * across.weight(j) / r_here;
          points.push_back(point);
        }
    return points;
  }
} // namespace ElastoPlastic
