// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

#include "base/exceptions.h"
#include "io/output_parameters.h"

namespace ElastoPlastic
{
  void
  OutputParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Output");
    prm.add_parameter("Directory",
                      directory,
                      "Where the results go. It is created if it does not "
                      "exist; results that are there already are replaced only "
                      "with the option --overwrite.");
    prm.add_parameter(
      "Fields",
      fields,
      "When solution-*.vtu and surface-*.vtu are written: after "
      "every cycle (in a load history: after every step), after the last one "
      "only, at the 'Field times', or never. The tables (.csv) are always "
      "written.");
    prm.add_parameter(
      "Field times",
      field_times,
      "For 'Fields = at times': values of the time t, such as 1, 1.5, 2. The "
      "fields are those at the end of the load step that reaches or passes one "
      "of them. Unit: time.",
      Patterns::List(Patterns::Double(0)));
    prm.add_parameter(
      "Minutes between checkpoints",
      minutes_between_checkpoints,
      "In a load history: how often the folder checkpoint is written, from "
      "which the option --resume goes on: at the end of the load step under "
      "way after so many minutes, and at the end of the history. A run that "
      "receives the signal SIGTERM writes one before it ends, so that only what "
      "kills at once or takes the power away can cost so many minutes of work. "
      "0: after every step.",
      Patterns::Double(0));
    prm.add_parameter(
      "Screen",
      screen,
      "What is printed. full: versions, one line per Newton "
      "step, times. summary: only the table of results, without "
      "anything that a clock or the number of processes could "
      "change. quiet: nothing but errors.");
    prm.leave_subsection();
  }



  void
  OutputParameters::check() const
  {
    if (fields == FieldOutputTimes::at_times && field_times.empty())
      throw InputError("Output/Field times",
                       "",
                       "with 'Output/Fields = at times' it must name at least "
                       "one time.");
  }



  bool
  OutputParameters::has_time_within(const double begin, const double end) const
  {
    constexpr double rounding = 1e-9;
    return std::any_of(field_times.begin(),
                       field_times.end(),
                       [&](const double time) {
                         return time > begin + rounding * end &&
                                time <= end + rounding * end;
                       });
  }
} // namespace ElastoPlastic
