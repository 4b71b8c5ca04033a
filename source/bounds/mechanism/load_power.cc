// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/quadrature_lib.h>

#include "bounds/mechanism/load_power.h"
#include "bounds/mechanism/side_view.h"
#include "bounds/mesh/integration.h"
#include "bounds/stress/johnson_mercier.h"

namespace ElastoPlastic
{
  namespace
  {
    /// The power of the given tractions on a side.
    void
    add_tractions(LoadPower                           &power,
                  const PlaneBody                     &body,
                  const std::vector<TriangleVelocity> &velocity,
                  const SideView                      &view)
    {
      const unsigned int t        = view.neighbors[0].triangle;
      const auto        &vertices = body.mesh.sides[view.side].vertices;
      for (const auto &component : body.conditions[view.side].components)
        if (component.type == SideConditionType::traction)
          integrate_on_side(
            body.mesh.vertices[vertices[0]],
            body.mesh.vertices[vertices[1]],
            [&](const double at, const Point<2> &x, const double weight) {
              const double along =
                body.angle() * weight * view.length *
                (weighted_velocity(body, velocity[t], t, view.point(at)) *
                 component.direction);
              power.constant += along * component.value(x);
              power.growing += along * component.growth(x);
            });
    }



    /// int v dx over a triangle, or 2 pi int r v. Weighted velocities are
    /// polynomials of degree 4.
    Tensor<1, 2>
    integral_of_velocity(const PlaneBody        &body,
                         const TriangleVelocity &velocity,
                         const unsigned int      t)
    {
      static const QGaussSimplex<2> quadrature(3); // exact for degree 5

      Tensor<1, 2> sum;
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        {
          const double x = quadrature.point(q)[0], y = quadrature.point(q)[1];
          sum += 2. * quadrature.weight(q) *
                 weighted_velocity(body, velocity, t, {{1. - x - y, x, y}});
        }
      return body.angle() * area(body.mesh.corners(body.mesh.triangles[t])) *
             sum;
    }
  } // namespace



  LoadPower
  power_of_loads(const PlaneBody                     &body,
                 const std::vector<TriangleVelocity> &velocity)
  {
    LoadPower power;
    for (const SideView &view : views_of_sides(body))
      add_tractions(power, body, velocity, view);
    for (unsigned int t = 0; t < velocity.size(); ++t)
      {
        const auto integral = integral_of_velocity(body, velocity[t], t);
        power.constant += body.body_force * integral;
        power.growing += body.body_force_growth * integral;
      }
    return power;
  }
} // namespace ElastoPlastic
