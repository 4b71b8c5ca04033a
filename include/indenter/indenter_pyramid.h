// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef indenter_indenter_pyramid_h
#define indenter_indenter_pyramid_h

#include "indenter/indenter_shapes.h"

namespace ElastoPlastic
{
  /// A regular pyramid: those of Vickers, Berkovich and the corner of a cube.
  /// Its tip is sharp, rounded, or cut off.
  ///
  /// The rounded pyramid is what a ball reaches from inside the sharp one: its
  /// tip is a part of the ball, its edges are parts of cylinders of the same
  /// radius, and both are tangent to the faces, which are plane as before.
  class IndenterPyramid : public Indenter<3>
  {
  public:
    struct Shape
    {
      unsigned int n_faces    = 4;  ///< at least 3
      double       face_angle = 68; ///< between axis and face, in degrees
      /// From the x axis to the horizontal normal of the first face, about the
      /// vertical axis, in degrees.
      double rotation        = 0;
      double rounding_radius = 0; ///< 0: not rounded
      /// The height of what is cut off the sharp tip; 0 if it is rounded.
      double truncation = 0;
    };

    explicit IndenterPyramid(const Shape &shape);

    /// Between axis and flank of the cone that displaces the same volume as the
    /// sharp pyramid, in degrees.
    static double
    semi_apex_angle_of_cone(const Shape &shape);

    double
    profile(const Point<2> &x) const override
    {
      return surface(x).height;
    }

    IndenterSurface<3>
    surface(const Point<2> &x) const override
    {
      return shape.rounding_radius > 0 ? rounded_surface(x) : sharp_surface(x);
    }

    IndenterSurface<3>
    surface_for(const Point<2> &origin,
                const Point<2> &x,
                const double    body_size) const override;

    bool
    is_convex() const override
    {
      return true;
    }

    double
    section_area(const double height) const override;

  private:
    /// The half of a face that a point lies in: the horizontal directions of
    /// the face's normal and of the edge next to the point.
    struct Sector
    {
      Tensor<1, 2> normal, edge;
    };

    Sector
    sector(const Point<2> &x) const;

    IndenterSurface<3>
    sharp_surface(const Point<2> &x) const;

    IndenterSurface<3>
    sharp_edge(const Point<2> &x, const Tensor<1, 2> &edge) const;

    IndenterSurface<3>
    rounded_surface(const Point<2> &x) const;

    IndenterSurface<3>
    face(const Point<2> &x, const Tensor<1, 2> &normal) const
    {
      return {face_slope * (x * normal) - missing_height,
              face_slope * normal,
              {}};
    }

    IndenterSurface<3>
    rounded_edge(const Point<2> &x, const Tensor<1, 2> &edge) const;

    const Shape  shape;
    const double half_angle; ///< of a face, seen from above
    const double cosine;     ///< of the face angle
    const double face_slope, edge_slope;
    /// What is missing of the sharp tip.
    const double               missing_height;
    const IndenterSymmetric<3> ball;
  };
} // namespace ElastoPlastic

#endif
