// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_body_growing_loads_h
#define bounds_body_growing_loads_h

#include <vector>

#include "bounds/body/split_body.h"
#include "loads/boundary_conditions.h"

namespace ElastoPlastic
{
  /// Tractions and body forces that grow with a load factor: it is the time, of
  /// which they are linear functions; or, if none depends on time, it
  /// multiplies all of them.
  /// @throws InputError if they are not linear in time, or all zero.
  template <int dim>
  Loads<dim>
  growing_loads(const SplitMesh<dim>          &mesh,
                const BoundaryConditions<dim> &conditions,
                const BodyForce<dim>          &body_force);

  /// At which of these @p times the largest of all tractions and body forces
  /// occurs.
  template <int dim>
  double
  time_of_largest_load(const SplitMesh<dim>          &mesh,
                       const BoundaryConditions<dim> &conditions,
                       const BodyForce<dim>          &body_force,
                       const std::vector<double>     &times);
} // namespace ElastoPlastic

#endif
