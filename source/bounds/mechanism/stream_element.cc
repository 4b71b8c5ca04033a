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
      if (has_flux)
        for (const Tensor<1, 2> &gradient : by_coordinates)
          result.push_back({{}, gradient});
      return result;
    }



    void
    set_column(FullMatrix<double>        &matrix,
               const unsigned int         column,
               const std::vector<double> &entries)
    {
      for (unsigned int i = 0; i < entries.size(); ++i)
        matrix(i, column) = entries[i];
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
    , side_degree(body.is_axisymmetric() ? 4 : 2)
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

    WeightedRates result;
    if (body.is_axisymmetric())
      for (const double moment : quadratic_moments(r))
        result.weights.push_back(size * moment);
    else
      result.weights.assign(3, size / 3.);
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
        auto                        rates   = Bernstein<2>::interpolate(
          body.is_axisymmetric() ? 2 : 1, [&](const Barycentric<2> &point) {
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



  template <typename Function>
  std::vector<double>
  StreamElement::coefficients_on_side(const unsigned int k,
                                      const Function    &function) const
  {
    return Bernstein<1>::interpolate(side_degree,
                                     [&](const Barycentric<1> &on_side) {
                                       Barycentric<2> point = {};
                                       point[k]             = on_side[0];
                                       point[(k + 1) % 3]   = on_side[1];
                                       return function(point);
                                     });
  }



  FullMatrix<double>
  StreamElement::velocities_on_side(const unsigned int  k,
                                    const Tensor<1, 2> &direction) const
  {
    FullMatrix<double> result(side_degree + 1, functions.size());
    for (unsigned int f = 0; f < functions.size(); ++f)
      set_column(
        result, f, coefficients_on_side(k, [&](const Barycentric<2> &point) {
          return weighted_velocity(body, functions[f], triangle, point) *
                 direction;
        }));
    return result;
  }



  FullMatrix<double>
  StreamElement::slips_on_side(const unsigned int  k,
                               const Tensor<1, 2> &direction) const
  {
    const unsigned int n      = functions.size();
    const auto         weight = [&](const Barycentric<2> &point) {
      return body.weight(interpolate(point, corners));
    };
    FullMatrix<double> result(side_degree + 1, n + 9);
    result.fill(velocities_on_side(k, direction));
    if (body.is_axisymmetric())
      for (unsigned int f = 0; f < n_cubics; ++f)
        {
          const auto continuous =
            coefficients_on_side(k, [&](const Barycentric<2> &point) {
              return weight(point) * 2. * Bernstein<2>::functions(3, point)[f] *
                     direction[1];
            });
          for (unsigned int i = 0; i <= side_degree; ++i)
            result(i, f) -= continuous[i];
        }
    for (unsigned int i = 0; i < 3; ++i)
      set_column(
        result,
        n + 3 * k + i,
        coefficients_on_side(k, [&](const Barycentric<2> &point) {
          const Barycentric<1> on_side = {{point[k], point[(k + 1) % 3]}};
          return -weight(point) * weight(point) *
                 Bernstein<1>::functions(2, on_side)[i];
        }));
    return result;
  }



  std::vector<double>
  StreamElement::weights_on_side(const unsigned int k) const
  {
    return coefficients_on_side(k, [&](const Barycentric<2> &point) {
      return body.weight(interpolate(point, corners));
    });
  }
} // namespace ElastoPlastic
