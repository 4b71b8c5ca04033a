// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef loads_loaded_body_h
#define loads_loaded_body_h

#include "base/kinematics.h"
#include "loads/body_force.h"
#include "loads/boundary_conditions.h"

namespace ElastoPlastic
{
  /// What holds and loads the body, but for the indenter, and what its strains
  /// are.
  template <int dim>
  struct LoadedBody
  {
    BoundaryConditions<dim> boundary_conditions;
    BodyForce<dim>          body_force;
    StrainModel             strain_model;
  };
} // namespace ElastoPlastic

#endif
