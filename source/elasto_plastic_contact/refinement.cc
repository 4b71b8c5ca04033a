// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/distributed/solution_transfer.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/numerics/error_estimator.h>

#include "elasto_plastic_contact.h"

namespace ElastoPlastic
{
  namespace
  {
    /// A copy of @p vector that knows all locally relevant unknowns.
    template <int dim>
    VectorType
    locally_relevant(const VectorType      &vector,
                     const DoFHandler<dim> &dof_handler)
    {
      IndexSet relevant;
      DoFTools::extract_locally_relevant_dofs(dof_handler, relevant);
      VectorType copy(dof_handler.locally_owned_dofs(),
                      relevant,
                      dof_handler.get_communicator());
      copy.copy_locally_owned_data_from(vector);
      copy.update_ghost_values();
      return copy;
    }
  } // namespace



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
                                       locally_relevant(displacement,
                                                        dof_handler),
                                       error_indicators);
  }



  // The next mesh, and on it the interpolated solution as the starting guess.
  template <int dim>
  void
  ElastoPlasticContact<dim>::refine_mesh()
  {
    flag_cells(parameters.refinement, error_indicators, triangulation);
    triangulation.prepare_coarsening_and_refinement();

    const VectorType old_displacement =
      locally_relevant(displacement, dof_handler);
    parallel::distributed::SolutionTransfer<dim, VectorType> transfer(
      dof_handler);
    transfer.prepare_for_coarsening_and_refinement(old_displacement);
    {
      TimerOutput::Scope scope(timer, "Refine mesh");
      triangulation.execute_coarsening_and_refinement();
    }
    setup_system();
    transfer.interpolate(displacement);
    supports.constraints().distribute(displacement);
  }



  template class ElastoPlasticContact<2>;
  template class ElastoPlasticContact<3>;
} // namespace ElastoPlastic
