// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef loads_loaded_body_h
#define loads_loaded_body_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>

#include "base/kinematics.h"
#include "loads/body_force.h"
#include "loads/boundary_conditions.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// What holds and loads the body, but for the indenter, and what its strains
  /// are.
  template <int dim>
  struct LoadedBody
  {
    BoundaryConditions<dim> boundary_conditions;
    BodyForce<dim>          body_force;
    StrainModel             strain_model;
  };



  /// Computes the nodal forces int traction . phi_i ds and int f . phi_i dx of
  /// the tractions and body forces f of @p body at @p time, condensed with @p
  /// constraints. @p forces has its layout. Collective.
  template <int dim>
  void
  compute_external_forces(LinearAlgebra::distributed::Vector<double> &forces,
                          const DoFHandler<dim>           &dof_handler,
                          const AffineConstraints<double> &constraints,
                          const LoadedBody<dim>           &body,
                          const double                     time);
} // namespace ElastoPlastic

#endif
