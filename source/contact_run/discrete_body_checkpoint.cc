// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// What a checkpoint keeps of the body.

#include "base/compatibility.h"
#include "base/exceptions.h"
#include "base/ghost_values.h"
#include "contact_run/discrete_body.h"
#include "mesh/geometry.h"
#include "restart/saved_mesh.h"

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
  DiscreteBody<dim>::fields_to_keep(LastStep &last, VectorType &response)
  {
    return {&last.displacement,
            &last.displacement_rate,
            &last.slip,
            &last.forces,
            &response};
  }



  template <int dim>
  void
  DiscreteBody<dim>::save(LastStep &last, const std::string &mesh_file)
  {
    VectorType response = tangent_solver->known_response();
    if (response.size() == 0)
      solid_body.initialize_vector(response);
    const GhostedCopies<dim> fields(fields_to_keep(last, response), unknowns);
    save_mesh<dim>(
      communicator_of(mesh),
      [&](const CellVisitor<dim> &visit) {
        solid_body.for_each_state(
          [&](const auto &cell, std::vector<double> &&state) {
            append_values(state, cell, fields.pointers());
            visit(cell, state);
          });
      },
      mesh_file);
  }



  template <int dim>
  void
  DiscreteBody<dim>::restore(const std::string &mesh_file,
                             const double       time,
                             const Load        &load,
                             LastStep          &last)
  {
    coarsen_to_coarse_mesh(mesh);
    SavedMesh<dim> saved(communicator_of(mesh), mesh_file);
    saved.refine(mesh);
    reinit(time, load);

    VectorType response;
    const auto fields = fields_to_keep(last, response);
    for (VectorType *field : fields)
      solid_body.initialize_vector(*field);
    rethrow_collectively(communicator_of(mesh), [&]() {
      solid_body.set_states([&](const auto &cell) {
        std::vector<double> values = saved.values(cell);
        take_values(values, cell, fields);
        return values;
      });
    });
    if (response.l2_norm() > 0)
      tangent_solver->set_response(response);
  }
} // namespace ElastoPlastic
