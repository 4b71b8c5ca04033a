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
  namespace
  {
    constexpr unsigned int n_cubics = Bernstein<2>::n_functions(3);



    std::vector<SimplexVelocity<2>>
    velocities_of_streams(const SplitBody<2> &body,
                          const Corners<2>   &corners,
                          const bool          has_flux)
    {
      const auto                      by_coordinates = gradients(corners);
      std::vector<SimplexVelocity<2>> result;
      for (unsigned int f = 0; f < n_cubics; ++f)
        {
          std::array<double, n_cubics> unit = {};
          unit[f]                           = 1.;
          result.push_back(
            interpolate_velocity<2>([&](const Barycentric<2> &point) {
              const Tensor<1, 2> velocity = velocity_of_stream(
                interpolate(Bernstein<2>::derivatives(3, unit.begin(), point),
                            by_coordinates));
              return body.is_axisymmetric() ?
                       interpolate(point, corners)[0] * velocity +
                         Tensor<1, 2>(
                           {0., 2. * Bernstein<2>::functions(3, point)[f]}) :
                       velocity;
            }));
        }
      // (in units in which its factors are velocities, as those of the others)
      if (has_flux)
        for (const Tensor<1, 2> &gradient : by_coordinates)
          result.push_back(
            {{}, Utilities::fixed_power<2>(body.weight_unit()) * gradient});
      return result;
    }

  } // namespace



  StreamElement::StreamElement(const SplitBody<2> &body,
                               const unsigned int  triangle,
                               const bool          has_flux)
    : functions(
        velocities_of_streams(body, body.corners_of(triangle), has_flux))
    , body(body)
    , triangle(triangle)
    , corners(body.corners_of(triangle))
    , has_flux(has_flux)
  {}



  // Rates are linear in plane strain, and quadratic in a body of revolution:
  // with a quadratic polynomial for 1 / r^2, also those of phi; what is left is
  // at most the error of the polynomial times r^2 |e|. What rate_matrix() makes
  // of a rate without components out of plane has none.
  StreamElement::WeightedRates
  StreamElement::rates() const
  {
    const FullMatrix<double> matrix = rate_matrix<2>(body.materials[triangle]);
    const unsigned int       n      = n_rate_components();
    const double             size   = volume(corners);
    const std::array<double, 3> r   = {
        {corners[0][0], corners[1][0], corners[2][0]}};
    const auto          ends = std::minmax({r[0], r[1], r[2]});
    const InverseSquare inverse_square(ends.first, ends.second);

    const unsigned int degree = body.is_axisymmetric() ? 2 : 1;
    WeightedRates      result;
    for (const double moment :
         Bernstein<2>::moments(degree, body.weights(corners)))
      result.weights.push_back(size * moment);
    if (has_flux)
      {
        const double mean = (r[0] + r[1] + r[2]) / 3.;
        result.weights.push_back(
          size * mean *
          std::max(inverse_square.error(),
                   Tolerance::flux_penalty / (mean * std::sqrt(size))));
      }

    result.rates.reinit(n * result.weights.size(), functions.size());
    for (unsigned int f = 0; f < functions.size(); ++f)
      {
        const SymmetricTensor<2, 2> of_flux = weighted_flux_rate(functions[f]);
        auto                        rates =
          Bernstein<2>::interpolate(degree, [&](const Barycentric<2> &point) {
            auto rate = polynomial_rate<2>(corners, functions[f], point);
            if (has_flux)
              rate += inverse_square(interpolate(point, r)) * of_flux;
            return rate;
          });
        if (has_flux)
          rates.push_back(of_flux);
        for (unsigned int a = 0; a < rates.size(); ++a)
          {
            const SymmetricTensor<2, 3> rate = rate_in_space(body, rates[a]);
            for (unsigned int c = 0; c < n; ++c)
              result.rates(n * a + c, f) =
                matrix(c, 0) * rate[0][0] + matrix(c, 1) * rate[1][1] +
                matrix(c, 2) * rate[0][1] + matrix(c, 3) * rate[2][2];
          }
      }
    return result;
  }

} // namespace ElastoPlastic
