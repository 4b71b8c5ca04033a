// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tests_sample_body_materials_h
#define tests_sample_body_materials_h

#include "material/material_parameters.h"

// Materials of a body of two, to test with.

inline ElastoPlastic::MaterialParameters
linear_materials()
{
  ElastoPlastic::MaterialParameters parameters;
  parameters.laws           = {ElastoPlastic::MaterialLaw::isotropic_hardening,
                               ElastoPlastic::MaterialLaw::combined_hardening};
  parameters.young_moduli   = {2., 3.};
  parameters.poisson_ratios = {0.3, 0.4};
  parameters.yield_stresses = {0.2, 0.4};
  parameters.isotropic_moduli = {0.1};
  parameters.kinematic_moduli = {0.2};
  return parameters;
}



/// With a table that becomes steeper.
inline ElastoPlastic::MaterialParameters
nonlinear_materials()
{
  ElastoPlastic::MaterialParameters parameters = linear_materials();
  parameters.laws          = {ElastoPlastic::MaterialLaw::nonlinear_hardening,
                              ElastoPlastic::MaterialLaw::combined_hardening};
  parameters.voce_stresses = {0.1};
  parameters.voce_rates    = {20.};
  parameters.hardening_tables = {"0.05: 0.4| 10: 20"};
  return parameters;
}



inline ElastoPlastic::MaterialParameters
recovering_materials()
{
  ElastoPlastic::MaterialParameters parameters = linear_materials();
  parameters.laws          = {ElastoPlastic::MaterialLaw::nonlinear_hardening,
                              ElastoPlastic::MaterialLaw::combined_hardening};
  parameters.voce_stresses = {0.1};
  parameters.voce_rates    = {20.};
  parameters.back_stress_moduli = {"4 | 0.3"};
  parameters.recovery_rates     = {"20 | 1"};
  return parameters;
}



/// One material of Hill's, one of Hosford's.
inline ElastoPlastic::MaterialParameters
materials_with_criteria()
{
  ElastoPlastic::MaterialParameters parameters = linear_materials();
  parameters.criteria.criteria    = {ElastoPlastic::YieldCriterion::hill,
                                     ElastoPlastic::YieldCriterion::hosford};
  parameters.criteria.hill_ratios = {"1 | 1.2 | 0.9 | 0.8 | 1 | 1"};
  parameters.criteria.axes        = {"25"};
  return parameters;
}

#endif
