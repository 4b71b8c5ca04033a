// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_mechanism_velocity_field_h
#define bounds_mechanism_velocity_field_h

#include <deal.II/base/symmetric_tensor.h>

#include <array>
#include <vector>

#include "bounds/body/plane_body.h"
#include "bounds/stress/bernstein.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// The velocity on a triangle: a cubic polynomial, and in a body of
  /// revolution the velocity (-b, a) / r, which changes no volume either. It is
  /// that of a flow past the axis whose stream function has the gradient
  /// (a, b).
  struct TriangleVelocity
  {
    /// Of the polynomial, in Bernstein's basis.
    std::array<Tensor<1, 2>, Bernstein::n_cubics> coefficients = {};

    /// (a, b); zero in triangles that touch the axis.
    Tensor<1, 2> flux;
  };



  /// A mechanism of collapse, and the bound of the limit load that it gives.
  struct VelocityField
  {
    /// By triangles; the indenter moves down by 1, or 1 is the largest velocity
    /// if other loads grow. Neighbours may slide along each other.
    std::vector<TriangleVelocity> velocity;

    /// By triangles: an upper bound of the plastic work in it and on its sides.
    /// Neighbours share that on the side between them.
    std::vector<double> dissipation;

    /// Plastic work less the power of the constant loads: per unit of depth, or
    /// by that of the loads that grow.
    double bound = 0;
    /// See VelocityErrors::largest().
    double       error        = 0;
    unsigned int n_iterations = 0;
    /// False if rounding errors have ended the minimisation early.
    bool is_optimal = true;
  };



  inline void
  scale(VelocityField &field, const double factor)
  {
    for (TriangleVelocity &velocity : field.velocity)
      {
        for (Tensor<1, 2> &coefficient : velocity.coefficients)
          coefficient *= factor;
        velocity.flux *= factor;
      }
  }



  /// The velocity (-b, a) of a stream function with the gradient (a, b).
  inline Tensor<1, 2>
  velocity_of_stream(const Tensor<1, 2> &gradient)
  {
    return -cross_product_2d(gradient);
  }



  /// The cubic velocity with the values value(point) at the cubic_points().
  template <typename Value>
  TriangleVelocity
  interpolate_cubic(const Value &value)
  {
    TriangleVelocity result;
    for (unsigned int p = 0; p < Bernstein::n_cubics; ++p)
      {
        const Tensor<1, 2> at_point = value(Bernstein::cubic_points()[p]);
        for (unsigned int i = 0; i < Bernstein::n_cubics; ++i)
          result.coefficients[i] +=
            Bernstein::cubic_coefficients()(i, p) * at_point;
      }
    return result;
  }

  /// The position of a @p point of a triangle.
  Point<2>
  position(const std::array<Point<2>, 3> &corners,
           const Bernstein::Barycentric  &point);

  /// The velocity at a @p point of a triangle; times the distance from the axis
  /// in a body of revolution, so that it is a polynomial.
  Tensor<1, 2>
  weighted_velocity(const PlaneBody              &body,
                    const TriangleVelocity       &velocity,
                    const unsigned int            triangle,
                    const Bernstein::Barycentric &point);

  /// The strain rate in the plane of the polynomial part of a velocity.
  SymmetricTensor<2, 2>
  polynomial_rate(const std::array<Point<2>, 3> &corners,
                  const TriangleVelocity        &velocity,
                  const Bernstein::Barycentric  &point);

  /// That of the other part, times r^2.
  SymmetricTensor<2, 2>
  weighted_flux_rate(const TriangleVelocity &velocity);

  /// The velocity at a point of a triangle.
  Tensor<1, 2>
  velocity_at(const PlaneBody              &body,
              const TriangleVelocity       &velocity,
              const unsigned int            triangle,
              const Bernstein::Barycentric &point);

  /// The largest velocity at a vertex or centre of gravity.
  double
  largest_velocity(const PlaneBody                     &body,
                   const std::vector<TriangleVelocity> &velocity);

  /// The velocities at the corners and at the centre of gravity of a triangle.
  std::array<Tensor<1, 2>, 4>
  values_at_vertices(const PlaneBody        &body,
                     const TriangleVelocity &velocity,
                     const unsigned int      triangle);

  /// The strain rate at a point of a triangle; out of plane it is zero in plane
  /// strain, or else keeps the volume.
  SymmetricTensor<2, 3>
  strain_rate_at(const PlaneBody              &body,
                 const TriangleVelocity       &velocity,
                 const unsigned int            triangle,
                 const Bernstein::Barycentric &point);

  /// The strain rate in space with these components in the plane.
  SymmetricTensor<2, 3>
  rate_in_space(const PlaneBody &body, const SymmetricTensor<2, 2> &rate);
} // namespace ElastoPlastic

#endif
