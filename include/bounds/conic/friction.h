// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_conic_friction_h
#define bounds_conic_friction_h

#include <vector>

#include "bounds/conic/conic_program.h"

// The sine of the angle of internal friction is 0 <= sin(phi) < 1. With the
// cohesion c, Mohr and Coulomb's yield condition in plane strain is, tension
// being positive,
//   |((s_11 - s_22) / 2, s_12)| <= c cos(phi) - sin(phi) (s_11 + s_22) / 2.
// The yield radius of the material is sqrt(2) c cos(phi).

namespace ElastoPlastic
{
  /// Lets the yield conditions of plane stresses, with which the cones of a
  /// @p block begin, depend on the pressure.
  /// @param point_stresses what add_yield_conditions() was given
  /// @param pressures what the stresses at these points lack: a pressure that
  ///   has been taken out of them
  void
  add_friction(ConicBlock                &block,
               const FullMatrix<double>  &point_stresses,
               const std::vector<double> &pressures,
               const double               sine);

  /// The same for a pressure that is in proportion to an @p unknown of the
  /// block: its @p pressures where that is one.
  void
  add_growing_pressure(ConicBlock                &block,
                       const unsigned int         unknown,
                       const std::vector<double> &pressures,
                       const double               sine);
} // namespace ElastoPlastic

#endif
