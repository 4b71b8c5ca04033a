// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_mechanism_side_view_h
#define bounds_mechanism_side_view_h

#include <vector>

#include "bounds/body/side_support.h"
#include "bounds/mechanism/velocity_field.h"

namespace ElastoPlastic
{
  /// A side with the triangles beside it: how a mechanism moves there.
  class SideView
  {
  public:
    /// One of its triangles, whose side number k it is.
    struct Neighbor
    {
      unsigned int triangle;
      unsigned int k;
    };

    SideView(const PlaneBody             &body,
             const unsigned int           side,
             const std::vector<Neighbor> &neighbors);

    /// One, or two inside of the body.
    const std::vector<Neighbor> neighbors;
    const unsigned int          side;
    const SideSupport           support;
    const Tensor<1, 2>          tangent; ///< in the direction of the side
    const Tensor<1, 2>          normal;
    const double                length;

    bool
    is_inside() const;

    /// The point of the first neighbor (or the @p i th) at a position 0 <= @p t
    /// <= 1 of the side.
    Bernstein::Barycentric
    point(const double t, const unsigned int i = 0) const;

    /// The velocity of the first neighbour, weighted like weighted_velocity(),
    /// less that of the second one, or of what the body slides along.
    Tensor<1, 2>
    jump(const std::vector<TriangleVelocity> &velocity, const double t) const;

    /// The yield stress in shear of the weaker neighbour.
    double
    shear_strength() const;

  private:
    const PlaneBody &body;
  };



  /// All sides of the mesh.
  std::vector<SideView>
  views_of_sides(const PlaneBody &body);
} // namespace ElastoPlastic

#endif
