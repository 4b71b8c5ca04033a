// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_mechanism_velocity_field_h
#define bounds_mechanism_velocity_field_h

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <array>
#include <vector>

#include "base/tensors.h"
#include "bounds/body/split_body.h"
#include "bounds/stress/bernstein.h"

namespace ElastoPlastic
{
  /// The degree of the velocity as a polynomial on a simplex, and on faces that
  /// of the weighted one, and of what slides along them: in space, velocities
  /// that do are linear.
  template <int dim>
  constexpr unsigned int velocity_degree = dim == 2 ? 3 : 2;
  template <int dim>
  constexpr unsigned int trace_degree = dim == 2 ? 4 : 2;
  template <int dim>
  constexpr unsigned int slip_degree = dim == 2 ? 4 : 1;



  /// The velocity on a simplex: a polynomial, given by its coefficients in
  /// Bernstein's basis.
  template <int dim>
  struct SimplexVelocity
  {
    std::array<Tensor<1, dim>,
               Bernstein<dim>::n_functions(velocity_degree<dim>)>
      coefficients = {};

    /// The gradient (a, b) of the stream function of a flow past the axis of a
    /// body of revolution: its velocity (-b, a) / r, which changes no volume
    /// either, is added. It is zero in triangles that touch the axis, and
    /// elsewhere.
    Tensor<1, 2> flux;

    void
    add(const double factor, const SimplexVelocity &other)
    {
      for (unsigned int i = 0; i < coefficients.size(); ++i)
        coefficients[i] += factor * other.coefficients[i];
      flux += factor * other.flux;
    }

    void
    operator*=(const double factor)
    {
      for (auto &coefficient : coefficients)
        coefficient *= factor;
      flux *= factor;
    }

    /// Without the flux, at a point.
    Tensor<1, dim>
    polynomial(const Barycentric<dim> &point) const
    {
      return Bernstein<dim>::value(velocity_degree<dim>,
                                   coefficients.begin(),
                                   point);
    }
  };



  /// A mechanism of collapse, and the bound of the limit load that it gives.
  template <int dim>
  struct VelocityField
  {
    /// By simplices; the indenter moves down by 1, or 1 is the largest velocity
    /// if other loads grow. Neighbours may slide along each other.
    std::vector<SimplexVelocity<dim>> velocity;

    /// By simplices: an upper bound of the plastic work in it and on its faces.
    /// Neighbours share that on the face between them.
    std::vector<double> dissipation;

    /// Plastic work less the power of the constant loads: per unit of depth, or
    /// by that of the loads that grow.
    double bound = 0;
    /// See VelocityErrors::largest().
    double error = 0;
    /// By simplices, see ConicSolution::multipliers.
    std::vector<double> multipliers;
    unsigned int        n_iterations = 0;
    /// False if rounding errors have ended the minimisation early.
    bool is_optimal = true;
  };



  /// The velocity (-b, a) of a stream function with the gradient (a, b).
  inline Tensor<1, 2>
  velocity_of_stream(const Tensor<1, 2> &gradient)
  {
    return -cross_product_2d(gradient);
  }



  /// The velocity with the values value(point) at the Bernstein points.
  template <int dim, typename Value>
  SimplexVelocity<dim>
  interpolate_velocity(const Value &value)
  {
    const auto coefficients =
      Bernstein<dim>::interpolate(velocity_degree<dim>, value);
    SimplexVelocity<dim> result;
    std::copy(coefficients.begin(),
              coefficients.end(),
              result.coefficients.begin());
    return result;
  }

  /// The velocity at a @p point of a simplex; times the distance from the axis
  /// in a body of revolution, so that it is a polynomial.
  template <int dim>
  Tensor<1, dim>
  weighted_velocity(const SplitBody<dim>       &body,
                    const SimplexVelocity<dim> &velocity,
                    const unsigned int          simplex,
                    const Barycentric<dim>     &point)
  {
    Tensor<1, dim> result =
      body.weight(interpolate(point, body.corners_of(simplex))) *
      velocity.polynomial(point);
    if constexpr (dim == 2)
      result += velocity_of_stream(velocity.flux);
    return result;
  }

  /// The velocity at a point of a simplex.
  template <int dim>
  Tensor<1, dim>
  velocity_at(const SplitBody<dim>       &body,
              const SimplexVelocity<dim> &velocity,
              const unsigned int          simplex,
              const Barycentric<dim>     &point)
  {
    Tensor<1, dim> result = velocity.polynomial(point);
    if constexpr (dim == 2)
      if (velocity.flux.norm() > 0)
        result += velocity_of_stream(velocity.flux) /
                  interpolate(point, body.corners_of(simplex))[0];
    return result;
  }

  /// The largest of those at the corners and centres of gravity.
  template <int dim>
  double
  largest_velocity(const SplitBody<dim>                    &body,
                   const std::vector<SimplexVelocity<dim>> &velocity)
  {
    double largest = 0;
    for (unsigned int t = 0; t < velocity.size(); ++t)
      for (unsigned int k = 0; k <= dim; ++k)
        for (unsigned int i = 0; i <= dim; ++i)
          largest =
            std::max(largest,
                     velocity_at(body,
                                 velocity[t],
                                 t,
                                 point_of_part<dim>(k, corner_position<dim>(i)))
                       .norm());
    return largest;
  }

  /// The strain rate in the coordinates of the mesh of the polynomial part of a
  /// velocity.
  template <int dim>
  SymmetricTensor<2, dim>
  polynomial_rate(const Corners<dim>         &corners,
                  const SimplexVelocity<dim> &velocity,
                  const Barycentric<dim>     &point)
  {
    return Bernstein<dim>::symmetric_gradient(corners,
                                              velocity_degree<dim>,
                                              velocity.coefficients.begin(),
                                              point);
  }

  /// That of the other part, times r^2.
  inline SymmetricTensor<2, 2>
  weighted_flux_rate(const SimplexVelocity<2> &velocity)
  {
    SymmetricTensor<2, 2> rate;
    rate[0][0] = velocity.flux[1];
    rate[0][1] = -0.5 * velocity.flux[0];
    return rate;
  }

  /// The strain rate in space with these components in the plane.
  template <int dim>
  SymmetricTensor<2, 3>
  rate_in_space(const SplitBody<dim> &body, const SymmetricTensor<2, dim> &rate)
  {
    return in_space<dim>(
      rate, body.kinematics == Kinematics::cartesian ? 0. : -trace(rate));
  }

  /// The strain rate at a point of a simplex; out of plane it is zero in plane
  /// strain, v_r / r in a body of revolution with friction (on the axis, where
  /// v_r vanishes, its limit d_r v_r), or else keeps the volume.
  template <int dim>
  SymmetricTensor<2, 3>
  strain_rate_at(const SplitBody<dim>       &body,
                 const SimplexVelocity<dim> &velocity,
                 const unsigned int          simplex,
                 const Barycentric<dim>     &point)
  {
    const auto       corners = body.corners_of(simplex);
    const Point<dim> x       = interpolate(point, corners);
    auto             rate    = polynomial_rate<dim>(corners, velocity, point);
    if (body.is_axisymmetric() && body.has_friction())
      return in_space<dim>(rate,
                           body.is_on_axis(x) ?
                             rate[0][0] :
                             velocity.polynomial(point)[0] / x[0]);
    if constexpr (dim == 2)
      if (velocity.flux.norm() > 0)
        rate += weighted_flux_rate(velocity) / (x[0] * x[0]);
    return rate_in_space(body, rate);
  }
} // namespace ElastoPlastic

#endif
