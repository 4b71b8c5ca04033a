// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef indenter_sections_h
#define indenter_sections_h

#include <functional>
#include <limits>

#include "indenter/area_function.h"

namespace ElastoPlastic
{
  /// A section at a distance r from the axis or plane of symmetry.
  struct SectionPoint
  {
    double height;    ///< above the tip; +infinity beyond the edge
    double slope;     ///< d height / d r; 0 beyond the edge
    double curvature; ///< d^2 height / d r^2; 0 beyond the edge
  };



  /// Half of a symmetric profile. IndenterSymmetric turns it into a body.
  struct Section
  {
    /// For r >= 0. The height grows, where it is finite.
    std::function<SectionPoint(const double r)> at;
    /// The largest r with no more than a height > 0.
    std::function<double(const double height)> radius;
    /// TipShape::depth_factor().
    double depth_factor = 0.75;
    /// Indenter::is_convex().
    bool is_convex = true;
    /// The height is infinite for larger r.
    double edge = std::numeric_limits<double>::infinity();
  };

  namespace Sections
  {
    /// The lower half of a circle, R - sqrt(R^2 - r^2) without cancellation.
    /// Its slope, infinite at the equator, is bounded by 1e5.
    Section
    circle(const double radius);

    /// r^2 / 2R, where R is the radius of curvature at the tip. This is what
    /// Hertz' theory assumes of a sphere.
    Section
    parabola(const double radius_of_curvature);

    /// A straight flank, r / tan(angle).
    /// @param semi_apex_angle between axis and flank, in degrees.
    Section
    flank(const double semi_apex_angle);

    /// A flat face.
    Section
    face(const double half_width);

    /// A straight flank with a cap, a part of a circle that is tangent to it.
    /// @param semi_apex_angle between axis and flank, in degrees.
    Section
    spheroconical(const double radius, const double semi_apex_angle);

    /// The body of revolution with the sections of an area function.
    Section
    of_area(const AreaFunction &area);
  } // namespace Sections
} // namespace ElastoPlastic

#endif
