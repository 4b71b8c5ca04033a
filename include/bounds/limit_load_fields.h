// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_limit_load_fields_h
#define bounds_limit_load_fields_h

#include "bounds/equilibrium_output.h"
#include "bounds/limit_load.h"
#include "bounds/space_limit_load.h"

namespace ElastoPlastic
{
  /// What limit_load.pvd shows of two bounds.
  EquilibriumFields
  fields_of(const PlaneBody &body, const LimitLoad &bounds);
  SpaceFields
  fields_of(const SpaceBody &body, const SpaceLimitLoad &bounds);

  /// The body on whose mesh the mechanism is.
  const PlaneBody &
  body_of_velocity(const PlaneBody &body, const LimitLoad &bounds);
  const SpaceBody &
  body_of_velocity(const SpaceBody &body, const SpaceLimitLoad &bounds);
} // namespace ElastoPlastic

#endif
