// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "contact_run/elasto_plastic_contact.h"

namespace ElastoPlastic
{
  template <int dim>
  void
  ElastoPlasticContact<dim>::adapt_mesh(Statistics &statistics)
  {
    bool changes = adaptation.mark_after(last_step);
    while (changes)
      changes =
        change_mesh(statistics) && adaptation.mark_until_touched(last_step);
  }



  // In a history, the mesh may follow the contact, in no time. On the new one,
  // the interpolated state is not in equilibrium, nor are all its stresses
  // admissible: the solution under the same load is both, and the difference
  // is what the change of the mesh has cost. A finer mesh may not bear the
  // load, though; then the next step, which can be cut, has to find the next
  // equilibrium. @return whether there is one on the new mesh.
  template <int dim>
  bool
  ElastoPlasticContact<dim>::change_mesh(Statistics &statistics)
  {
    ++cycle;
    body.refine(time_steps.next_time(), load_at_end_of_step(), last_step);
    body.contact.place(last_step.result.depth);
    body.contact.begin_step(body.displacement, last_step.result.depth, {});
    body.contact.activate_touching(body.displacement);
    body.solid.predict_flow(body.displacement, body.displacement);
    last_step.displacement = body.displacement;
    try
      {
        equilibrate_adapted_mesh(statistics);
        return true;
      }
    catch (const ConvergenceError &error)
      {
        log.warn(
          "No equilibrium has been found on the adapted mesh under "
          "the load of step " +
          std::to_string(last_step.result.step) +
          "; the next step begins with the interpolated state. " +
          error.what());
        commit_interpolated_state();
        return false;
      }
  }



  template <int dim>
  void
  ElastoPlasticContact<dim>::equilibrate_adapted_mesh(Statistics &statistics)
  {
    SolveResult result = solve();
    statistics.add_solve(result);
    statistics.add_mesh_change(last_step.result, result);
    if (last_step.result.contact_area >= last_step.largest_contact_area)
      last_step.largest_contact_area = result.contact_area;

    result.plastic_work           = 0;
    result.dissipation            = 0;
    result.frictional_dissipation = 0;
    last_step.add_to(result);
    last_step.result = result;
    load_program.reached(result.time, result.depth, result.force);
    commit_state();
  }



  // Of its nodal forces, only those count that hold the body; the others are
  // what it lacks for an equilibrium, and do no work.
  template <int dim>
  void
  ElastoPlasticContact<dim>::commit_interpolated_state()
  {
    take_back_step();
    VectorType held;
    body.solid.initialize_vector(held);
    body.supports.set_fixed_entries(held, 1.);
    for (const unsigned int i : body.contact.force_entries())
      held.local_element(i) = 1.;

    body.solid.internal_forces(body.residual, body.displacement);
    body.residual.sadd(-1., 1., body.external_forces);
    body.residual.scale(held);
    last_step.forces = body.forces_of_stresses();
  }



  template class ElastoPlasticContact<2>;
  template class ElastoPlasticContact<3>;
} // namespace ElastoPlastic
