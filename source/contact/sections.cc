// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/indenter.h"
#include "contact/sections.h"

namespace ElastoPlastic
{
  namespace Sections
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();



    Section
    circle(const double radius)
    {
      return {[radius](const double r) {
        if (!within(r, radius))
          return infinity;
        const double cosine_leg =
          std::sqrt(std::max(0., (radius - r) * (radius + r)));
        return r * r / (radius + cosine_leg);
      }};
    }



    Section
    parabola(const double radius_of_curvature)
    {
      return {[radius_of_curvature](const double r) {
        return r * r / (2 * radius_of_curvature);
      }};
    }



    Section
    flank(const double semi_apex_angle)
    {
      const double slope = 1 / std::tan(semi_apex_angle * numbers::PI / 180);
      return {[slope](const double r) { return slope * r; },
              2. - 4. / numbers::PI};
    }



    Section
    face(const double half_width)
    {
      return {[half_width](const double r) {
                return within(r, half_width) ? 0. : infinity;
              },
              1.};
    }
  } // namespace Sections
} // namespace ElastoPlastic
