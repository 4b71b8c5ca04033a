// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include "base/largest_error.h"
#include "bounds/mechanism/side_view.h"
#include "bounds/mechanism/velocity_check.h"
#include "bounds/stress/inverse_square.h"

namespace ElastoPlastic
{
  namespace
  {
    using namespace Bernstein;

    /// Sides of a triangle are divided into so many parts.
    constexpr unsigned int n_side_parts = 4;

    /// Of the weighted velocity on sides.
    constexpr unsigned int trace_degree = 4;

    using Velocities = std::vector<TriangleVelocity>;

    /// The corners of a part of a triangle.
    using Part = std::array<Barycentric, 3>;



    Barycentric
    combination(const Part &part, const Barycentric &point)
    {
      Barycentric result = {};
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          result[j] += point[i] * part[i][j];
      return result;
    }



    std::vector<Part>
    parts_of_triangle()
    {
      const auto at = [](const unsigned int i, const unsigned int j) {
        const double step = 1. / n_side_parts;
        return Barycentric{{1. - (i + j) * step, i * step, j * step}};
      };
      std::vector<Part> parts;
      for (unsigned int i = 0; i < n_side_parts; ++i)
        for (unsigned int j = 0; i + j < n_side_parts; ++j)
          {
            parts.push_back({{at(i, j), at(i + 1, j), at(i, j + 1)}});
            if (i + j + 1 < n_side_parts)
              parts.push_back({{at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}});
          }
      return parts;
    }



    /// An upper bound of int w |e| dx over a part of a triangle, for the strain
    /// rate e and the weight w of the body.
    double
    integral_of_rate(const PlaneBody               &body,
                     const std::array<Point<2>, 3> &corners,
                     const TriangleVelocity        &velocity,
                     const Part                    &part)
    {
      std::array<double, 3> weights, radii;
      for (unsigned int i = 0; i < 3; ++i)
        {
          const Point<2> corner = position(corners, part[i]);
          radii[i]              = corner[0];
          weights[i]            = body.weight(corner);
        }
      std::array<SymmetricTensor<2, 2>, n_quadratics> rates;
      for (unsigned int p = 0; p < n_quadratics; ++p)
        rates[p] = polynomial_rate(corners,
                                   velocity,
                                   combination(part, quadratic_points()[p]));
      double sum = 0;
      if (velocity.flux.norm() > 0)
        {
          const auto [r_min, r_max] =
            std::minmax({radii[0], radii[1], radii[2]});
          const InverseSquare inverse_square(r_min, r_max);
          const auto          rate = weighted_flux_rate(velocity);
          for (unsigned int p = 0; p < n_quadratics; ++p)
            {
              const auto &[a, b, c] = quadratic_points()[p];
              rates[p] +=
                inverse_square(a * radii[0] + b * radii[1] + c * radii[2]) *
                rate;
            }
          sum += (weights[0] + weights[1] + weights[2]) / 3. *
                 inverse_square.error() * rate_in_space(body, rate).norm();
        }
      const auto moments = quadratic_moments(weights);
      for (unsigned int p = 0; p < n_quadratics; ++p)
        {
          SymmetricTensor<2, 2> coefficient;
          for (unsigned int q = 0; q < n_quadratics; ++q)
            coefficient += quadratic_coefficients()(p, q) * rates[q];
          sum += moments[p] * rate_in_space(body, coefficient).norm();
        }
      return area(corners) / (n_side_parts * n_side_parts) * sum;
    }



    /// Of a triangle, without its sides.
    double
    work_inside(const PlaneBody        &body,
                const TriangleVelocity &velocity,
                const unsigned int      t)
    {
      static const std::vector<Part> parts = parts_of_triangle();

      const auto corners = body.mesh.corners(body.mesh.triangles[t]);
      double     sum     = 0;
      for (const Part &part : parts)
        sum += integral_of_rate(body, corners, velocity, part);
      return body.materials[t].yield_radius * sum;
    }



    /// The coefficients of a polynomial of the position on the interval from
    /// @p begin to @p end of a side.
    template <typename Function>
    std::array<double, trace_degree + 1>
    on_interval(const double begin, const double end, const Function &function)
    {
      std::array<double, trace_degree + 1> result = {};
      for (unsigned int p = 0; p <= trace_degree; ++p)
        {
          const double value =
            function(begin + (end - begin) * p / trace_degree);
          for (unsigned int i = 0; i <= trace_degree; ++i)
            result[i] += side_coefficients(trace_degree)(i, p) * value;
        }
      return result;
    }



    double
    work_of_slip(const SideView &view, const Velocities &velocity)
    {
      double sum = 0;
      for (unsigned int part = 0; part < n_side_parts; ++part)
        for (const double coefficient :
             on_interval(part / static_cast<double>(n_side_parts),
                         (part + 1.) / n_side_parts,
                         [&](const double t) {
                           return view.jump(velocity, t) * view.tangent;
                         }))
          sum += std::abs(coefficient);
      return view.shear_strength() * view.length /
             (n_side_parts * (trace_degree + 1.)) * sum;
    }



