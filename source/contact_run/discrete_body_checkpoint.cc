// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// What a checkpoint keeps of the body.

#include "base/compatibility.h"
#include "base/rethrow_collectively.h"
#include "contact_run/discrete_body.h"
#include "mechanics/ghosted_copy.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Adds to @p values those of @p fields at the unknowns of @p cell, field
    /// by field.
    template <typename CellIterator>
    void
    append_values(std::vector<double>                   &values,
                  const CellIterator                    &cell,
                  const std::vector<const VectorType *> &fields)
    {
      std::vector<types::global_dof_index> dofs(
        cell->get_fe().n_dofs_per_cell());
      cell->get_dof_indices(dofs);
      for (const VectorType *field : fields)
        for (const auto dof : dofs)
          values.push_back((*field)(dof));
    }



    /// Takes them off the end again, and puts them into @p fields.
    template <typename CellIterator>
    void
    take_values(std::vector<double>             &values,
                const CellIterator              &cell,
                const std::vector<VectorType *> &fields)
    {
      std::vector<types::global_dof_index> dofs(
        cell->get_fe().n_dofs_per_cell());
      cell->get_dof_indices(dofs);
      const auto n_left = values.size() - fields.size() * dofs.size();
      auto       value  = values.begin() + n_left;
      for (VectorType *field : fields)
        for (const auto dof : dofs)
          {
            if (field->in_local_range(dof))
              (*field)(dof) = *value;
            ++value;
          }
      values.resize(n_left);
    }
  } // namespace



  template <int dim>
  std::vector<VectorType *>
  DiscreteBody<dim>::fields_to_keep(LastStep &last_step, VectorType &response)
  {
    return {&last_step.displacement,
            &last_step.displacement_rate,
            &last_step.slip,
            &last_step.forces,
            &response};
  }



  template <int dim>
  void
  DiscreteBody<dim>::save(LastStep &last_step, const std::string &mesh_file)
  {
    VectorType response = tangent_solver->known_response();
    if (response.size() == 0)
      solid.initialize_vector(response);
    const GhostedCopies<dim> fields(fields_to_keep(last_step, response),
                                    dof_handler);
    save_mesh<dim>(
      communicator_of(triangulation),
      [&](const CellVisitor<dim> &visit) {
        solid.for_each_state(
          [&](const auto &cell, std::vector<double> &&state) {
            append_values(state, cell, fields.pointers());
            visit(cell, state);
          });
      },
      mesh_file);
  }



  template <int dim>
  void
  DiscreteBody<dim>::take_back(SavedMesh<dim> &saved, LastStep &last_step)
  {
    VectorType response;
    const auto fields = fields_to_keep(last_step, response);
    for (VectorType *field : fields)
      solid.initialize_vector(*field);
    rethrow_collectively(communicator_of(triangulation), [&]() {
      solid.set_states([&](const auto &cell) {
        std::vector<double> values = saved.values(cell);
        take_values(values, cell, fields);
        return values;
      });
    });
    if (response.l2_norm() > 0)
      tangent_solver->set_response(response);
  }



  template void
  DiscreteBody<2>::save(LastStep &, const std::string &);
  template void
  DiscreteBody<3>::save(LastStep &, const std::string &);
  template void
  DiscreteBody<2>::take_back(SavedMesh<2> &, LastStep &);
  template void
  DiscreteBody<3>::take_back(SavedMesh<3> &, LastStep &);
} // namespace ElastoPlastic
