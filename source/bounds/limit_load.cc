// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/quadrature_lib.h>

#include <numeric>

#include "bounds/limit_load.h"
#include "bounds/mechanism/side_view.h"
#include "bounds/mesh/integration.h"
#include "bounds/stress/johnson_mercier.h"
#include "bounds/stress/stress_problem.h"

namespace ElastoPlastic
{
  namespace
  {
    /// The power of the stresses in a triangle. Stresses are quadratic on each
    /// subtriangle, strain rates quadratic at most, but for a flux.
    double
    power_inside(const PlaneBody   &body,
                 const LimitLoad   &bounds,
                 const unsigned int t)
    {
      static const QGaussSimplex<2> quadrature(3);

      double sum = 0;
      for (unsigned int k = 0; k < 3; ++k)
        for (unsigned int q = 0; q < quadrature.size(); ++q)
          {
            const double x = quadrature.point(q)[0], y = quadrature.point(q)[1];
            const auto   stress = bounds.stress.at(t, k, {{1. - x - y, x, y}});
            Bernstein::Barycentric point;
            point.fill(y / 3.);
            point[k] += 1. - x - y;
            point[(k + 1) % 3] += x;
            sum +=
              2. * quadrature.weight(q) / 3. *
              (stress *
               strain_rate_at(body, bounds.velocity.velocity[t], t, point));
          }
      return area(body.mesh.corners(body.mesh.triangles[t])) * sum;
    }



    /// That of the shear stress in what slides along a side.
    double
    power_on_side(const PlaneBody &body,
                  const LimitLoad &bounds,
                  const SideView  &view)
    {
      const auto [t, k]       = view.neighbors[0];
      const auto &side        = body.mesh.sides[view.side];
      const bool  is_reversed = // the side, seen from the triangle
        side.vertices[0] != body.mesh.triangles[t].vertices[k];
      const unsigned int  degree = bounds.stress.degree;
      std::vector<double> shear; // its coefficients, weighted
      for (unsigned int i = 0; i <= degree; ++i)
        shear.push_back(view.tangent *
                        (JohnsonMercier::coefficient(
                           bounds.stress.in_plane[t],
                           k,
                           JohnsonMercier::number_on_line(
                             degree, 0, 1, is_reversed ? degree - i : i)) *
                         view.normal));
      double sum = 0;
      integrate_on_side(
        body.mesh.vertices[side.vertices[0]],
        body.mesh.vertices[side.vertices[1]],
        [&](const double at, const Point<2> &x, const double weight) {
          const auto functions = Bernstein::side_functions(degree, at);
          sum -= weight * view.length *
                 std::inner_product(functions.begin(),
                                    functions.end(),
                                    shear.begin(),
                                    0.) *
                 (view.jump(bounds.velocity.velocity, at) * view.tangent) /
                 body.weight(x);
        });
      return sum;
    }
  } // namespace



  void
  find_gaps(const PlaneBody &body, LimitLoad &bounds)
  {
    bounds.gaps = bounds.velocity.dissipation;
    for (unsigned int t = 0; t < bounds.gaps.size(); ++t)
      bounds.gaps[t] -= body.angle() * power_inside(body, bounds, t);
    for (const SideView &view : views_of_sides(body))
      if (view.is_inside() || view.support.resists_slip)
        for (const auto &neighbor : view.neighbors)
          bounds.gaps[neighbor.triangle] -= body.angle() *
                                            power_on_side(body, bounds, view) /
                                            view.neighbors.size();
  }



  LimitLoad
  bound_limit_load(const PlaneBody &body, const unsigned int degree)
  {
    LimitLoad bounds;
    bounds.stress      = maximize_load(body, degree);
    bounds.velocity    = minimize_plastic_work(body);
    bounds.lower_bound = body.load_factor_unit > 0 ? bounds.stress.load_factor :
                                                     bounds.stress.force;
    bounds.upper_bound = bounds.velocity.bound;
    find_gaps(body, bounds);
    return bounds;
  }
} // namespace ElastoPlastic
