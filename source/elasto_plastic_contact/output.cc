// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/utilities.h>

#include "elasto_plastic_contact.h"

namespace ElastoPlastic
{
  // Those of the step under way, on its last mesh.
  template <int dim>
  bool
  ElastoPlasticContact<dim>::fields_are_due() const
  {
    const auto &output = parameters.output;
    switch (output.fields)
      {
        case FieldOutputTimes::every_cycle:
          return true;
        case FieldOutputTimes::last_cycle:
          return time_steps.next_time() == load_program.final_time();
        case FieldOutputTimes::at_times:
          return output.has_time_within(time_steps.time(),
                                        time_steps.next_time());
        case FieldOutputTimes::never:
          return false;
      }
    Assert(false, ExcInternalError());
    return false;
  }



  // In a history, the fields of a step are those on its last mesh.
  template <int dim>
  void
  ElastoPlasticContact<dim>::output_results(const bool last_cycle)
  {
    const bool single_step = parameters.loading.is_single_step();
    const auto when        = parameters.output.fields;
    const bool every_cycle =
      single_step && when == FieldOutputTimes::every_cycle;
    if (!fields_are_due() || !(last_cycle || every_cycle))
      return;

    const unsigned int number = single_step ? cycle : time_steps.number();
    write_fields(when == FieldOutputTimes::last_cycle ?
                   "last" :
                   Utilities::int_to_string(number, 3),
                 single_step ? cycle : time_steps.next_time());
    if (error_bound && error_bound->why_missing().empty())
      error_bound->write_fields(cycle);
  }



  // The virgin body and the indenter where it stands, at t = 0 of a history.
  template <int dim>
  void
  ElastoPlasticContact<dim>::output_initial_state()
  {
    if (parameters.loading.is_single_step() ||
        parameters.output.fields != FieldOutputTimes::every_cycle)
      return;
    move_indenter(0.);
    contact.place(0.);
    write_fields(Utilities::int_to_string(0, 3), 0.);
  }



  // What the tables say of the end of a step, before the material points take
  // it as the beginning of the next one. (The result that it refers to is still
  // to grow.)
  template <int dim>
  StepResult
  ElastoPlasticContact<dim>::evaluate_step(const SolveResult &result) const
  {
    TimerOutput::Scope scope(timer, "Evaluation");
    StepResult         step = {
              result,
              reactions.compute(*solid,
                        displacement,
                        contact.forces_on_body(displacement, residual),
                        result.time),
              boundary_displacements.compute(dof_handler, displacement),
              {}};
    for (const double value :
         probe_points.compute(dof_handler, *solid, displacement))
      step.probes.push_back(value);
    if (writes_surface_profile(result.time))
      step.surface_profile = imprint.profile(result, contact_surface());
    return step;
  }



  template <int dim>
  void
  ElastoPlasticContact<dim>::write_fields(const std::string &name,
                                          const double       time)
  {
    TimerOutput::Scope scope(timer, "Output");
    field_output.write({dof_handler,
                        supports.constraints(),
                        *solid,
                        contact,
                        model.boundary_conditions.ids(
                          BoundaryConditionType::contact),
                        displacement,
                        residual,
                        total_slip(),
                        error_indicators},
                       name,
                       time);
  }



  template <int dim>
  bool
  ElastoPlasticContact<dim>::writes_surface_profile(const double time) const
  {
    switch (parameters.output.surface_profile)
      {
        case SurfaceProfileSteps::every_step:
          return true;
        case SurfaceProfileSteps::segment_ends:
          return load_program.is_segment_end(time);
        case SurfaceProfileSteps::last_step:
          return time == load_program.final_time();
        case SurfaceProfileSteps::none:
          return false;
      }
    Assert(false, ExcInternalError());
    return false;
  }



  template class ElastoPlasticContact<2>;
  template class ElastoPlasticContact<3>;
} // namespace ElastoPlastic
