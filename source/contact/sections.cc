// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/indenter.h"
#include "contact/sections.h"

namespace ElastoPlastic
{
  namespace Sections
  {
    constexpr SectionPoint beyond_edge = {
      std::numeric_limits<double>::infinity(), 0., 0.};



    Section
    circle(const double radius)
    {
      return {[radius](const double r) -> SectionPoint {
        if (!within(r, radius))
          return beyond_edge;
        const double cosine_leg =
          std::sqrt(std::max(0., (radius - r) * (radius + r)));
        const double bounded_leg = std::max(cosine_leg, 1e-5 * radius);
        return {r * r / (radius + cosine_leg),
                r / bounded_leg,
                radius * radius / Utilities::fixed_power<3>(bounded_leg)};
      }};
    }



    Section
    parabola(const double radius_of_curvature)
    {
      return {[radius_of_curvature](const double r) -> SectionPoint {
        return {r * r / (2 * radius_of_curvature),
                r / radius_of_curvature,
                1 / radius_of_curvature};
      }};
    }



    Section
    flank(const double semi_apex_angle)
    {
      const double slope = 1 / std::tan(semi_apex_angle * numbers::PI / 180);
      return {[slope](const double r) -> SectionPoint {
                return {slope * r, slope, 0.};
              },
              2. - 4. / numbers::PI};
    }



    Section
    face(const double half_width)
    {
      return {
        [half_width](const double r) {
          return within(r, half_width) ? SectionPoint{0., 0., 0.} : beyond_edge;
        },
        1.};
    }
  } // namespace Sections
} // namespace ElastoPlastic
