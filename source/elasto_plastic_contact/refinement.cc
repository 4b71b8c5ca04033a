// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/distributed/solution_transfer.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/numerics/error_estimator.h>

#include "elasto_plastic_contact.h"
#include "mechanics/ghosted_copy.h"

namespace ElastoPlastic
{
  // The estimator of Kelly, de Gago, Zienkiewicz and Babuska: jumps of the
  // displacement gradient across faces. Not made for plasticity or contact, but
  // it finds the edge of the contact zone and of the plastic zone.
  template <int dim>
  void
  ElastoPlasticContact<dim>::estimate_error()
  {
    TimerOutput::Scope scope(timer, "Error estimator");
    KellyErrorEstimator<dim>::estimate(MappingQ1<dim>(),
                                       dof_handler,
                                       QGauss<dim - 1>(fe.degree + 1),
                                       {},
                                       ghosted_copy(displacement, dof_handler),
                                       error_indicators);
  }



  // The mesh is adapted in the first load step. What the next mesh would need
  // is known only when it is there, when there is no way back; but a new cell
  // hardly ever brings fewer unknowns than it has in the interior of a mesh.
  template <int dim>
  bool
  ElastoPlasticContact<dim>::mark_next_mesh()
  {
    const auto &refinement = parameters.refinement;
    if (time_steps.number() > 1 || cycle + 1 >= refinement.n_cycles)
      return false;

    flag_cells(refinement, error_indicators, triangulation);
    const double n_new_cells =
      n_cells_after_refinement(triangulation) -
      static_cast<double>(triangulation.n_global_active_cells());
    const double unknowns_per_cell = dim * std::pow(fe.degree, dim);
    if (refinement.max_unknowns == 0 ||
        dof_handler.n_dofs() + unknowns_per_cell * n_new_cells <=
          refinement.max_unknowns)
      return true;

    screen.remark(
      "The next mesh would have more unknowns than "
      "'Refinement/Maximum number of unknowns' allows.");
    return false;
  }



  // The next mesh, and on it the interpolated solution as the starting guess.
  // What is no longer needed makes room for what comes: the levels of the old
  // mesh, and the values in transfer as soon as there are unknowns for them.
  template <int dim>
  void
  ElastoPlasticContact<dim>::refine_mesh()
  {
    ++cycle;
    tangent_solver.reset();
    const VectorType old_displacement = ghosted_copy(displacement, dof_handler);
    parallel::distributed::SolutionTransfer<dim, VectorType> transfer(
      dof_handler);
    transfer.prepare_for_coarsening_and_refinement(old_displacement);
    {
      TimerOutput::Scope scope(timer, "Refine mesh");
      triangulation.execute_coarsening_and_refinement();
    }
    setup_body();
    transfer.interpolate(displacement);
    supports.constraints().distribute(displacement);
    setup_contact();
  }



  template class ElastoPlasticContact<2>;
  template class ElastoPlasticContact<3>;
} // namespace ElastoPlastic
