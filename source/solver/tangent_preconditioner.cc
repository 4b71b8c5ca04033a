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
  VectorType
  TangentMatrix<dim>::with_ghosts(const VectorType &vector) const
  {
    VectorType copy(dof_handler->locally_owned_dofs(),
                    relevant_dofs,
                    dof_handler->get_communicator());
    copy.copy_locally_owned_data_from(vector);
    copy.update_ghost_values();
    return copy;
  }



  template <int dim>
  void
  TangentMatrix<dim>::add_springs(const HeldUnknowns &held)
  {
    if (held.springs.size() == 0)
      return;
    for (const types::global_dof_index dof : dof_handler->locally_owned_dofs())
      if (held.springs(dof) != 0. && held.constrained(dof) == 0.)
        system_matrix.add(dof, dof, held.springs(dof));
    system_matrix.compress(VectorOperation::add);
  }



  template <int dim>
  AffineConstraints<double>
  TangentMatrix<dim>::with_held(const HeldUnknowns &held) const
  {
    const VectorType constrained = with_ghosts(held.constrained);
    const bool       is_sloped   = held.slopes.size() > 0;
    const VectorType slopes =
      is_sloped ? with_ghosts(held.slopes) : VectorType();

    AffineConstraints<double> all_constraints(relevant_dofs);
    all_constraints.merge(*constraints);
    for (const types::global_dof_index dof : relevant_dofs)
      if (constrained(dof) != 0.)
        {
          all_constraints.add_line(dof);
          if (is_sloped && dof % dim == dim - 1)
            for (auto other = dof - (dim - 1); other < dof; ++other)
              if (slopes(other) != 0. && constrained(other) == 0.)
                all_constraints.add_entry(dof, other, slopes(other));
        }
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
