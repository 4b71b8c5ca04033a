// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef equilibrium_growing_loads_h
#define equilibrium_growing_loads_h

#include <vector>

#include "equilibrium/plane_body.h"

namespace ElastoPlastic
{
  /// Tractions and body forces that grow with a load factor: it is the time, of
  /// which they are linear functions; or, if none depends on time, it
  /// multiplies all of them.
  /// @throws InputError if they are not linear in time, or all zero.
  PlaneLoads
  growing_loads(const SplitMesh             &mesh,
                const BoundaryConditions<2> &conditions,
                const BodyForce<2>          &body_force);

  /// At which of these @p times the largest of all tractions and body forces
  /// occurs.
  double
  time_of_largest_load(const SplitMesh             &mesh,
                       const BoundaryConditions<2> &conditions,
                       const BodyForce<2>          &body_force,
                       const std::vector<double>   &times);
} // namespace ElastoPlastic

#endif
