// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "bounds/body/split_body.h"
#include "bounds/conic/side_by_side.h"
#include "bounds/limit_load.h"
#include "bounds/mechanism/face_view.h"
#include "bounds/mesh/density_transfer.h"
#include "bounds/stress/johnson_mercier.h"

namespace ElastoPlastic
{
  namespace
  {
    /// The power of the stresses in a simplex. In the plane, stresses are
    /// quadratic on each part at most, and so are strain rates, but for a flux;
    /// in space both are linear at most. What the weighted stresses lack of the
    /// pressure of body forces counts only with friction: else velocities
    /// change no volume.
    template <int dim>
    double
    power_inside(const LimitLoad<dim> &bounds, const unsigned int t)
    {
      constexpr unsigned int n_parts = JohnsonMercier<dim>::n_parts;
      const auto            &body    = bounds.body_of_velocity;

      double sum = 0;
      for (unsigned int k = 0; k < n_parts; ++k)
        for (const auto &[inside, weight] : simplex_quadrature<dim>())
          {
            const auto point = point_of_part<dim>(k, inside);
            const auto rate =
              strain_rate_at(body, bounds.velocity.velocity[t], t, point);
            double power = bounds.stress.at(t, k, inside) * rate;
            if (body.has_friction())
              {
                const Point<dim> x = interpolate(point, body.corners_of(t));
                power -=
                  body.weight(x) *
                  body.pressure_of_body_force(x, bounds.stress.load_factor) *
                  trace(rate);
              }
            sum += weight / n_parts * power;
          }
      return volume(body.corners_of(t)) * sum;
    }



    /// That of the shear stress in what slides along a face.
    template <int dim>
    double
    power_on_face(const LimitLoad<dim> &bounds, const FaceView<dim> &view)
    {
      const auto        &body = bounds.body_of_velocity;
      const unsigned int t    = view.face.neighbors[0];
      const auto         tractions =
        bounds.stress.tractions(body.mesh,
                                t,
                                body.mesh.simplices[t].place_of_face(
                                  view.number),
                                body.outward_normal(view.number));
      double sum = 0;
      integrate_on_face<dim>(
        view.corners, [&](const FacePoint<dim> &point, const double weight) {
          const Tensor<1, dim> traction =
            Bernstein<dim - 1>::value(bounds.stress.degree,
                                      tractions.begin(),
                                      point.position);
          sum -= weight * view.area *
                 (view.along(traction) *
                  view.jump(bounds.velocity.velocity, point.position)) /
                 body.weight(point.x);
        });
      return sum;
    }



    /// Computes the gaps from stress and velocity. Also of stresses on another
    /// mesh, the power in a simplex or on a face is not more than the work of
    /// velocities that change no volume, or that the flow rule of soil admits:
    /// that follows from the yield condition alone.
    template <int dim>
    void
    find_gaps(LimitLoad<dim> &bounds)
    {
      const double angle = bounds.body_of_velocity.angle();
      bounds.gaps        = bounds.velocity.dissipation;
      for (unsigned int t = 0; t < bounds.gaps.size(); ++t)
        bounds.gaps[t] -= angle * power_inside(bounds, t);
      for (const auto &view : views_of_faces(bounds.body_of_velocity))
        if (view.resists_slip())
          {
            const unsigned int n     = view.face.n_neighbors();
            const double       power = angle * power_on_face(bounds, view) / n;
            for (unsigned int i = 0; i < n; ++i)
              bounds.gaps[view.face.neighbors[i]] -= power;
          }
    }
  } // namespace



  template <int dim>
  ExpectedMultipliers
  expected_multipliers(const LimitLoad<dim> &bounds,
                       const SplitMesh<dim> &last,
                       const SplitMesh<dim> &next)
  {
    return {DensityTransfer<dim>(last, bounds.stress.multipliers).on(next),
            DensityTransfer<dim>(last, bounds.velocity.multipliers).on(next)};
  }



  template <int dim>
  LimitLoad<dim>
  bound_limit_load(const SplitBody<dim>      &body,
                   const unsigned int         degree,
                   const double               tolerance,
                   const ExpectedMultipliers &expected)
  {
    LimitLoad<dim> bounds;
    bounds.body_of_velocity = circumscribe(body);
    const auto find_stress  = [&]() {
      bounds.stress =
        maximize_load(body, degree, tolerance, expected.of_stress);
    };
    const auto find_velocity = [&]() {
      bounds.velocity = minimize_plastic_work(bounds.body_of_velocity,
                                              tolerance,
                                              expected.of_velocity);
    };
    call_side_by_side(find_stress, find_velocity);
    bounds.lower_bound = body.load_factor_unit > 0 ? bounds.stress.load_factor :
                                                     bounds.stress.force;
    bounds.upper_bound = bounds.velocity.bound;
    find_gaps(bounds);
    return bounds;
  }



  template ExpectedMultipliers
  expected_multipliers(const LimitLoad<2> &,
                       const SplitMesh<2> &,
                       const SplitMesh<2> &);
  template ExpectedMultipliers
  expected_multipliers(const LimitLoad<3> &,
                       const SplitMesh<3> &,
                       const SplitMesh<3> &);
  template LimitLoad<2>
  bound_limit_load(const SplitBody<2> &,
                   const unsigned int,
                   const double,
                   const ExpectedMultipliers &);
  template LimitLoad<3>
  bound_limit_load(const SplitBody<3> &,
                   const unsigned int,
                   const double,
                   const ExpectedMultipliers &);
} // namespace ElastoPlastic
