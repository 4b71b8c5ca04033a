// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include "material/hardening_curve.h"

namespace ElastoPlastic
{
  HardeningCurve::HardeningCurve(const Voce               &voce,
                                 const PowerLaw           &power_law,
                                 const std::vector<Point> &table)
    : voce(voce)
    , power_law(power_law)
    , pieces({{0., 0., 0., 0.}})
  {
    for (const Point &point : table)
      {
        Piece       &last   = pieces.back();
        const double length = point.strain - last.strain;
        last.slope          = (point.rise - last.rise) / length;
        pieces.push_back(
          {point.strain,
           point.rise,
           0.,
           last.integral + 0.5 * (last.rise + point.rise) * length});
      }
  }



  const HardeningCurve::Piece &
  HardeningCurve::piece_at(const double alpha) const
  {
    const auto next =
      std::upper_bound(pieces.begin() + 1,
                       pieces.end(),
                       alpha,
                       [](const double strain, const Piece &piece) {
                         return strain < piece.strain;
                       });
    return *(next - 1);
  }



  double
  HardeningCurve::value(const double alpha) const
  {
    const Piece &piece = piece_at(alpha);
    return -voce.stress * std::expm1(-voce.rate * alpha) +
           power_law.yield_stress *
             std::expm1(power_law.exponent *
                        std::log1p(alpha / power_law.reference_strain)) +
           piece.rise + piece.slope * (alpha - piece.strain);
  }



  double
  HardeningCurve::slope(const double alpha) const
  {
    const auto &[sigma_0, n, eps_0] = power_law;
    return voce.stress * voce.rate * std::exp(-voce.rate * alpha) +
           sigma_0 * n / eps_0 * std::pow(1. + alpha / eps_0, n - 1.) +
           piece_at(alpha).slope;
  }



  double
  HardeningCurve::integral(const double alpha) const
  {
    const auto &[sigma_0, n, eps_0] = power_law;
    const Piece &piece              = piece_at(alpha);
    const double length             = alpha - piece.strain;
    double       sum                = piece.integral + piece.rise * length +
                 0.5 * piece.slope * length * length;
    sum += sigma_0 * (eps_0 / (n + 1.) *
                        std::expm1((n + 1.) * std::log1p(alpha / eps_0)) -
                      alpha);
    if (voce.rate > 0)
      sum += voce.stress * (alpha + std::expm1(-voce.rate * alpha) / voce.rate);
    return sum;
  }



  bool
  HardeningCurve::is_bounded() const
  {
    return power_law.exponent == 0.;
  }



  bool
  HardeningCurve::is_concave() const
  {
    return std::is_sorted(pieces.begin(),
                          pieces.end(),
                          [](const Piece &a, const Piece &b) {
                            return a.slope > b.slope;
                          });
  }
} // namespace ElastoPlastic
