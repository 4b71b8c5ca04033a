// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include "bounds/body/yield_norms.h"
#include "bounds/mechanism/face_view.h"
#include "bounds/mechanism/velocity_check.h"
#include "bounds/stress/inverse_square.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Sides of a triangle are divided into so many parts.
    constexpr unsigned int n_side_parts = 4;

    /// The corners of a part of a side or triangle.
    template <int dim>
    using Part = std::array<Barycentric<dim>, dim + 1>;

    /// Those of a side, or of a triangle, whose sides are divided into @p n.
    template <int dim>
    std::vector<Part<dim>>
    divide(const unsigned int n)
    {
      const auto at = [n](const unsigned int i, const unsigned int j) {
        Barycentric<dim> point = {};
        point[0]               = 1. - (i + j) / double(n);
        point[1]               = i / double(n);
        point[dim] += dim == 1 ? 0. : j / double(n);
        return point;
      };
      std::vector<Part<dim>> parts;
      for (unsigned int i = 0; i < n; ++i)
        if constexpr (dim == 1)
          parts.push_back({{at(i, 0), at(i + 1, 0)}});
        else
          for (unsigned int j = 0; i + j < n; ++j)
            {
              parts.push_back({{at(i, j), at(i + 1, j), at(i, j + 1)}});
              if (i + j + 1 < n)
                parts.push_back(
                  {{at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}});
            }
      return parts;
    }



    /// An upper bound of int w |e| dx over a part of a triangle, for the strain
    /// rate e with this @p norm and the weight w of the body.
    double
    integral_of_rate(const SplitBody<2>       &body,
                     const RateNorm           &norm,
                     const Corners<2>         &corners,
                     const SimplexVelocity<2> &velocity,
                     const Part<2>            &part)
    {
      Corners<2>            of_part;
      std::array<double, 3> radii;
      for (unsigned int i = 0; i < 3; ++i)
        {
          of_part[i] = interpolate(part[i], corners);
          radii[i]   = of_part[i][0];
        }
      const auto          weights  = body.weights(of_part);
      const bool          has_flux = velocity.flux.norm() > 0;
      const auto          of_flux  = weighted_flux_rate(velocity);
      const auto          ends = std::minmax({radii[0], radii[1], radii[2]});
      const InverseSquare inverse_square(ends.first, ends.second);
      const auto          rates =
        Bernstein<2>::interpolate(2, [&](const Barycentric<2> &point) {
          auto rate =
            polynomial_rate<2>(corners, velocity, interpolate(point, part));
          if (has_flux)
            rate += inverse_square(interpolate(point, radii)) * of_flux;
          return rate;
        });
      double sum = 0;
      if (has_flux)
        sum += (weights[0] + weights[1] + weights[2]) / 3. *
               inverse_square.error() * norm(rate_in_space(body, of_flux));
      const auto moments = Bernstein<2>::moments(2, weights);
      for (unsigned int p = 0; p < rates.size(); ++p)
        sum += moments[p] * norm(rate_in_space(body, rates[p]));
      return volume(corners) / (n_side_parts * n_side_parts) * sum;
    }



    /// Of a triangle without friction, without its sides.
    double
    work_inside(const SplitBody<2>       &body,
                const SimplexVelocity<2> &velocity,
                const unsigned int        t)
    {
      static const auto parts = divide<2>(n_side_parts);

      const RateNorm norm(body.materials[t]);
      const auto     corners = body.corners_of(t);
      double         sum     = 0;
      for (const auto &part : parts)
        sum += integral_of_rate(body, norm, corners, velocity, part);
      return body.angle() * body.materials[t].yield_radius * sum;
    }



    /// In space without friction, the strain rate is constant.
    double
    work_inside(const SplitBody<3>       &body,
                const SimplexVelocity<3> &velocity,
                const unsigned int        t)
    {
      return volume(body.corners_of(t)) * body.materials[t].yield_radius *
             RateNorm(body.materials[t])(
               strain_rate_at(body, velocity, t, {{1., 0., 0., 0.}}));
    }



    /// Of the slip, whose norm is convex: its mean is at most that of its
    /// coefficients.
    template <int dim>
    double
    work_of_slip(const SplitBody<dim>                    &body,
                 const FaceView<dim>                     &view,
                 const std::vector<SimplexVelocity<dim>> &velocity)
    {
      using Polynomial        = Bernstein<dim - 1>;
      static const auto parts = divide<dim - 1>(dim == 2 ? n_side_parts : 1);

      const SlipNorm<dim> norm(body, view.number);
      double              sum = 0;
      for (const auto &part : parts)
        for (const auto &slip :
             Polynomial::interpolate(slip_degree<dim>, [&](const auto &point) {
               return view.along(view.jump(velocity, interpolate(point, part)));
             }))
          sum += norm(slip);
      return body.angle() * body.shear_strength(view.number) * view.area /
             (parts.size() * Polynomial::n_functions(slip_degree<dim>)) * sum;
    }
  } // namespace



  template <int dim>
  std::vector<double>
  plastic_work(const SplitBody<dim>                    &body,
               const std::vector<SimplexVelocity<dim>> &velocity)
  {
    std::vector<double> work;
    for (unsigned int t = 0; t < velocity.size(); ++t)
      work.push_back(body.has_friction() ? work_of_soil(body, velocity[t], t) :
                                           work_inside(body, velocity[t], t));
    if (!body.can_slide())
      return work;
    for (const auto &view : views_of_faces(body))
      if (view.resists_slip())
        {
          const unsigned int n    = view.face.n_neighbors();
          const double       slip = work_of_slip(body, view, velocity);
          for (unsigned int i = 0; i < n; ++i)
            work[view.face.neighbors[i]] += slip / n;
        }
    return work;
  }



  template std::vector<double>
  plastic_work(const SplitBody<2> &, const std::vector<SimplexVelocity<2>> &);
  template std::vector<double>
  plastic_work(const SplitBody<3> &, const std::vector<SimplexVelocity<3>> &);
} // namespace ElastoPlastic