    /// The velocity in the direction of the indenter, and its own: the
    /// coefficients on a side.
    using AgainstIndenter = std::pair<std::array<double, trace_degree + 1>,
                                      std::array<double, trace_degree + 1>>;

    AgainstIndenter
    against_indenter(const PlaneBody  &body,
                     const SideView   &view,
                     const Velocities &velocity)
    {
      const auto &direction =
        body.conditions[view.side].components[1].direction;
      const unsigned int t       = view.neighbors[0].triangle;
      const auto         corners = body.mesh.corners(body.mesh.triangles[t]);
      return {on_interval(0.,
                          1.,
                          [&](const double position) {
                            return -weighted_velocity(body,
                                                      velocity[t],
                                                      t,
                                                      view.point(position)) *
                                   direction;
                          }),
              on_interval(0., 1., [&](const double at) {
                return -body.weight(position(corners, view.point(at))) *
                       (view.support.velocity * direction);
              })};
    }



    void
    check_divergence(VelocityErrors         &errors,
                     const PlaneBody        &body,
                     const TriangleVelocity &velocity,
                     const unsigned int      t)
    {
      TriangleVelocity polynomial = velocity; // the flux has no divergence
      polynomial.flux             = Tensor<1, 2>();
      const auto corners          = body.mesh.corners(body.mesh.triangles[t]);
      for (const Barycentric &point : quadratic_points())
        {
          const Point<2> x = position(corners, point);
          if (body.is_on_axis(x))
            continue;
          double divergence = trace(polynomial_rate(corners, velocity, point));
          if (body.is_axisymmetric())
            divergence += velocity_at(body, polynomial, t, point)[0] / x[0];
          enlarge(errors.divergence,
                  std::abs(divergence) * std::sqrt(area(corners)));
        }
    }



    void
    check_side(VelocityErrors   &errors,
               const PlaneBody  &body,
               const SideView   &view,
               const Velocities &velocity)
    {
      const bool slips = body.kinematics != Kinematics::plane_stress;
      for (unsigned int p = 0; p <= trace_degree; ++p)
        {
          const Tensor<1, 2> jump =
            view.jump(velocity, p / static_cast<double>(trace_degree)) /
            body.weight_unit();
          if (view.is_inside() || view.support.is_closed)
            enlarge(errors.separation, std::abs(jump * view.normal));
          if (!slips && (view.is_inside() || view.support.resists_slip))
            enlarge(errors.separation, std::abs(jump * view.tangent));
        }
      if (body.conditions[view.side].is_reached)
        {
          const auto [of_body, of_indenter] =
            against_indenter(body, view, velocity);
          for (unsigned int i = 0; i < of_body.size(); ++i)
            enlarge(errors.penetration,
                    (of_indenter[i] - of_body[i]) / body.weight_unit());
        }
    }
  } // namespace



  double
  VelocityErrors::largest() const
  {
    return std::max({divergence, separation, penetration});
  }



  VelocityErrors
  check_velocity(const PlaneBody &body, const Velocities &velocity)
  {
    VelocityErrors errors;
    if (body.kinematics != Kinematics::plane_stress)
      for (unsigned int t = 0; t < velocity.size(); ++t)
        check_divergence(errors, body, velocity[t], t);
    for (const SideView &view : views_of_sides(body))
      check_side(errors, body, view, velocity);
    return errors;
  }



  double
  lowest_depth(const PlaneBody &body, const Velocities &velocity)
  {
    constexpr double rounding = 1e-12;

    double depth = std::numeric_limits<double>::infinity();
    for (const SideView &view : views_of_sides(body))
      if (body.conditions[view.side].is_reached)
        {
          const auto [of_body, of_indenter] =
            against_indenter(body, view, velocity);
          for (unsigned int i = 0; i < of_body.size(); ++i)
            if (of_indenter[i] > rounding * body.weight_unit())
              depth = std::min(depth, of_body[i] / of_indenter[i]);
        }
    return depth;
  }



  std::vector<double>
  plastic_work(const PlaneBody &body, const Velocities &velocity)
  {
    std::vector<double> work;
    for (unsigned int t = 0; t < velocity.size(); ++t)
      work.push_back(body.angle() * work_inside(body, velocity[t], t));
    if (body.kinematics == Kinematics::plane_stress)
      return work;
    for (const SideView &view : views_of_sides(body))
      if (view.is_inside() || view.support.resists_slip)
        for (const auto &neighbor : view.neighbors)
          work[neighbor.triangle] +=
            body.angle() * work_of_slip(view, velocity) / view.neighbors.size();
    return work;
  }

} // namespace ElastoPlastic
