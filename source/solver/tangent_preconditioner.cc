// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include "solver/tangent_preconditioner.h"

namespace ElastoPlastic
{
  template <int dim>
  void
  TangentMatrix<dim>::reinit(const DoFHandler<dim>           &new_dof_handler,
                             const AffineConstraints<double> &new_constraints)
  {
    dof_handler = &new_dof_handler;
    constraints = &new_constraints;
    DoFTools::extract_locally_relevant_dofs(*dof_handler, relevant_dofs);

    TrilinosWrappers::SparsityPattern pattern(dof_handler->locally_owned_dofs(),
                                              dof_handler->locally_owned_dofs(),
                                              relevant_dofs,
                                              dof_handler->get_communicator());
    DoFTools::make_sparsity_pattern(*dof_handler, pattern, *constraints, false);
    pattern.compress();
    system_matrix.reinit(pattern);
  }



  template <int dim>
  AffineConstraints<double>
  TangentMatrix<dim>::with_constrained(const VectorType &constrained) const
  {
    VectorType constrained_and_ghosts(dof_handler->locally_owned_dofs(),
                                      relevant_dofs,
                                      dof_handler->get_communicator());
    constrained_and_ghosts.copy_locally_owned_data_from(constrained);
    constrained_and_ghosts.update_ghost_values();

    AffineConstraints<double> all_constraints(relevant_dofs);
    all_constraints.merge(*constraints);
    for (const types::global_dof_index dof : relevant_dofs)
      if (constrained_and_ghosts(dof) != 0.)
        all_constraints.add_line(dof);
    all_constraints.close();
    return all_constraints;
  }



  template <int dim>
  const TrilinosWrappers::SparseMatrix &
  TangentMatrix<dim>::matrix() const
  {
    return system_matrix;
  }



  template class TangentMatrix<2>;
  template class TangentMatrix<3>;
} // namespace ElastoPlastic
