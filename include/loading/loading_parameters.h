// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef loading_loading_parameters_h
#define loading_loading_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <string>

#include "loading/load.h"
#include "loading/time_steps.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// The entries of the section "Loading"; see LoadProgram for their meaning.
  struct LoadingParameters
  {
    Control      control = Control::depth;
    std::string  depth   = "0.01";
    std::string  force   = "1";
    std::string  history;
    std::string  path;
    unsigned int n_steps        = 1;
    StepControl  step_control   = StepControl::fixed;
    double       step_tolerance = 0.002;
    double       final_time     = 1;
    unsigned int max_cuts       = 6;

    void
    add_parameters(ParameterHandler &prm);

    /// @throws InputError
    void
    check() const;

    /// Whether the load is one step from the virgin state, Johnson's stationary
    /// problem, rather than a history.
    bool
    is_single_step() const;
  };
} // namespace ElastoPlastic

#endif
