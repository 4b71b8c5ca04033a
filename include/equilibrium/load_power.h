// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef equilibrium_load_power_h
#define equilibrium_load_power_h

#include <vector>

#include "equilibrium/velocity_field.h"

namespace ElastoPlastic
{
  /// The power of tractions and body forces, of the whole body of revolution.
  struct LoadPower
  {
    double constant = 0; ///< of the loads that do not grow
    double growing  = 0; ///< of what a load factor of 1 adds
  };

  /// Uses nothing but the velocities and the loads themselves.
  LoadPower
  power_of_loads(const PlaneBody                     &body,
                 const std::vector<TriangleVelocity> &velocity);
} // namespace ElastoPlastic

#endif
