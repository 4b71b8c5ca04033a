// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/mapping_q1.h>

#include "mechanics/cell_kernel.h"
#include "mechanics/point_tangents.h"

namespace ElastoPlastic
{
  template <int dim, typename Tangents>
  void
  CellKernel<dim, Tangents>::reinit(
    const DoFHandler<dim>           &dof_handler,
    const AffineConstraints<double> &new_constraints)
  {
    constraints = &new_constraints;
    typename decltype(matrix_free)::AdditionalData settings;
    settings.mapping_update_flags = update_gradients | update_JxW_values;
    if (strain_model.kinematics == Kinematics::axisymmetric)
      settings.mapping_update_flags |= update_quadrature_points;
    settings.tasks_parallel_scheme = settings.none;

    const auto set_up = [&]() {
      matrix_free.reinit(MappingQ1<dim>(),
                         dof_handler,
                         new_constraints,
                         QGauss<1>(dof_handler.get_fe().degree + 1),
                         settings);
    };
    // (Indices and geometry need much memory while they are found: one after
    // the other.)
    settings.initialize_mapping = false;
    set_up();
    AssertThrow(matrix_free.get_shape_info().element_type ==
                  internal::MatrixFreeFunctions::tensor_symmetric,
                ExcInternalError());
    nodal_access.reinit(matrix_free, dof_handler.get_fe().dofs_per_cell / dim);
    eliminated.reinit(new_constraints, *matrix_free.get_vector_partitioner());
    settings.initialize_indices = false;
    settings.initialize_mapping = true;
    set_up();
  }



  // (With the weight itself, as in FEEvaluation::distribute_local_to_global(),
  // the weights of skew rollers, which may be negative, could make the sum
  // vanish.)
  template <int dim, typename Tangents>
  void
  CellKernel<dim, Tangents>::hand_to_masters(Vector &values) const
  {
    Vector shares;
    initialize_vector(shares);
    for (const auto &line : constraints->get_lines())
      if (values.in_local_range(line.index))
        for (const auto &[master, weight] : line.entries)
          shares(master) += weight * weight * values(line.index);
    shares.compress(VectorOperation::add);
    values += shares;
    for (const unsigned int i : eliminated_entries())
      values.local_element(i) = 0.;
  }



  template class CellKernel<2, PointTangents<2>>;
  template class CellKernel<3, PointTangents<3>>;
  template class CellKernel<2, CellTangents<2>>;
  template class CellKernel<3, CellTangents<3>>;
} // namespace ElastoPlastic
