// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "elasto_plastic_contact.h"

namespace ElastoPlastic
{
  // The starting guess for a step that continues the last one: things go on at
  // the same rate. (Finite strains need a guess as soon as there is one: a
  // surface that moves alone would crush the elements below.)
  template <int dim>
  void
  ElastoPlasticContact<dim>::predict()
  {
    const double       begin  = time_steps.time();
    double             depth  = last_step.result.depth;
    const unsigned int n_past = model.strain_model.is_finite() ? 1 : 2;
    if (time_steps.number() > n_past && !load_program.is_segment_end(begin))
      {
        const double duration = time_steps.next_time() - begin;
        depth += duration * last_step.depth_rate;
        displacement.add(duration, last_step.displacement_rate);
        if (contact.is_force_driven())
          contact.place(depth);
      }
    contact.divide_edge(depth);
  }



  // Back to the end of the last step. (The material points have not forgotten
  // it.)
  template <int dim>
  void
  ElastoPlasticContact<dim>::take_back_step()
  {
    if (last_step.is_virgin())
      displacement = 0.;
    else
      displacement = last_step.displacement;
    solid->predict_flow(displacement, displacement);
    contact.deactivate_all();
    move_indenter(last_step.result.time);
    contact.begin_step(displacement, {});
    contact.place(last_step.result.depth);
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



  // The end of a step: the work that has been done in it, and, in a history,
  // what the next step begins with.
  template <int dim>
  void
  ElastoPlasticContact<dim>::commit_step(SolveResult &result)
  {
    result.external_work =
      last_step.work_to(displacement, forces_of_stresses());
    last_step.add_to(result);
    last_step.find_rates(result, displacement);
    last_step.result = result;
    if (result.contact_area > 0. &&
        result.contact_area >= largest_contact_area &&
        load_program.is_segment_end(result.time))
      look_at_contact();
    largest_contact_area = std::max(largest_contact_area, result.contact_area);
    imprint.note(result);
    load_program.reached(result.time, result.depth, result.force);
    if (!parameters.loading.is_single_step())
      commit_state();
  }



  // At the end of a way in.
  template <int dim>
  void
  ElastoPlasticContact<dim>::look_at_contact()
  {
    if (const std::string warning =
          contact_zone().warning(model.indenter.shape->detail());
        !warning.empty())
      log.warn_once(warning);
  }



  template <int dim>
  ContactZone<dim>
  ElastoPlasticContact<dim>::contact_zone() const
  {
    return ContactZone<dim>(dof_handler,
                            supports.hanging_nodes(),
                            supports.fixed_dofs(),
                            model.boundary_conditions.ids(
                              BoundaryConditionType::contact),
                            contact,
                            residual);
  }



  // How far the surface has slipped along the indenter until now.
  template <int dim>
  VectorType
  ElastoPlasticContact<dim>::total_slip() const
  {
    VectorType slip = contact.slip(displacement);
    if (!last_step.is_virgin())
      slip += last_step.slip;
    return slip;
  }



  // From now on, this equilibrium is where the next step begins.
  template <int dim>
  void
  ElastoPlasticContact<dim>::commit_state()
  {
    last_step.slip = total_slip();
    solid->commit(displacement);
    solid->predict_flow(displacement, displacement);
    last_step.displacement = displacement;
    last_step.forces       = forces_of_stresses();
    contact.note_edge(displacement);
  }



  // Those of the step under way, since the last one: they do not if they only
  // become smaller. The virgin body bears none. Collective.
  template <int dim>
  bool
  ElastoPlasticContact<dim>::tractions_grow() const
  {
    VectorType growth = external_forces;
    if (!last_step.is_virgin())
      growth -= external_forces_at(time_steps.time());
    return growth * external_forces > 0;
  }



  template class ElastoPlasticContact<2>;
  template class ElastoPlasticContact<3>;
} // namespace ElastoPlastic
