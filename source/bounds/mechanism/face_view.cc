// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "bounds/mechanism/face_view.h"

namespace ElastoPlastic
{
  template <int dim>
  FaceView<dim>::FaceView(const SplitBody<dim> &body, const unsigned int face)
    : number(face)
    , face(body.mesh.faces[face])
    , condition(body.conditions[face])
    , support(body.support_of(face))
    , corners(body.corners_of_face(face))
    , normal(ElastoPlastic::normal(corners))
    , area(ElastoPlastic::area(corners))
    , body(body)
  {}



  template <int dim>
  Barycentric<dim>
  FaceView<dim>::point(const Barycentric<dim - 1> &position,
                       const unsigned int          i) const
  {
    const auto      &simplex = body.mesh.simplices[face.neighbors[i]];
    Barycentric<dim> result  = {};
    for (unsigned int j = 0; j < dim; ++j)
      result[simplex.place_of_vertex(face.vertices[j])] = position[j];
    return result;
  }



  template <int dim>
  Tensor<1, dim>
  FaceView<dim>::velocity_of(const unsigned int                       i,
                             const std::vector<SimplexVelocity<dim>> &velocity,
                             const Barycentric<dim - 1> &position) const
  {
    const unsigned int t = face.neighbors[i];
    return weighted_velocity(body, velocity[t], t, point(position, i));
  }



  template <int dim>
  Tensor<1, dim>
  FaceView<dim>::jump(const std::vector<SimplexVelocity<dim>> &velocity,
                      const Barycentric<dim - 1>              &position) const
  {
    return velocity_of(0, velocity, position) -
           (face.is_inside() ?
              velocity_of(1, velocity, position) :
              body.weight(interpolate(position, corners)) * support.velocity);
  }



  template <int dim>
  std::vector<FaceView<dim>>
  views_of_faces(const SplitBody<dim> &body)
  {
    std::vector<FaceView<dim>> views;
    for (unsigned int f = 0; f < body.mesh.faces.size(); ++f)
      views.emplace_back(body, f);
    return views;
  }



  template class FaceView<2>;
  template class FaceView<3>;
  template std::vector<FaceView<2>>
  views_of_faces(const SplitBody<2> &);
  template std::vector<FaceView<3>>
  views_of_faces(const SplitBody<3> &);
} // namespace ElastoPlastic
