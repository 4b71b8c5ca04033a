// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/largest_error.h"
#include "bounds/conic/tolerances.h"
#include "bounds/mechanism/face_view.h"
#include "bounds/mechanism/velocity_check.h"

namespace ElastoPlastic
{
  namespace
  {
    template <int dim>
    using Velocities = std::vector<SimplexVelocity<dim>>;



    /// The coefficients on a face of the velocity in the direction of the
    /// indenter, and of its own.
    struct AgainstIndenter
    {
      std::vector<double> of_body, of_indenter;
    };

    template <int dim>
    AgainstIndenter
    against_indenter(const SplitBody<dim>  &body,
                     const FaceView<dim>   &view,
                     const Velocities<dim> &velocity)
    {
      const auto    &direction = view.condition.contact().direction;
      constexpr auto degree    = trace_degree<dim>;
      return {Bernstein<dim - 1>::interpolate(
                degree,
                [&](const auto &point) {
                  return -view.velocity_of(0, velocity, point) * direction;
                }),
              Bernstein<dim - 1>::interpolate(degree, [&](const auto &point) {
                return -body.weight(interpolate(point, view.corners)) *
                       (view.support.velocity * direction);
              })};
    }



    template <int dim>
    void
    check_divergence(VelocityErrors             &errors,
                     const SplitBody<dim>       &body,
                     const SimplexVelocity<dim> &velocity,
                     const unsigned int          t)
    {
      SimplexVelocity<dim> polynomial = velocity; // the flux has no divergence
      polynomial.flux                 = Tensor<1, 2>();
      const auto   corners            = body.corners_of(t);
      const double size               = std::pow(volume(corners), 1. / dim);
      for (const auto &point : Bernstein<dim>::points(2))
        {
          const Point<dim> x = interpolate(point, corners);
          if (body.is_on_axis(x))
            continue;
          double divergence =
            trace(polynomial_rate<dim>(corners, velocity, point));
          if (body.is_axisymmetric())
            divergence +=
              weighted_velocity(body, polynomial, t, point)[0] / (x[0] * x[0]);
          keep_largest(errors.divergence, std::abs(divergence) * size);
        }
    }



    template <int dim>
    void
    check_volume(VelocityErrors             &errors,
                 const SplitBody<dim>       &body,
                 const SimplexVelocity<dim> &velocity,
                 const unsigned int          t)
    {
      if (body.has_friction())
        keep_largest(errors.divergence, missing_dilatation(body, velocity, t));
      else if (body.kinematics != Kinematics::plane_stress)
        check_divergence(errors, body, velocity, t);
    }



    // A boundary may be meant to be plane where its faces are not quite. On the
    // axis, weighted velocities say nothing, but the other points do.
    template <int dim>
    void
    check_face(VelocityErrors        &errors,
               const SplitBody<dim>  &body,
               const FaceView<dim>   &view,
               const Velocities<dim> &velocity)
    {
      for (const auto &point : Bernstein<dim - 1>::points(trace_degree<dim>))
        {
          const Point<dim> x = interpolate(point, view.corners);
          if (body.is_on_axis(x))
            continue;
          const Tensor<1, dim> jump =
            view.jump(velocity, point) / body.weight(x);
          const double of_tilt =
            view.face.is_inside() ? 0. : Tolerance::small_angle * jump.norm();
          if (view.face.is_inside() || view.support.is_closed)
            keep_largest(errors.separation,
                         std::abs(jump * view.normal) - of_tilt);
          if (!body.can_slide() && view.resists_slip())
            keep_largest(errors.separation, view.along(jump).norm() - of_tilt);
        }
      if (view.condition.is_reached)
        {
          const auto [of_body, of_indenter] =
            against_indenter(body, view, velocity);
          for (unsigned int i = 0; i < of_body.size(); ++i)
            keep_largest(errors.penetration,
                         (of_indenter[i] - of_body[i]) / body.weight_unit());
        }
    }
  } // namespace



  template <int dim>
  VelocityErrors
  check_velocity(const SplitBody<dim> &body, const Velocities<dim> &velocity)
  {
    VelocityErrors errors;
    for (unsigned int t = 0; t < velocity.size(); ++t)
      check_volume(errors, body, velocity[t], t);
    for (const auto &view : views_of_faces(body))
      check_face(errors, body, view, velocity);
    return errors;
  }



  template <int dim>
  double
  lowest_depth(const SplitBody<dim> &body, const Velocities<dim> &velocity)
  {
    double depth = std::numeric_limits<double>::infinity();
    for (const auto &view : views_of_faces(body))
      if (view.condition.is_reached)
        {
          const auto [of_body, of_indenter] =
            against_indenter(body, view, velocity);
          for (unsigned int i = 0; i < of_body.size(); ++i)
            if (of_indenter[i] > Tolerance::on_axis * body.weight_unit())
              depth = std::min(depth, of_body[i] / of_indenter[i]);
        }
    return depth;
  }



  template <int dim>
  TwoLoads
  power_of_loads(const SplitBody<dim> &body, const Velocities<dim> &velocity)
  {
    TwoLoads power;
    for (unsigned int t = 0; t < velocity.size(); ++t)
      for (const auto &[point, constant, growing] : forces_on(body, t))
        {
          const Tensor<1, dim> v =
            body.angle() * weighted_velocity(body, velocity[t], t, point);
          power.constant += constant * v;
          power.growing += growing * v;
        }
    return power;
  }



  template VelocityErrors
  check_velocity(const SplitBody<2> &, const Velocities<2> &);
  template VelocityErrors
  check_velocity(const SplitBody<3> &, const Velocities<3> &);
  template double
  lowest_depth(const SplitBody<2> &, const Velocities<2> &);
  template double
  lowest_depth(const SplitBody<3> &, const Velocities<3> &);
  template TwoLoads
  power_of_loads(const SplitBody<2> &, const Velocities<2> &);
  template TwoLoads
  power_of_loads(const SplitBody<3> &, const Velocities<3> &);
} // namespace ElastoPlastic
