// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "elasto_plastic_contact.h"
#include "mechanics/external_forces.h"

namespace ElastoPlastic
{
  // What the load step under way asks for at its end.
  template <int dim>
  void
  ElastoPlasticContact<dim>::apply_load()
  {
    const double time = time_steps.next_time();
    supports.set_time(dof_handler, boundary_conditions, time);
    compute_external_forces(external_forces,
                            dof_handler,
                            supports.constraints(),
                            boundary_conditions,
                            time);
    contact.set_load(load_program.load(time));
  }



  // Back to the end of the last step. (The material points have not forgotten
  // it.)
  template <int dim>
  void
  ElastoPlasticContact<dim>::take_back_step()
  {
    if (time_steps.number() > 1)
      displacement = committed_displacement;
    else
      displacement = 0.;
    solid->predict_flow(displacement, displacement);
    contact.deactivate_all();
    contact.place(last_step.depth);
    contact.activate_touching(displacement);
  }



  // The end of a step: the work that has been done in it (that of the external
  // forces by the trapezoidal rule), and what the next step begins with.
  template <int dim>
  void
  ElastoPlasticContact<dim>::commit_step(SolveResult &result)
  {
    VectorType forces = external_forces;
    forces -= residual;
    result.external_work =
      last_step.external_work + 0.5 * (forces * displacement);
    if (time_steps.number() > 1)
      result.external_work += 0.5 * (committed_forces * displacement -
                                     forces * committed_displacement -
                                     committed_forces * committed_displacement);
    result.plastic_work += last_step.plastic_work;
    result.dissipation += last_step.dissipation;
    last_step = result;

    load_program.reached(result.time, result.depth, result.force);
    if (result.time == load_program.final_time())
      return;
    solid->commit(displacement);
    committed_displacement = displacement;
    committed_forces       = forces;
  }



  template class ElastoPlasticContact<2>;
  template class ElastoPlasticContact<3>;
} // namespace ElastoPlastic
