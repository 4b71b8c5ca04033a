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
    supports.set_time(dof_handler, model.boundary_conditions, time);
    compute_external_forces(external_forces,
                            dof_handler,
                            supports.constraints(),
                            model.boundary_conditions,
                            model.strain_model.kinematics,
                            time);
    contact.set_load(load_program.load(time).value());
  }



  // The starting guess for a step that continues the last one: things go on at
  // the same rate.
  template <int dim>
  void
  ElastoPlasticContact<dim>::predict()
  {
    const double begin = time_steps.time();
    if (time_steps.number() < 3 || load_program.is_segment_end(begin))
      return;
    const double duration = time_steps.next_time() - begin;
    displacement.add(duration, displacement_rate);
    if (contact.is_force_driven())
      contact.place(last_step.depth + duration * depth_rate);
  }



  // Back to the end of the last step. (The material points have not forgotten
  // it.)
  template <int dim>
  void
  ElastoPlasticContact<dim>::take_back_step()
  {
    if (committed_displacement.size() > 0)
      displacement = committed_displacement;
    else
      displacement = 0.;
    solid->predict_flow(displacement, displacement);
    contact.deactivate_all();
    contact.place(last_step.depth);
    contact.activate_touching(displacement);
  }



  // The nodal forces that are in equilibrium with the stresses.
  template <int dim>
  VectorType
  ElastoPlasticContact<dim>::forces_of_stresses() const
  {
    VectorType forces = external_forces;
    forces -= residual;
    return forces;
  }



  // The end of a step: the work that has been done in it (that of the external
  // forces by the trapezoidal rule), and what the next step begins with.
  template <int dim>
  void
  ElastoPlasticContact<dim>::commit_step(SolveResult &result)
  {
    const VectorType forces = forces_of_stresses();
    result.external_work =
      last_step.external_work + 0.5 * (forces * displacement);
    if (time_steps.number() > 1)
      result.external_work += 0.5 * (committed_forces * displacement -
                                     forces * committed_displacement -
                                     committed_forces * committed_displacement);
    const double duration = result.time - last_step.time;
    depth_rate            = (result.depth - last_step.depth) / duration;
    result.plastic_work += last_step.plastic_work;
    result.dissipation += last_step.dissipation;
    last_step = result;

    load_program.reached(result.time, result.depth, result.force);
    if (result.time == load_program.final_time())
      return;
    displacement_rate = displacement;
    if (time_steps.number() > 1)
      displacement_rate -= committed_displacement;
    displacement_rate /= duration;
    commit_state();
  }



  // From now on, this equilibrium is where the next step begins.
  template <int dim>
  void
  ElastoPlasticContact<dim>::commit_state()
  {
    solid->commit(displacement);
    solid->predict_flow(displacement, displacement);
    committed_displacement = displacement;
    committed_forces       = forces_of_stresses();
  }



  template class ElastoPlasticContact<2>;
  template class ElastoPlasticContact<3>;
} // namespace ElastoPlastic
