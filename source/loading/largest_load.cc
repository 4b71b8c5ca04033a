// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

#include "loading/largest_load.h"

namespace ElastoPlastic
{
  std::optional<double>
  largest_load(const LoadProgram &load_program,
               TimeSteps          steps,
               const Control      control)
  {
    std::optional<double> largest;
    for (; !steps.finished(); steps.advance())
      if (const auto load = load_program.load(steps.next_time());
          load && load->control == control)
        largest = std::max(largest.value_or(load->value), load->value);
    return largest;
  }
} // namespace ElastoPlastic
