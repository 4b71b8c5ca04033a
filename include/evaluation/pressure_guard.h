// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef evaluation_pressure_guard_h
#define evaluation_pressure_guard_h

#include <vector>

#include "material/material.h"

namespace ElastoPlastic
{
  /// The largest pressure that an indenter can exert on a large body of the
  /// @p material where its equivalent plastic strain is @p plastic_strain:
  /// three times its yield stress Y, which is the mean pressure under a punch,
  /// or that which opens a spherical cavity in it,
  /// 2/3 Y (1 + ln(E / (3 (1 - nu) Y))) @cite hill_1950, whichever is larger.
  /// Infinite for an elastic material. Unit: stress.
  double
  largest_indentation_pressure(const Material<double> &material,
                               const double            plastic_strain);



  /// Tells when contact pressures are beyond what the yield stress of the body
  /// can bear (doc/trust, "Pressures that cannot be").
  class PressureGuard
  {
  public:
    /// So many times largest_indentation_pressure() is beyond doubt.
    static constexpr double factor = 2.;

    explicit PressureGuard(const std::vector<Material<double>> &materials);

    /// The largest pressure that passes where the equivalent plastic strain is
    /// nowhere more than @p plastic_strain; that of the hardest material.
    double
    limit(const double plastic_strain) const;

    /// Whether @p pressure is beyond limit() for the first time.
    bool
    is_exceeded(const double pressure, const double plastic_strain);

  private:
    const std::vector<Material<double>> materials;
    bool                                was_exceeded = false;
  };
} // namespace ElastoPlastic

#endif
