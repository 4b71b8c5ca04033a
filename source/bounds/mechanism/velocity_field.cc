// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "base/largest_error.h"
#include "base/tensors.h"
#include "bounds/mechanism/velocity_field.h"

namespace ElastoPlastic
{
  namespace
  {
    template <int dim>
    Tensor<1, dim>
    polynomial_velocity(const SimplexVelocity<dim> &velocity,
                        const Barycentric<dim>     &point)
    {
      const auto functions =
        Bernstein<dim>::functions(velocity_degree<dim>, point);
      Tensor<1, dim> sum;
      for (unsigned int i = 0; i < functions.size(); ++i)
        sum += functions[i] * velocity.coefficients[i];
      return sum;
    }
  } // namespace



  template <int dim>
  Tensor<1, dim>
  weighted_velocity(const SplitBody<dim>       &body,
                    const SimplexVelocity<dim> &velocity,
                    const unsigned int          t,
                    const Barycentric<dim>     &point)
  {
    Tensor<1, dim> result =
      body.weight(interpolate(point, body.corners_of(t))) *
      polynomial_velocity(velocity, point);
    if constexpr (dim == 2)
      result += velocity_of_stream(velocity.flux);
    return result;
  }



  template <int dim>
  Tensor<1, dim>
  velocity_at(const SplitBody<dim>       &body,
              const SimplexVelocity<dim> &velocity,
              const unsigned int          t,
              const Barycentric<dim>     &point)
  {
    Tensor<1, dim> result = polynomial_velocity(velocity, point);
    if constexpr (dim == 2)
      if (velocity.flux.norm() > 0)
        result += velocity_of_stream(velocity.flux) /
                  interpolate(point, body.corners_of(t))[0];
    return result;
  }



  template <int dim>
  std::array<Tensor<1, dim>, dim + 2>
  values_at_vertices(const SplitBody<dim>       &body,
                     const SimplexVelocity<dim> &velocity,
                     const unsigned int          t)
  {
    std::array<Tensor<1, dim>, dim + 2> result;
    for (unsigned int i = 0; i <= dim; ++i)
      {
        Barycentric<dim> corner = {};
        corner[i]               = 1.;
        result[i]               = velocity_at(body, velocity, t, corner);
      }
    Barycentric<dim> centre;
    centre.fill(1. / (dim + 1.));
    result[dim + 1] = velocity_at(body, velocity, t, centre);
    return result;
  }



  template <int dim>
  double
  largest_velocity(const SplitBody<dim>                    &body,
                   const std::vector<SimplexVelocity<dim>> &velocity)
  {
    double largest = 0;
    for (unsigned int t = 0; t < velocity.size(); ++t)
      for (const auto &v : values_at_vertices(body, velocity[t], t))
        largest = std::max(largest, v.norm());
    return largest;
  }



  // The gradient of sum_a c_a B_a is n sum_b (sum_i c_{b + e_i} grad lambda_i)
  // B_b over the functions of degree n - 1.
  template <int dim>
  SymmetricTensor<2, dim>
  polynomial_rate(const Corners<dim>         &corners,
                  const SimplexVelocity<dim> &velocity,
                  const Barycentric<dim>     &point)
  {
    constexpr unsigned int n       = velocity_degree<dim>;
    const auto            &lower   = Bernstein<dim>::exponents(n - 1);
    const auto             weights = Bernstein<dim>::functions(n - 1, point);
    const auto             by      = gradients(corners);
    Tensor<2, dim>         sum;
    for (unsigned int i = 0; i <= dim; ++i)
      {
        Tensor<1, dim> change;
        for (unsigned int b = 0; b < lower.size(); ++b)
          {
            auto raised = lower[b];
            ++raised[i];
            change += 1. * n * weights[b] *
                      velocity.coefficients[Bernstein<dim>::number_of(raised)];
          }
        sum += outer_product(change, by[i]);
      }
    return symmetrize(sum);
  }



  SymmetricTensor<2, 2>
  weighted_flux_rate(const SimplexVelocity<2> &velocity)
  {
    SymmetricTensor<2, 2> rate;
    rate[0][0] = velocity.flux[1];
    rate[0][1] = -0.5 * velocity.flux[0];
    return rate;
  }



  // (v_r / r has the limit d_r v_r on the axis, where v_r vanishes.)
  template <int dim>
  SymmetricTensor<2, 3>
  strain_rate_at(const SplitBody<dim>       &body,
                 const SimplexVelocity<dim> &velocity,
                 const unsigned int          t,
                 const Barycentric<dim>     &point)
  {
    const auto corners = body.corners_of(t);
    auto       rate    = polynomial_rate<dim>(corners, velocity, point);
    if (body.is_axisymmetric() && body.has_friction())
      {
        const Point<dim> x = interpolate(point, corners);
        return in_space<dim>(rate,
                             body.is_on_axis(x) ?
                               rate[0][0] :
                               polynomial_velocity(velocity, point)[0] / x[0]);
      }
    if constexpr (dim == 2)
      if (velocity.flux.norm() > 0)
        rate += weighted_flux_rate(velocity) /
                Utilities::fixed_power<2>(interpolate(point, corners)[0]);
    return rate_in_space(body, rate);
  }



  template <int dim>
  SymmetricTensor<2, 3>
  rate_in_space(const SplitBody<dim> &body, const SymmetricTensor<2, dim> &rate)
  {
    return in_space<dim>(
      rate, body.kinematics == Kinematics::cartesian ? 0. : -trace(rate));
  }



  template Tensor<1, 2>
  weighted_velocity(const SplitBody<2> &,
                    const SimplexVelocity<2> &,
                    const unsigned int,
                    const Barycentric<2> &);
  template Tensor<1, 3>
  weighted_velocity(const SplitBody<3> &,
                    const SimplexVelocity<3> &,
                    const unsigned int,
                    const Barycentric<3> &);
  template Tensor<1, 2>
  velocity_at(const SplitBody<2> &,
              const SimplexVelocity<2> &,
              const unsigned int,
              const Barycentric<2> &);
  template std::array<Tensor<1, 2>, 4>
  values_at_vertices(const SplitBody<2> &,
                     const SimplexVelocity<2> &,
                     const unsigned int);
  template std::array<Tensor<1, 3>, 5>
  values_at_vertices(const SplitBody<3> &,
                     const SimplexVelocity<3> &,
                     const unsigned int);
  template double
  largest_velocity(const SplitBody<2> &,
                   const std::vector<SimplexVelocity<2>> &);
  template double
  largest_velocity(const SplitBody<3> &,
                   const std::vector<SimplexVelocity<3>> &);
  template SymmetricTensor<2, 2>
  polynomial_rate<2>(const Corners<2> &,
                     const SimplexVelocity<2> &,
                     const Barycentric<2> &);
  template SymmetricTensor<2, 3>
  polynomial_rate<3>(const Corners<3> &,
                     const SimplexVelocity<3> &,
                     const Barycentric<3> &);
  template SymmetricTensor<2, 3>
  strain_rate_at(const SplitBody<2> &,
                 const SimplexVelocity<2> &,
                 const unsigned int,
                 const Barycentric<2> &);
  template SymmetricTensor<2, 3>
  strain_rate_at(const SplitBody<3> &,
                 const SimplexVelocity<3> &,
                 const unsigned int,
                 const Barycentric<3> &);
  template SymmetricTensor<2, 3>
  rate_in_space(const SplitBody<2> &, const SymmetricTensor<2, 2> &);
  template SymmetricTensor<2, 3>
  rate_in_space(const SplitBody<3> &, const SymmetricTensor<2, 3> &);
} // namespace ElastoPlastic
