// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "base/exceptions.h"
#include "loading/loading_parameters.h"

namespace ElastoPlastic
{
  void
  LoadingParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Loading");
    prm.add_parameter("Depth",
                      depth,
                      "delta > 0: how far the indenter is pushed down from "
                      "where it stands undisplaced. With an 'Indenter/Initial "
                      "gap' the first part of the way is through air. Unit: "
                      "length.",
                      Patterns::Double());
    prm.add_parameter("Number of steps",
                      n_steps,
                      "The load steps from the virgin state to the full depth. "
                      "This version solves Johnson's stationary problem: one "
                      "step (Hencky's deformation theory).",
                      Patterns::Integer(1, 1));
    prm.add_parameter("Final time",
                      final_time,
                      "The value of t in the expressions of boundary "
                      "conditions at the end of the step. Unit: time.",
                      Patterns::Double());
    prm.leave_subsection();
  }



  void
  LoadingParameters::check() const
  {
    if (!(depth > 0))
      throw InputError(
        "Loading/Depth",
        Patterns::Tools::to_string(depth),
        "it must be greater than 0. For a body that is loaded by "
        "its boundary conditions alone set 'Indenter/Type = "
        "none'.");
  }
} // namespace ElastoPlastic
