// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "equilibrium/limit_load_parameters.h"

namespace ElastoPlastic
{
  void
  LimitLoadParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Limit load");
    prm.add_parameter(
      "Load",
      load,
      "What 'Analysis = limit load' lets grow. "
      "indenter: the force of the indenter, beside tractions and body forces "
      "as they are at t = 0. "
      "tractions: tractions and body forces, by a common load factor. They "
      "must be linear in the time t, which is the factor: what is in "
      "proportion to t grows, as in 'Traction = top: 0; t', and the rest is "
      "constant. If t appears nowhere, all of them grow. An indenter does not "
      "move then, and bears what presses against it.");
    prm.leave_subsection();
  }
} // namespace ElastoPlastic
