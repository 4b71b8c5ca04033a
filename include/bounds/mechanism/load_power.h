// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_mechanism_load_power_h
#define bounds_mechanism_load_power_h

#include <vector>

#include "bounds/mechanism/velocity_field.h"

namespace ElastoPlastic
{
  /// Uses nothing but the velocities and the loads themselves.
  LoadPower
  power_of_loads(const PlaneBody                     &body,
                 const std::vector<TriangleVelocity> &velocity);
} // namespace ElastoPlastic

#endif
