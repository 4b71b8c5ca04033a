// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>

#include "indenter/indenter_shapes.h"

namespace ElastoPlastic
{
  namespace
  {
    double
    radians(const double degrees)
    {
      return degrees * numbers::PI / 180;
    }



    Tensor<1, 2>
    direction(const double angle)
    {
      Tensor<1, 2> result;
      result[0] = std::cos(angle);
      result[1] = std::sin(angle);
      return result;
    }



    /// The area between the origin and the arc of the ellipse
    /// x = centre + ratio sqrt(radius^2 - y^2) from 0 to @p y.
    double
    area_within_ellipse(const double centre,
                        const double ratio,
                        const double radius,
                        const double y)
    {
      return 0.5 *
             (centre * y + ratio * radius * radius * std::asin(y / radius));
    }



    class Pyramid : public Indenter<3>
    {
    public:
      explicit Pyramid(const PyramidShape &shape)
        : shape(shape)
        , half_angle(numbers::PI / shape.n_faces)
        , cosine(std::cos(radians(shape.face_angle)))
        , face_slope(1 / std::tan(radians(shape.face_angle)))
        , edge_slope(face_slope * std::cos(half_angle))
        , missing_height(shape.truncation +
                         shape.rounding_radius *
                           (1 / std::sin(radians(shape.face_angle)) - 1))
        , ball(Symmetry::revolution, Sections::circle(shape.rounding_radius))
      {}

      double
      profile(const Point<2> &x) const override
      {
        return surface(x).height;
      }

      IndenterSurface<3>
      surface(const Point<2> &x) const override
      {
        return shape.rounding_radius > 0 ? rounded_surface(x) :
                                           sharp_surface(x);
      }

      IndenterSurface<3>
      surface_for(const Point<2> &origin,
                  const Point<2> &x,
                  const double    body_size) const override
      {
        if (shape.rounding_radius > 0)
          return rounded_surface(x);
        const double rounding = rounding_of_coordinates * body_size;
        if (origin.norm() <= rounding)
          return {0., {}, {}};
        const Tensor<1, 2> edge = sector(origin).edge;
        return (origin - (origin * edge) * edge).norm() <= rounding ?
                 sharp_edge(x, edge) :
                 sharp_surface(x);
      }

      bool
      is_convex() const override
      {
        return true;
      }

      // 2 n halves of faces: of the rounded pyramid, the section is the circle
      // of the ball below the edges. Above, it is cut off by ellipses, the
      // sections of the edges; and where the ball ends, there are straight
      // lines between them.
      double
      section_area(const double height) const override
      {
        const double R    = shape.rounding_radius;
        const double foot = (height + missing_height) / face_slope;
        if (R == 0)
          return shape.n_faces * std::tan(half_angle) * foot * foot;

        const double above  = std::max(0., R - height); // to the ball's centre
        const double circle = std::sqrt(height * std::max(0., 2 * R - height));
        if (circle < edge_slope * above)
          return numbers::PI * circle * circle;

        const double centre = (height - R) / edge_slope;
        const double ratio  = std::hypot(1., 1 / edge_slope);
        double       half_face;
        if (circle < face_slope * above)
          {
            const double angle = std::acos(edge_slope * above / circle);
            half_face =
              0.5 * circle * circle * (half_angle - angle) +
              area_within_ellipse(centre, ratio, R, circle * std::sin(angle));
          }
        else
          half_face = 0.5 * foot * (foot - R * cosine) * std::tan(half_angle) +
                      area_within_ellipse(centre,
                                          ratio,
                                          R,
                                          R * cosine * std::sin(half_angle));
        return 2 * shape.n_faces * half_face;
      }

    private:
      /// The half of a face that a point lies in: the horizontal directions of
      /// the face's normal and of the edge next to the point.
      struct Sector
      {
        Tensor<1, 2> normal, edge;
      };

      Sector
      sector(const Point<2> &x) const
      {
        const double angle = std::atan2(x[1], x[0]) - radians(shape.rotation);
        const double face =
          2 * half_angle * std::round(angle / (2 * half_angle));
        const double normal = radians(shape.rotation) + face;
        return {direction(normal),
                direction(normal + (angle < face ? -half_angle : half_angle))};
      }

      IndenterSurface<3>
      sharp_surface(const Point<2> &x) const
      {
        const IndenterSurface<3> on_face = face(x, sector(x).normal);
        return on_face.height > 0 ? on_face : IndenterSurface<3>{0., {}, {}};
      }

      IndenterSurface<3>
      sharp_edge(const Point<2> &x, const Tensor<1, 2> &edge) const
      {
        const double height = edge_slope * (x * edge) - missing_height;
        if (height <= 0)
          return {0., {}, {}};
        return {height, edge_slope * edge, {}};
      }

      // A ball that touches the surface above x from inside has its centre on a
      // face of the pyramid that all centres fill, on an edge of it, or in its
      // tip.
      IndenterSurface<3>
      rounded_surface(const Point<2> &x) const
      {
        const double       R      = shape.rounding_radius;
        const Sector       s      = sector(x);
        const Tensor<1, 2> across = x - (x * s.edge) * s.edge;
        if (across.norm() >= R * cosine * std::sin(half_angle))
          return face(x, s.normal);

        const double height_of_centre =
          std::sqrt(std::max(0., R * R - x.square()));
        return x * s.edge > edge_slope * height_of_centre ?
                 rounded_edge(x, s.edge) :
                 ball.surface(x);
      }

      IndenterSurface<3>
      face(const Point<2> &x, const Tensor<1, 2> &normal) const
      {
        return {face_slope * (x * normal) - missing_height,
                face_slope * normal,
                {}};
      }

      // An oblique cylinder: along the edge it rises with the edge's slope.
      IndenterSurface<3>
      rounded_edge(const Point<2> &x, const Tensor<1, 2> &edge) const
      {
        const double       R        = shape.rounding_radius;
        const double       oblique  = std::hypot(1., edge_slope);
        const double       along    = x * edge;
        const Tensor<1, 2> across   = x - along * edge;
        const double       leg      = std::sqrt(R * R - across.norm_square());
        const Tensor<1, 2> sideways = cross_product_2d(edge);
        return {R + edge_slope * along - oblique * leg,
                edge_slope * edge + oblique / leg * across,
                oblique * R * R / Utilities::fixed_power<3>(leg) *
                  symmetrize(outer_product(sideways, sideways))};
      }

      const PyramidShape shape;
      const double       half_angle; ///< of a face, seen from above
      const double       cosine;     ///< of the face angle
      const double       face_slope, edge_slope;
      /// What is missing of the sharp tip.
      const double               missing_height;
      const IndenterSymmetric<3> ball;
    };
  } // namespace



  std::unique_ptr<Indenter<3>>
  make_pyramid(const PyramidShape &shape)
  {
    return std::make_unique<Pyramid>(shape);
  }



  double
  semi_apex_angle_of_cone(const PyramidShape &shape)
  {
    const double area =
      shape.n_faces * std::tan(numbers::PI / shape.n_faces) / numbers::PI;
    return std::atan(std::sqrt(area) * std::tan(radians(shape.face_angle))) *
           180 / numbers::PI;
  }
} // namespace ElastoPlastic
