// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_discretization_parameters_h
#define mechanics_discretization_parameters_h

#include <deal.II/base/parameter_handler.h>

#include "base/kinematics.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// The entries of the section "Discretization", and the entries "Kinematics"
  /// and "Strain".
  struct DiscretizationParameters
  {
    unsigned int        degree               = 1;
    VolumetricTreatment volumetric_treatment = VolumetricTreatment::standard;
    Kinematics          kinematics           = Kinematics::cartesian;
    Strain              strain               = Strain::small;

    void
    add_parameters(ParameterHandler &prm);

    StrainModel
    strain_model() const
    {
      return {volumetric_treatment, kinematics, strain};
    }
  };
} // namespace ElastoPlastic

#endif
