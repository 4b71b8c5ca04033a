// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/utilities.h>

#include "contact_run/solution_output.h"

namespace ElastoPlastic
{
  template <int dim>
  SolutionOutput<dim>::SolutionOutput(const OutputParameters  &parameters,
                                      const bool               is_single_step,
                                      const DiscreteBody<dim> &body,
                                      ErrorEstimate<dim>      &error_estimate,
                                      TimerOutput             &timer)
    : parameters(parameters)
    , is_single_step(is_single_step)
    , body(body)
    , error_estimate(error_estimate)
    , timer(timer)
    , field_output(parameters)
  {}



  template <int dim>
  bool
  SolutionOutput<dim>::are_due(const TimeSteps &steps) const
  {
    switch (parameters.fields)
      {
        case FieldOutputTimes::every_cycle:
          return true;
        case FieldOutputTimes::last_cycle:
          return steps.next_time() == body.model.load_program.final_time();
        case FieldOutputTimes::at_times:
          return parameters.has_time_within(steps.time(), steps.next_time());
        case FieldOutputTimes::never:
          return false;
      }
    Assert(false, ExcInternalError());
    return false;
  }



  template <int dim>
  void
  SolutionOutput<dim>::write(const LoadStep<dim> &step,
                             const bool           is_last_cycle)
  {
    const FieldOutputTimes when = parameters.fields;
    const bool             every_mesh =
      is_single_step && when == FieldOutputTimes::every_cycle;
    if (!are_due(step.times()) || !(is_last_cycle || every_mesh))
      return;

    const unsigned int number =
      is_single_step ? step.cycle() : step.times().number();
    write_fields(when == FieldOutputTimes::last_cycle ?
                   "last" :
                   Utilities::int_to_string(number, 3),
                 is_single_step ? step.cycle() : step.times().next_time(),
                 step.last());
    error_estimate.write_fields(step.cycle());
  }



  template <int dim>
  void
  SolutionOutput<dim>::write_initial_state()
  {
    if (!is_single_step && parameters.fields == FieldOutputTimes::every_cycle)
      write_fields(Utilities::int_to_string(0, 3), 0., LastStep());
  }



  template <int dim>
  void
  SolutionOutput<dim>::write_fields(const std::string &name,
                                    const double       time,
                                    const LastStep    &last_step)
  {
    TimerOutput::Scope scope(timer, "Output");
    field_output.write({body.dof_handler(),
                        body.supports().constraints(),
                        body.solid(),
                        body.contact(),
                        body.contact_boundaries(),
                        body.displacement(),
                        body.residual(),
                        body.total_slip(last_step),
                        body.error_indicators()},
                       name,
                       time);
  }



  template class SolutionOutput<2>;
  template class SolutionOutput<3>;
} // namespace ElastoPlastic
