// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef loads_roller_conditions_h
#define loads_roller_conditions_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/component_mask.h>
#include <deal.II/lac/affine_constraints.h>

#include <map>

namespace ElastoPlastic
{
  using namespace dealii;

  /// The axis that all faces of a boundary are normal to, or dim. Collective.
  template <int dim>
  unsigned int
  common_normal_axis(const DoFHandler<dim>   &dof_handler,
                     const types::boundary_id boundary);

  /// The components of normals that do not vanish on all faces of a boundary.
  /// Collective.
  template <int dim>
  ComponentMask
  components_of_normals(const DoFHandler<dim>   &dof_handler,
                        const types::boundary_id boundary);

  /// Adds the condition that @p line states to @p constraints, solved for the
  /// degree of freedom with the largest coefficient of those that neither
  /// another support nor @p hanging_nodes hold. Where there is none, the
  /// other supports decide.
  void
  add_sliding_condition(
    const AffineConstraints<double>::ConstraintLine &line,
    const std::map<types::global_dof_index, double> &fixed_values,
    const AffineConstraints<double>                 &hanging_nodes,
    AffineConstraints<double>                       &constraints);
} // namespace ElastoPlastic

#endif
