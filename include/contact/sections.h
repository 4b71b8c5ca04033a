// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_sections_h
#define contact_sections_h

#include <functional>

namespace ElastoPlastic
{
  /// Half of a symmetric profile: the height above the tip as a function of
  /// the distance r >= 0 from the axis or plane of symmetry; +infinity beyond
  /// the edge. IndenterSymmetric turns a section into a body.
  struct Section
  {
    /// Convex, and growing, where it is finite.
    std::function<double(const double r)> profile;
    /// TipShape::depth_factor().
    double depth_factor = 0.75;
  };

  namespace Sections
  {
    /// The lower half of a circle, R - sqrt(R^2 - r^2) without cancellation.
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
  } // namespace Sections
} // namespace ElastoPlastic

#endif
