// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include "base/rethrow_collectively.h"
#include "mechanics/external_forces.h"

namespace ElastoPlastic
{
  template <int dim>
  void
  compute_external_forces(LinearAlgebra::distributed::Vector<double> &forces,
                          const DoFHandler<dim>           &dof_handler,
                          const AffineConstraints<double> &constraints,
                          const Model<dim>                &model,
                          const double                     time)
  {
    const auto       &fe        = dof_handler.get_fe();
    const auto       &tractions = model.boundary_conditions.tractions();
    QGauss<dim - 1>   quadrature(fe.degree + 1);
    FEFaceValues<dim> fe_face_values(fe,
                                     quadrature,
                                     update_values | update_JxW_values |
                                       update_quadrature_points);
    Vector<double>    cell_forces(fe.n_dofs_per_cell());
    std::vector<types::global_dof_index> dof_indices(fe.n_dofs_per_cell());

    forces = 0;
    rethrow_collectively(dof_handler.get_communicator(), [&]() {
      for (const auto &cell : dof_handler.active_cell_iterators())
        if (cell->is_locally_owned())
          for (const unsigned int f : cell->face_indices())
            {
              if (!cell->face(f)->at_boundary())
                continue;
              const auto traction =
                tractions.find(cell->face(f)->boundary_id());
              if (traction == tractions.end())
                continue;

              fe_face_values.reinit(cell, f);
              cell_forces = 0;
              for (const unsigned int q :
                   fe_face_values.quadrature_point_indices())
                for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
                  cell_forces(i) +=
                    traction->second[fe.system_to_component_index(i).first]
                      ->value(fe_face_values.quadrature_point(q), time) *
                    fe_face_values.shape_value(i, q) * fe_face_values.JxW(q) *
                    extent(fe_face_values.quadrature_point(q),
                           model.strain_model.kinematics);
              cell->get_dof_indices(dof_indices);
              constraints.distribute_local_to_global(cell_forces,
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
                          const Model<2> &,
                          const double);
  template void
  compute_external_forces(LinearAlgebra::distributed::Vector<double> &,
                          const DoFHandler<3> &,
                          const AffineConstraints<double> &,
                          const Model<3> &,
                          const double);
} // namespace ElastoPlastic
