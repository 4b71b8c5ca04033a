// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include "bounds/body/yield_matrices.h"
#include "bounds/conic/tolerances.h"
#include "bounds/mechanism/stream_element.h"
#include "bounds/stress/inverse_square.h"

namespace ElastoPlastic
{
  StreamElement::StreamElement(const SplitBody<2> &body,
                               const unsigned int  triangle,
                               const bool          has_flux)
    : body(body)
    , corners(body.mesh.corners(body.mesh.simplices[triangle]))
    , gradients(ElastoPlastic::gradients(corners))
    , has_flux(has_flux)
    , rate_factor(ElastoPlastic::rate_factor<2>(body.materials[triangle]))
  {}



  Tensor<1, 2>
  StreamElement::velocity_of(const Jet &jet, const double r) const
  {
    const Tensor<1, 2> velocity = velocity_of_stream(jet.gradient);
    return body.is_axisymmetric() ?
             r * velocity + Tensor<1, 2>({0., 2. * jet.value}) :
             velocity;
  }



  SymmetricTensor<2, 2>
  StreamElement::rate_of(const Jet &jet, const double r) const
  {
    const Tensor<2, 2>   &h = jet.hessian;
    SymmetricTensor<2, 2> rate;
    rate[0][0] = -h[0][1];
    rate[1][1] = h[0][1];
    rate[0][1] = 0.5 * (h[0][0] - h[1][1]);
    if (!body.is_axisymmetric())
      return rate;
    rate *= r;
    rate[0][0] -= jet.gradient[1];
    rate[1][1] += 2. * jet.gradient[1];
    rate[0][1] += 1.5 * jet.gradient[0];
    return rate;
  }



