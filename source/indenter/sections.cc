// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "indenter/indenter.h"
#include "indenter/sections.h"

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
                        radius * radius /
                          Utilities::fixed_power<3>(bounded_leg)};
              },
              [radius](const double height) {
                return height < radius ?
                         std::sqrt(height * (2 * radius - height)) :
                         radius;
              },
              0.75,
              true,
              radius};
    }



    Section
    parabola(const double radius_of_curvature)
    {
      return {[radius_of_curvature](const double r) -> SectionPoint {
                return {r * r / (2 * radius_of_curvature),
                        r / radius_of_curvature,
                        1 / radius_of_curvature};
              },
              [radius_of_curvature](const double height) {
                return std::sqrt(2 * radius_of_curvature * height);
              }};
    }



    Section
    flank(const double semi_apex_angle)
    {
      const double slope = 1 / std::tan(semi_apex_angle * numbers::PI / 180);
      return {[slope](const double r) -> SectionPoint {
                return {slope * r, slope, 0.};
              },
              [slope](const double height) { return height / slope; },
              2. - 4. / numbers::PI};
    }



    Section
    face(const double half_width)
    {
      return {
        [half_width](const double r) {
          return within(r, half_width) ? SectionPoint{0., 0., 0.} : beyond_edge;
        },
        [half_width](const double) { return half_width; },
        1.,
        true,
        half_width};
    }



    Section
    spheroconical(const double radius, const double semi_apex_angle)
    {
      const double  angle      = semi_apex_angle * numbers::PI / 180;
      const double  cap_radius = radius * std::cos(angle);
      const double  cap_height = radius * (1 - std::sin(angle));
      const Section cap        = circle(radius);
      const Section cone       = flank(semi_apex_angle);
      return {[=](const double r) {
                if (r <= cap_radius)
                  return cap.at(r);
                SectionPoint point = cone.at(r - cap_radius);
                point.height += cap_height;
                return point;
              },
              [=](const double height) {
                return height <= cap_height ?
                         cap.radius(height) :
                         cap_radius + cone.radius(height - cap_height);
              }};
    }



    // With pi r^2 = A(h): 2 pi r = A' h' and 2 pi = A'' h'^2 + A' h''.
    Section
    of_area(const AreaFunction &area)
    {
      return {[area](const double r) -> SectionPoint {
                const double height = area.height(numbers::PI * r * r);
                if (std::isinf(height))
                  return beyond_edge;
                if (height < AreaFunction::smallest_height)
                  return {height, 0., area.tip_curvature()};
                const double derivative = area.derivative(height);
                const double slope      = 2 * numbers::PI * r / derivative;
                return {height,
                        slope,
                        (2 * numbers::PI -
                         area.second_derivative(height) * slope * slope) /
                          derivative};
              },
              [area](const double height) {
                return std::sqrt(area.value(height) / numbers::PI);
              },
              0.75,
              area.is_convex()};
    }
  } // namespace Sections
} // namespace ElastoPlastic
