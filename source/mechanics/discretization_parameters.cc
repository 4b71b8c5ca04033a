// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "mechanics/discretization_parameters.h"

namespace ElastoPlastic
{
  void
  DiscretizationParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Discretization");
    prm.add_parameter("Polynomial degree",
                      degree,
                      "The degree p of the displacement elements FE_Q(p): 1 or "
                      "2. Quadratic elements do not lock and are the more "
                      "accurate ones per unknown.",
                      Patterns::Integer(1, 2));
    prm.add_parameter(
      "Volumetric treatment",
      volumetric_treatment,
      "standard: full integration; linear elements then lock as soon as plastic "
      "flow dominates and show no limit load. B-bar: the volume change enters "
      "by its mean over each cell, which does not lock.",
      Patterns::Selection("standard|B-bar"));
    prm.leave_subsection();
  }



  VolumetricTreatment
  DiscretizationParameters::treatment() const
  {
    return volumetric_treatment == "B-bar" ? VolumetricTreatment::b_bar :
                                             VolumetricTreatment::standard;
  }
} // namespace ElastoPlastic
