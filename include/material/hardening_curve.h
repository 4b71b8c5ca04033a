// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef material_hardening_curve_h
#define material_hardening_curve_h

#include <vector>

namespace ElastoPlastic
{
  /// What nonlinear isotropic hardening adds to the yield stress in tension, as
  /// a function h(alpha) of the equivalent plastic strain: the sum of
  ///
  ///  - Q (1 - exp(-b alpha)), which saturates @cite voce_1948,
  ///  - sigma_0 ((1 + alpha / eps_0)^N - 1), a power law @cite swift_1952,
  ///  - a piecewise linear function, constant beyond its last point.
  ///
  /// It begins with h(0) = 0 and does not decrease.
  class HardeningCurve
  {
  public:
    struct Voce
    {
      double stress = 0; ///< Q >= 0, unit: stress
      double rate   = 0; ///< b >= 0
    };

    struct PowerLaw
    {
      double yield_stress     = 0; ///< sigma_0 > 0
      double exponent         = 0; ///< 0 <= N <= 1
      double reference_strain = 1; ///< eps_0 > 0
    };

    struct Point
    {
      double strain; ///< alpha, greater than that of the point before
      double rise;   ///< of the yield stress since alpha = 0, not smaller than
                     ///< that of the point before
    };

    /// @p table does not contain the point (0, 0) where it begins.
    HardeningCurve(const Voce               &voce,
                   const PowerLaw           &power_law,
                   const std::vector<Point> &table);

    /// h(alpha), alpha >= 0.
    double
    value(const double alpha) const;

    /// dh/dalpha; at a point of the table, the slope to its right.
    double
    slope(const double alpha) const;

    /// int_0^alpha h.
    double
    integral(const double alpha) const;

    /// Whether h has a finite limit for alpha to infinity.
    bool
    is_bounded() const;

    /// Whether the slope never grows.
    bool
    is_concave() const;

  private:
    /// A piece of the table's function, from its strain to that of the next.
    struct Piece
    {
      double strain, rise, slope, integral;
    };

    const Piece &
    piece_at(const double alpha) const;

    const Voce         voce;
    const PowerLaw     power_law;
    std::vector<Piece> pieces;
  };
} // namespace ElastoPlastic

#endif
