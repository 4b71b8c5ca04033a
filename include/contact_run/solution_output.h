// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_run_solution_output_h
#define contact_run_solution_output_h

#include <string>

#include "base/compatibility.h"
#include "contact_run/discrete_body.h"
#include "contact_run/error_estimate.h"
#include "contact_run/load_step.h"
#include "output/field_output.h"

namespace ElastoPlastic
{
  /// When the fields of a solution are written, and under which names: a single
  /// load step once for each mesh, a history once for each step.
  template <int dim>
  class SolutionOutput
  {
  public:
    /// All arguments must outlive this object.
    SolutionOutput(const OutputParameters  &parameters,
                   const bool               is_single_step,
                   const DiscreteBody<dim> &body,
                   ErrorEstimate<dim>      &error_estimate,
                   TimerOutput             &timer);

    /// Whether those of the step under way are written, on its last mesh.
    bool
    are_due(const TimeSteps &steps) const;

    /// Writes the solution at the end of the @p step under way, on the present
    /// mesh, if that is due. In a history, the fields of a step are those on
    /// its last mesh. Collective. @throws FileError
    void
    write(const LoadStep<dim> &step, const bool is_last_cycle);

    /// Writes the virgin body and the indenter where it stands, at t = 0 of a
    /// history. Collective. @throws FileError
    void
    write_initial_state();

    /// Waits until what has been written is on the disk. Collective.
    /// @throws FileError
    void
    write_to_disk()
    {
      field_output.write_to_disk(communicator_of(body.dof_handler()));
    }

    /// The list of what has been written, for checkpoints.
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /* version */)
    {
      archive &field_output;
    }

  private:
    void
    write_fields(const std::string &name,
                 const double       time,
                 const LastStep    &last_step);

    const OutputParameters  &parameters;
    const bool               is_single_step;
    const DiscreteBody<dim> &body;
    ErrorEstimate<dim>      &error_estimate;
    TimerOutput             &timer;
    FieldOutput<dim>         field_output;
  };
} // namespace ElastoPlastic

#endif
