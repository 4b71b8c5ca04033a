// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

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
      "only, or never. The tables (.csv) are always written.");
    prm.add_parameter(
      "Steps between checkpoints",
      checkpoint_interval,
      "In a load history: after how many steps the folder checkpoint is "
      "written, from which the option --resume goes on. A run that receives "
      "the signal SIGTERM writes one before it ends. 0: only then.",
      Patterns::Integer(0));
    prm.add_parameter(
      "Screen",
      screen,
      "What is printed. full: versions, one line per Newton "
      "step, times. summary: only the table of results, without "
      "anything that a clock or the number of processes could "
      "change. quiet: nothing but errors.");
    prm.leave_subsection();
  }
} // namespace ElastoPlastic
