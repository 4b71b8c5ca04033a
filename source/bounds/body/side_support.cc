// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>

#include "bounds/body/side_support.h"

namespace ElastoPlastic
{
  SideSupport
  support_of(const PlaneBody &body, const unsigned int s)
  {
    constexpr double right_angle = 1e-10;

    const SideCondition &condition = body.conditions[s];
    SideSupport          support;
    if (condition.is_reached)
      {
        support.resists_slip = body.indenter_surface == SurfaceFinish::rough;
        support.velocity     = body.indenter_velocity;
        return support;
      }
    const auto &vertices = body.mesh.sides[s].vertices;
    if (body.is_on_axis(body.mesh.vertices[vertices[0]]) &&
        body.is_on_axis(body.mesh.vertices[vertices[1]]))
      return support;
    const Tensor<1, 2> normal = body.mesh.normal(body.mesh.sides[s]);
    for (const auto &component : condition.components)
      if (component.type == SideConditionType::displacement)
        {
          const double across = component.direction * normal;
          if (std::abs(across) > right_angle)
            support.is_closed = true;
          if (std::abs(cross_product_2d(normal) * component.direction) >
              right_angle)
            support.resists_slip = true;
        }
    return support;
  }
} // namespace ElastoPlastic