  // The deviator in an orthonormal basis; its trace in space is zero. What the
  // factor makes of the first components, it makes without others.
  std::vector<double>
  StreamElement::rate_components(const SymmetricTensor<2, 2> &rate) const
  {
    std::vector<double> components = {std::sqrt(0.5) *
                                        (rate[0][0] - rate[1][1]),
                                      std::sqrt(2.) * rate[0][1]};
    if (body.is_axisymmetric())
      components.push_back(-std::sqrt(1.5) * trace(rate));
    const unsigned int  n = components.size();
    std::vector<double> result(n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        result[i] += rate_factor(i, j) * components[j];
    return result;
  }



  // Rates are linear in plane strain, and quadratic in a body of revolution.
  StreamElement::WeightedRates
  StreamElement::rates() const
  {
    const unsigned int n_components = n_rate_components();
    const unsigned int n_points     = body.is_axisymmetric() ? n_quadratics : 3;

    FullMatrix<double> values(n_points * n_components, n_functions());
    for (unsigned int p = 0; p < n_points; ++p)
      {
        const Barycentric<2> &point = Bernstein<2>::points(2)[p];
        const auto            jets  = cubics(gradients, point);
        for (unsigned int i = 0; i < n_cubics; ++i)
          {
            const auto components =
              rate_components(rate_of(jets[i], interpolate(point, corners)[0]));
            for (unsigned int c = 0; c < n_components; ++c)
              values(p * n_components + c, i) = components[c];
          }
      }

    WeightedRates result;
    const double  size = volume(corners);
    if (!body.is_axisymmetric())
      return {values, std::vector<double>(3, size / 3.)};

    result.rates.reinit(values.m(), values.n());
    for (unsigned int p = 0; p < n_points; ++p)
      for (unsigned int q = 0; q < n_points; ++q)
        for (unsigned int c = 0; c < n_components; ++c)
          for (unsigned int i = 0; i < n_cubics; ++i)
            result.rates(p * n_components + c, i) +=
              Bernstein<2>::coefficients(2)(p, q) *
              values(q * n_components + c, i);
    for (const double moment :
         quadratic_moments({{corners[0][0], corners[1][0], corners[2][0]}}))
      result.weights.push_back(size * moment);
    if (has_flux)
      add_flux_rates(result);
    return result;
  }



  // With a quadratic polynomial for 1 / r^2, they are quadratic as well; what
  // is left is at most the error of the polynomial times r^2 |e|.
  void
  StreamElement::add_flux_rates(WeightedRates &result) const
  {
    const unsigned int n_components = n_rate_components();
    const auto [r_min, r_max] =
      std::minmax({corners[0][0], corners[1][0], corners[2][0]});
    const InverseSquare inverse_square(r_min, r_max);

    FullMatrix<double> rates((n_quadratics + 1) * n_components, n_functions());
    rates.fill(result.rates);
    for (unsigned int f = 0; f < 3; ++f)
      {
        SimplexVelocity<2> velocity;
        velocity.flux         = gradients[f];
        const auto components = rate_components(weighted_flux_rate(velocity));
        for (unsigned int c = 0; c < n_components; ++c)
          {
            for (unsigned int p = 0; p < n_quadratics; ++p)
              for (unsigned int q = 0; q < n_quadratics; ++q)
                rates(p * n_components + c, n_cubics + f) +=
                  Bernstein<2>::coefficients(2)(p, q) *
                  inverse_square(
                    interpolate(Bernstein<2>::points(2)[q], corners)[0]) *
                  components[c];
            rates(n_quadratics * n_components + c, n_cubics + f) =
              components[c];
          }
      }
    result.rates      = rates;
    const double size = volume(corners);
    const double r    = (corners[0][0] + corners[1][0] + corners[2][0]) / 3.;
    result.weights.push_back(
      size * r *
      std::max(inverse_square.error(),
               Tolerance::flux_penalty / (r * std::sqrt(size))));
  }



  std::vector<Tensor<1, 2>>
  StreamElement::weighted_velocities(const Barycentric<2> &point) const
  {
    const Point<2>            x = interpolate(point, corners);
    std::vector<Tensor<1, 2>> result;
    for (const Jet &jet : cubics(gradients, point))
      result.push_back(body.weight(x) * velocity_of(jet, x[0]));
    if (has_flux)
      for (const Tensor<1, 2> &gradient : gradients)
        result.push_back(velocity_of_stream(gradient));
    return result;
  }



  template <typename Values>
  FullMatrix<double>
  StreamElement::coefficients_on_side(const unsigned int k,
                                      const unsigned int n_columns,
                                      const Values      &values) const
  {
    const unsigned int n_points = side_degree() + 1;
    FullMatrix<double> at_points(n_points, n_columns),
      result(n_points, n_columns);
    for (unsigned int p = 0; p < n_points; ++p)
      {
        const double   t     = p / static_cast<double>(side_degree());
        Barycentric<2> point = {};
        point[k]             = 1. - t;
        point[(k + 1) % 3]   = t;
        const auto row       = values(point, t);
        std::copy(row.begin(), row.end(), &at_points(p, 0));
      }
    Bernstein<1>::coefficients(side_degree()).mmult(result, at_points);
    return result;
  }



  FullMatrix<double>
  StreamElement::velocities_on_side(const unsigned int  k,
                                    const Tensor<1, 2> &direction) const
  {
    return coefficients_on_side(
      k, n_functions(), [&](const Barycentric<2> &point, const double) {
        std::vector<double> row;
        for (const Tensor<1, 2> &velocity : weighted_velocities(point))
          row.push_back(velocity * direction);
        return row;
      });
  }



  FullMatrix<double>
  StreamElement::slips_on_side(const unsigned int  k,
                               const Tensor<1, 2> &direction) const
  {
    return coefficients_on_side(
      k, n_functions() + 9, [&](const Barycentric<2> &point, const double t) {
        const double        r = body.weight(interpolate(point, corners));
        std::vector<double> row;
        for (const Jet &jet : cubics(gradients, point))
          row.push_back(r * r * (velocity_of_stream(jet.gradient) * direction));
        if (has_flux)
          for (const Tensor<1, 2> &gradient : gradients)
            row.push_back(velocity_of_stream(gradient) * direction);
        row.resize(n_functions() + 3 * k, 0.);
        for (const double function : Bernstein<1>::functions(2, {{1. - t, t}}))
          row.push_back(-r * r * function);
        row.resize(n_functions() + 9, 0.);
        return row;
      });
  }



  std::vector<double>
  StreamElement::weights_on_side(const unsigned int k) const
  {
    const auto coefficients = coefficients_on_side(
      k, 1, [&](const Barycentric<2> &point, const double) {
        return std::vector<double>{body.weight(interpolate(point, corners))};
      });
    std::vector<double> result;
    for (unsigned int p = 0; p < coefficients.m(); ++p)
      result.push_back(coefficients(p, 0));
    return result;
  }



  SimplexVelocity<2>
  StreamElement::velocity(const Vector<double> &coefficients) const
  {
    SimplexVelocity<2> result =
      interpolate_velocity<2>([&](const Barycentric<2> &point) {
        const auto   jets = cubics(gradients, point);
        Tensor<1, 2> value;
        for (unsigned int i = 0; i < n_cubics; ++i)
          value += coefficients[i] *
                   velocity_of(jets[i], interpolate(point, corners)[0]);
        return value;
      });
    if (has_flux)
      for (unsigned int f = 0; f < 3; ++f)
        result.flux += coefficients[n_cubics + f] * gradients[f];
    return result;
  }
} // namespace ElastoPlastic
