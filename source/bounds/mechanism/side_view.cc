// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include "bounds/mechanism/side_view.h"

namespace ElastoPlastic
{
  SideView::SideView(const PlaneBody             &body,
                     const unsigned int           side,
                     const std::vector<Neighbor> &neighbors)
    : neighbors(neighbors)
    , side(side)
    , support(support_of(body, side))
    , tangent(-cross_product_2d(body.mesh.normal(body.mesh.sides[side])))
    , normal(body.mesh.normal(body.mesh.sides[side]))
    , length(body.mesh.length(body.mesh.sides[side]))
    , body(body)
  {}



  bool
  SideView::is_inside() const
  {
    return neighbors.size() > 1;
  }



  Bernstein::Barycentric
  SideView::point(const double t, const unsigned int i) const
  {
    const auto [triangle, k]  = neighbors[i];
    const bool same_direction = body.mesh.triangles[triangle].vertices[k] ==
                                body.mesh.sides[side].vertices[0];
    Bernstein::Barycentric result = {};
    result[k]                     = same_direction ? 1. - t : t;
    result[(k + 1) % 3]           = same_direction ? t : 1. - t;
    return result;
  }



  Tensor<1, 2>
  SideView::jump(const std::vector<TriangleVelocity> &velocity,
                 const double                         t) const
  {
    const auto velocity_of = [&](const unsigned int i) {
      const unsigned int triangle = neighbors[i].triangle;
      return weighted_velocity(body, velocity[triangle], triangle, point(t, i));
    };
    if (is_inside())
      return velocity_of(0) - velocity_of(1);
    const auto corners =
      body.mesh.corners(body.mesh.triangles[neighbors[0].triangle]);
    return velocity_of(0) -
           body.weight(position(corners, point(t))) * support.velocity;
  }



  double
  SideView::shear_strength() const
  {
    double smallest = std::numeric_limits<double>::max();
    for (const auto &neighbor : neighbors)
      smallest =
        std::min(smallest, body.materials[neighbor.triangle].yield_radius);
    return std::sqrt(0.5) * smallest;
  }



  std::vector<SideView>
  views_of_sides(const PlaneBody &body)
  {
    std::vector<std::vector<SideView::Neighbor>> neighbors(
      body.mesh.sides.size());
    for (unsigned int t = 0; t < body.mesh.triangles.size(); ++t)
      for (unsigned int k = 0; k < 3; ++k)
        neighbors[body.mesh.triangles[t].sides[k]].push_back({t, k});
    std::vector<SideView> views;
    for (unsigned int s = 0; s < neighbors.size(); ++s)
      views.emplace_back(body, s, neighbors[s]);
    return views;
  }
} // namespace ElastoPlastic
