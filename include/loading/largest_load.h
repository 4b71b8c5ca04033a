// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef loading_largest_load_h
#define loading_largest_load_h

#include <optional>

#include "loading/load_program.h"
#include "loading/time_steps.h"

namespace ElastoPlastic
{
  /// The largest depth or force that is prescribed at the ends of @p steps;
  /// none if it is never prescribed, or not known in advance.
  std::optional<double>
  largest_load(const LoadProgram &load_program,
               TimeSteps          steps,
               const Control      control);
} // namespace ElastoPlastic

#endif
