// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_mechanism_velocity_field_h
#define bounds_mechanism_velocity_field_h

#include <deal.II/base/symmetric_tensor.h>

#include <array>
#include <vector>

#include "bounds/body/split_body.h"
#include "bounds/stress/bernstein.h"

namespace ElastoPlastic
{
  using namespace dealii;

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
    double       error        = 0;
    unsigned int n_iterations = 0;
    /// False if rounding errors have ended the minimisation early.
    bool is_optimal = true;
  };



  template <int dim>
  void
  scale(VelocityField<dim> &field, const double factor)
  {
    for (auto &velocity : field.velocity)
      {
        for (auto &coefficient : velocity.coefficients)
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



  /// The velocity with the values value(point) at the Bernstein points.
  template <int dim, typename Value>
  SimplexVelocity<dim>
  interpolate_velocity(const Value &value)
  {
    constexpr unsigned int degree = velocity_degree<dim>;
    const auto            &points = Bernstein<dim>::points(degree);
    SimplexVelocity<dim>   result;
    for (unsigned int p = 0; p < points.size(); ++p)
      {
        const Tensor<1, dim> at_point = value(points[p]);
        for (unsigned int i = 0; i < points.size(); ++i)
          result.coefficients[i] +=
            Bernstein<dim>::coefficients(degree)(i, p) * at_point;
      }
    return result;
  }

  /// That which is linear on a tetrahedron and has these values at its corners.
  inline SimplexVelocity<3>
  linear_velocity(const std::array<Tensor<1, 3>, 4> &at_corners)
  {
    const auto        &points = Bernstein<3>::points(velocity_degree<3>);
    SimplexVelocity<3> result;
    for (unsigned int i = 0; i < points.size(); ++i)
      result.coefficients[i] = interpolate(points[i], at_corners);
    return result;
  }

  /// The velocity at a @p point of a simplex; times the distance from the axis
  /// in a body of revolution, so that it is a polynomial.
  template <int dim>
  Tensor<1, dim>
  weighted_velocity(const SplitBody<dim>       &body,
                    const SimplexVelocity<dim> &velocity,
                    const unsigned int          simplex,
                    const Barycentric<dim>     &point);

  /// The strain rate in the coordinates of the mesh of the polynomial part of a
  /// velocity.
  template <int dim>
  SymmetricTensor<2, dim>
  polynomial_rate(const Corners<dim>         &corners,
                  const SimplexVelocity<dim> &velocity,
                  const Barycentric<dim>     &point);

  /// That of the other part, times r^2.
  SymmetricTensor<2, 2>
  weighted_flux_rate(const SimplexVelocity<2> &velocity);

  /// The velocity at a point of a simplex.
  template <int dim>
  Tensor<1, dim>
  velocity_at(const SplitBody<dim>       &body,
              const SimplexVelocity<dim> &velocity,
              const unsigned int          simplex,
              const Barycentric<dim>     &point);

  /// The velocities at the corners and at the centre of gravity of a simplex.
  template <int dim>
  std::array<Tensor<1, dim>, dim + 2>
  values_at_vertices(const SplitBody<dim>       &body,
                     const SimplexVelocity<dim> &velocity,
                     const unsigned int          simplex);

  /// The largest of all these.
  template <int dim>
  double
  largest_velocity(const SplitBody<dim>                    &body,
                   const std::vector<SimplexVelocity<dim>> &velocity);

  /// The strain rate at a point of a simplex; out of plane it is zero in plane
  /// strain, v_r / r in a body of revolution with friction, or else keeps the
  /// volume.
  template <int dim>
  SymmetricTensor<2, 3>
  strain_rate_at(const SplitBody<dim>       &body,
                 const SimplexVelocity<dim> &velocity,
                 const unsigned int          simplex,
                 const Barycentric<dim>     &point);

  /// The strain rate in space with these components in the plane.
  template <int dim>
  SymmetricTensor<2, 3>
  rate_in_space(const SplitBody<dim>          &body,
                const SymmetricTensor<2, dim> &rate);
} // namespace ElastoPlastic

#endif
