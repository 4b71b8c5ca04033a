// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Ends with 0 if products with the batches of base/simd.h are those with the
// batches of one number that deal.II's own library has.

#include <deal.II/base/config.h>

#if DEAL_II_VECTORIZATION_WIDTH_IN_BITS > 0
#  error "This deal.II has wide batches of its own."
#endif

#include "../../source/simd/instantiate_matrix_free.h"

INSTANTIATE_MATRIX_FREE(2, double)
INSTANTIATE_MAPPING_EVALUATION(2)

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/matrix_free/fe_evaluation.h>

#include <cmath>
#include <vector>

namespace
{
  using namespace dealii;

  /// The Laplace operator of each cell, on one and the same vector.
  template <typename Number>
  std::vector<double>
  products(const DoFHandler<2> &dof_handler)
  {
    AffineConstraints<double> constraints;
    constraints.close();
    typename MatrixFree<2, double, Number>::AdditionalData data;
    data.mapping_update_flags = update_gradients | update_JxW_values;
    MatrixFree<2, double, Number> matrix_free;
    matrix_free.reinit(
      MappingQ1<2>(), dof_handler, constraints, QGauss<1>(3), data);

    FEEvaluation<2, 2, 3, 1, double, Number> phi(matrix_free);
    constexpr unsigned int                   n_dofs = phi.static_dofs_per_cell;
    std::vector<double>                      result(
      n_dofs *
      matrix_free.get_dof_handler().get_triangulation().n_active_cells());
    for (unsigned int batch = 0; batch < matrix_free.n_cell_batches(); ++batch)
      {
        phi.reinit(batch);
        for (unsigned int i = 0; i < n_dofs; ++i)
          phi.begin_dof_values()[i] = std::sin(i);
        phi.evaluate(EvaluationFlags::gradients);
        for (unsigned int q = 0; q < phi.n_q_points; ++q)
          phi.submit_gradient(phi.get_gradient(q), q);
        phi.integrate(EvaluationFlags::gradients);
        for (unsigned int lane = 0;
             lane < matrix_free.n_active_entries_per_cell_batch(batch);
             ++lane)
          {
            const unsigned int cell =
              matrix_free.get_cell_iterator(batch, lane)->active_cell_index();
            for (unsigned int i = 0; i < n_dofs; ++i)
              result[cell * n_dofs + i] = phi.begin_dof_values()[i][lane];
          }
      }
    return result;
  }
} // namespace



int
main()
{
  // (of which one batch cannot be full)
  Triangulation<2> mesh;
  GridGenerator::hyper_ball(mesh);
  mesh.refine_global(1);
  const FE_Q<2> fe(2);
  DoFHandler<2> dof_handler(mesh);
  dof_handler.distribute_dofs(fe);

  const auto expected = products<VectorizedArray<double, 1>>(dof_handler);
  const auto wide     = products<ElastoPlastic::Simd<double>>(dof_handler);
  for (unsigned int i = 0; i < expected.size(); ++i)
    if (!(std::abs(wide[i] - expected[i]) < 1e-12))
      return 1;
  return 0;
}
