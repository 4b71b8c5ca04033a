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



  // The next mesh, and on it the interpolated solution as the starting guess.
  // What is no longer needed makes room for what comes: the levels of the old
  // mesh, and the values in transfer as soon as there are unknowns for them.
  template <int dim>
  void
  ElastoPlasticContact<dim>::refine_mesh()
  {
    flag_cells(parameters.refinement, error_indicators, triangulation);
    triangulation.prepare_coarsening_and_refinement();

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
