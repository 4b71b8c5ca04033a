// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/utilities.h>
#include <deal.II/fe/fe_values.h>

#include "base/compatibility.h"
#include "base/exceptions.h"
#include "base/text.h"
#include "loads/loaded_body.h"

namespace ElastoPlastic
{
  namespace
  {
    const std::string entry = "Body force";



    template <int dim>
    using ActiveCell = typename DoFHandler<dim>::active_cell_iterator;



    /// The forces of a cell, by its unknowns.
    template <int dim>
    class CellForces
    {
    public:
      CellForces(const FiniteElement<dim> &fe,
                 const LoadedBody<dim>    &body,
                 const double              time)
        : fe(fe)
        , body(body)
        , time(time)
        , fe_values(fe, QGauss<dim>(fe.degree + 1), update_flags)
        , fe_face_values(fe, QGauss<dim - 1>(fe.degree + 1), update_flags)
        , forces(fe.n_dofs_per_cell())
      {}

      const Vector<double> &
      operator()(const ActiveCell<dim> &cell)
      {
        forces = 0;
        add_tractions(cell);
        if (body.body_force.is_present())
          {
            fe_values.reinit(cell);
            add(fe_values, [&](const Point<dim> &x) {
              return body.body_force.value(x, time);
            });
          }
        return forces;
      }

    private:
      inline static const UpdateFlags update_flags =
        update_values | update_JxW_values | update_quadrature_points;

      void
      add_tractions(const ActiveCell<dim> &cell)
      {
        const auto &tractions = body.boundary_conditions.tractions();
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary())
            if (const auto traction =
                  tractions.find(cell->face(f)->boundary_id());
                traction != tractions.end())
              {
                fe_face_values.reinit(cell, f);
                add(fe_face_values, [&](const Point<dim> &x) {
                  Tensor<1, dim> value;
                  for (unsigned int d = 0; d < dim; ++d)
                    value[d] = traction->second[d]->value(x, time);
                  return value;
                });
              }
      }

      /// @p density is the force by volume or by area.
      template <typename Density>
      void
      add(const FEValuesBase<dim> &values, const Density &density)
      {
        for (const unsigned int q : values.quadrature_point_indices())
          {
            const Point<dim>    &x = values.quadrature_point(q);
            const Tensor<1, dim> force =
              values.JxW(q) *
              out_of_plane_length(x, body.strain_model.kinematics) * density(x);
            for (unsigned int i = 0; i < forces.size(); ++i)
              forces(i) += force[fe.system_to_component_index(i).first] *
                           values.shape_value(i, q);
          }
      }

      const FiniteElement<dim> &fe;
      const LoadedBody<dim>    &body;
      const double              time;
      FEValues<dim>             fe_values;
      FEFaceValues<dim>         fe_face_values;
      Vector<double>            forces;
    };
  } // namespace



  void
  BodyForceParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter(
      entry,
      components,
      "Force per volume that acts in the whole body, for instance its weight; "
      "with finite strains, per volume of the undeformed body. One expression "
      "in x, y (, z) and the time t for each dimension, separated by ';'. For "
      "instance: 0; -7.7e-5*t. Empty: none. Unit: force by volume.",
      Patterns::Anything());
  }



  template <int dim>
  BodyForce<dim>::BodyForce(const std::string &components)
  {
    if (components.empty())
      return;
    const auto texts = split(entry, components, ';');
    if (texts.size() != dim)
      throw InputError(entry,
                       components,
                       "it must have " + std::to_string(dim) +
                         " components separated by ';', one per dimension.");
    for (const std::string &text : texts)
      expressions.push_back(
        std::make_shared<const Expression<dim>>(entry, text));
  }



  template <int dim>
  Tensor<1, dim>
  BodyForce<dim>::value(const Point<dim> &point, const double time) const
  {
    Tensor<1, dim> result;
    for (unsigned int d = 0; d < expressions.size(); ++d)
      result[d] = expressions[d]->value(point, time);
    return result;
  }



  template class BodyForce<2>;
  template class BodyForce<3>;



  template <int dim>
  void
  compute_external_forces(LinearAlgebra::distributed::Vector<double> &forces,
                          const DoFHandler<dim>           &dof_handler,
                          const AffineConstraints<double> &constraints,
                          const LoadedBody<dim>           &body,
                          const double                     time)
  {
    forces                  = 0;
    const bool in_all_cells = body.body_force.is_present();
    if (in_all_cells || !body.boundary_conditions.tractions().empty())
      rethrow_collectively(communicator_of(dof_handler), [&]() {
        CellForces<dim> forces_of(dof_handler.get_fe(), body, time);
        std::vector<types::global_dof_index> dof_indices(
          dof_handler.get_fe().n_dofs_per_cell());
        for (const auto &cell : dof_handler.active_cell_iterators())
          if (cell->is_locally_owned() && (in_all_cells || cell->at_boundary()))
            {
              cell->get_dof_indices(dof_indices);
              constraints.distribute_local_to_global(forces_of(cell),
                                                     dof_indices,
                                                     forces);
            }
      });
    forces.compress(VectorOperation::add);
  }



  template void
  compute_external_forces(LinearAlgebra::distributed::Vector<double> &,
                          const DoFHandler<2> &,
                          const AffineConstraints<double> &,
                          const LoadedBody<2> &,
                          const double);
  template void
  compute_external_forces(LinearAlgebra::distributed::Vector<double> &,
                          const DoFHandler<3> &,
                          const AffineConstraints<double> &,
                          const LoadedBody<3> &,
                          const double);
} // namespace ElastoPlastic
