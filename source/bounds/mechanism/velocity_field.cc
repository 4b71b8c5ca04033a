// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "base/tensors.h"
#include "bounds/mechanism/velocity_field.h"
#include "bounds/stress/johnson_mercier.h"

namespace ElastoPlastic
{
  namespace
  {
    using Bernstein::Barycentric;



    Tensor<1, 2>
    polynomial_velocity(const std::array<Point<2>, 3> &corners,
                        const TriangleVelocity        &velocity,
                        const Barycentric             &point)
    {
      const auto functions =
        Bernstein::cubics(JohnsonMercier::gradients(corners), point);
      Tensor<1, 2> sum;
      for (unsigned int i = 0; i < functions.size(); ++i)
        sum += functions[i].value * velocity.coefficients[i];
      return sum;
    }
  } // namespace



  Point<2>
  position(const std::array<Point<2>, 3> &corners, const Barycentric &point)
  {
    Point<2> sum;
    for (unsigned int i = 0; i < 3; ++i)
      sum += point[i] * corners[i];
    return sum;
  }



  Tensor<1, 2>
  weighted_velocity(const PlaneBody        &body,
                    const TriangleVelocity &velocity,
                    const unsigned int      t,
                    const Barycentric      &point)
  {
    const auto corners = body.mesh.corners(body.mesh.triangles[t]);
    return body.weight(position(corners, point)) *
             polynomial_velocity(corners, velocity, point) +
           velocity_of_stream(velocity.flux);
  }



  Tensor<1, 2>
  velocity_at(const PlaneBody        &body,
              const TriangleVelocity &velocity,
              const unsigned int      t,
              const Barycentric      &point)
  {
    const auto corners = body.mesh.corners(body.mesh.triangles[t]);
    const auto value   = polynomial_velocity(corners, velocity, point);
    return velocity.flux.norm() == 0 ?
             value :
             value +
               velocity_of_stream(velocity.flux) / position(corners, point)[0];
  }



  std::array<Tensor<1, 2>, 4>
  values_at_vertices(const PlaneBody        &body,
                     const TriangleVelocity &velocity,
                     const unsigned int      t)
  {
    return {{velocity_at(body, velocity, t, {{1., 0., 0.}}),
             velocity_at(body, velocity, t, {{0., 1., 0.}}),
             velocity_at(body, velocity, t, {{0., 0., 1.}}),
             velocity_at(body, velocity, t, {{1. / 3., 1. / 3., 1. / 3.}})}};
  }



  double
  largest_velocity(const PlaneBody                     &body,
                   const std::vector<TriangleVelocity> &velocity)
  {
    double largest = 0;
    for (unsigned int t = 0; t < velocity.size(); ++t)
      for (const Tensor<1, 2> &v : values_at_vertices(body, velocity[t], t))
        largest = std::max(largest, v.norm());
    return largest;
  }



  SymmetricTensor<2, 2>
  polynomial_rate(const std::array<Point<2>, 3> &corners,
                  const TriangleVelocity        &velocity,
                  const Barycentric             &point)
  {
    const auto functions =
      Bernstein::cubics(JohnsonMercier::gradients(corners), point);
    Tensor<2, 2> sum;
    for (unsigned int i = 0; i < functions.size(); ++i)
      sum += outer_product(velocity.coefficients[i], functions[i].gradient);
    return symmetrize(sum);
  }



  SymmetricTensor<2, 2>
  weighted_flux_rate(const TriangleVelocity &velocity)
  {
    SymmetricTensor<2, 2> rate;
    rate[0][0] = velocity.flux[1];
    rate[0][1] = -0.5 * velocity.flux[0];
    return rate;
  }



  SymmetricTensor<2, 3>
  strain_rate_at(const PlaneBody        &body,
                 const TriangleVelocity &velocity,
                 const unsigned int      t,
                 const Barycentric      &point)
  {
    const auto corners = body.mesh.corners(body.mesh.triangles[t]);
    auto       rate    = polynomial_rate(corners, velocity, point);
    if (velocity.flux.norm() > 0)
      rate += weighted_flux_rate(velocity) /
              Utilities::fixed_power<2>(position(corners, point)[0]);
    return rate_in_space(body, rate);
  }



  SymmetricTensor<2, 3>
  rate_in_space(const PlaneBody &body, const SymmetricTensor<2, 2> &rate)
  {
    return in_space<2>(rate,
                       body.kinematics == Kinematics::cartesian ? 0. :
                                                                  -trace(rate));
  }
} // namespace ElastoPlastic
