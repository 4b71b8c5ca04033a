// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_mechanism_face_view_h
#define bounds_mechanism_face_view_h

#include <vector>

#include "bounds/mechanism/velocity_field.h"

namespace ElastoPlastic
{
  /// A face with the simplices beside it: how a mechanism moves there.
  template <int dim>
  class FaceView
  {
  public:
    /// @p body must live as long as this object.
    FaceView(const SplitBody<dim> &body, const unsigned int face)
      : number(face)
      , face(body.mesh.faces[face])
      , condition(body.conditions[face])
      , support(body.support_of(face))
      , corners(body.corners_of_face(face))
      , normal(ElastoPlastic::normal(corners))
      , area(ElastoPlastic::area(corners))
      , body(body)
    {}

    const unsigned int                   number; ///< of the face
    const typename SplitMesh<dim>::Face &face;
    const FaceCondition<dim>            &condition;
    const FaceSupport<dim>               support;
    const FaceCorners<dim>               corners;
    const Tensor<1, dim>                 normal;
    const double                         area;

    /// Whether the neighbours, or the body and what is beside it, pay for
    /// sliding along the face.
    bool
    resists_slip() const
    {
      return face.is_inside() || support.resists_slip;
    }

    /// The point of the first neighbour (or the @p i th) at a @p position on
    /// the face.
    Barycentric<dim>
    point(const Barycentric<dim - 1> &position, const unsigned int i = 0) const
    {
      const auto      &simplex = body.mesh.simplices[face.neighbors[i]];
      Barycentric<dim> result  = {};
      for (unsigned int j = 0; j < dim; ++j)
        result[simplex.place_of_vertex(face.vertices[j])] = position[j];
      return result;
    }

    /// The velocity of a neighbour, weighted like weighted_velocity().
    Tensor<1, dim>
    velocity_of(const unsigned int                       i,
                const std::vector<SimplexVelocity<dim>> &velocity,
                const Barycentric<dim - 1>              &position) const
    {
      const unsigned int t = face.neighbors[i];
      return weighted_velocity(body, velocity[t], t, point(position, i));
    }

    /// That of the first neighbour less that of the second one, or of what the
    /// body slides along.
    Tensor<1, dim>
    jump(const std::vector<SimplexVelocity<dim>> &velocity,
         const Barycentric<dim - 1>              &position) const
    {
      return velocity_of(0, velocity, position) -
             (face.is_inside() ?
                velocity_of(1, velocity, position) :
                body.weight(interpolate(position, corners)) * support.velocity);
    }

    /// The part of a velocity along the face.
    Tensor<1, dim>
    along(const Tensor<1, dim> &velocity) const
    {
      return velocity - (velocity * normal) * normal;
    }

  private:
    const SplitBody<dim> &body;
  };



  /// All faces of the mesh.
  template <int dim>
  std::vector<FaceView<dim>>
  views_of_faces(const SplitBody<dim> &body)
  {
    std::vector<FaceView<dim>> views;
    for (unsigned int f = 0; f < body.mesh.faces.size(); ++f)
      views.emplace_back(body, f);
    return views;
  }



  /// A force at a point of a simplex, and what a load factor adds to it.
  template <int dim>
  struct ForceAtPoint
  {
    Barycentric<dim> point;
    Tensor<1, dim>   constant;
    Tensor<1, dim>   growing;
  };

  /// Forces whose power in weighted_velocity(), times SplitBody::angle(), is
  /// that of the given tractions on the faces of a simplex and of the body
  /// force in it. (In the plane, weighted velocities are polynomials of degree
  /// 4, for which that is exact, up to tractions of degree 5.)
  template <int dim>
  std::vector<ForceAtPoint<dim>>
  forces_on(const SplitBody<dim> &body, const unsigned int simplex)
  {
    std::vector<ForceAtPoint<dim>> forces;
    for (const unsigned int f : body.mesh.simplices[simplex].faces)
      for (const auto &component : body.conditions[f].components)
        if (component.type == ConditionType::traction &&
            !(component.value.is_zero() && component.live_load.is_zero()))
          {
            const FaceView<dim> view(body, f);
            integrate_on_face<dim>(
              view.corners,
              [&](const FacePoint<dim> &point, const double weight) {
                const Tensor<1, dim> unit =
                  weight * view.area * component.direction;
                forces.push_back({view.point(point.position),
                                  component.value(point) * unit,
                                  component.live_load(point) * unit});
              });
          }
    if (body.body_force.norm() + body.live_body_force.norm() > 0.)
      for (const auto &[point, weight] : simplex_quadrature<dim>())
        {
          const double size = weight * volume(body.corners_of(simplex));
          forces.push_back(
            {point, size * body.body_force, size * body.live_body_force});
        }
    return forces;
  }
} // namespace ElastoPlastic

#endif
