// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "input/limit_load_parameters.h"

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
    prm.add_parameter(
      "Stresses",
      stresses,
      "Those of the lower bound, in two dimensions: polynomials on each third "
      "of a triangle, in a body of revolution times the distance from the "
      "axis. "
      "linear: cheaper, and enough where the upper bound is the worse one, as "
      "in plane stress. "
      "quadratic: on the same mesh the lower bound has a half to a fifth of the "
      "error, and takes about three times as long; in plane strain this pays "
      "for bounds within some 0.3 %. "
      "automatic: quadratic in a body of revolution, else linear. "
      "In space, stresses are linear.");
    prm.leave_subsection();
  }



  // At equal time, the bounds of bodies of revolution are closer by a factor of
  // two with quadratic stresses; those in the plane are not before they are
  // within 0.3 % (doc/trust/cost_of_bounds.md).
  unsigned int
  LimitLoadParameters::degree_of_stresses(const bool is_axisymmetric) const
  {
    if (stresses == StressDegree::automatic)
      return is_axisymmetric ? 2 : 1;
    return stresses == StressDegree::linear ? 1 : 2;
  }
} // namespace ElastoPlastic
