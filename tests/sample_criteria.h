// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tests_sample_criteria_h
#define tests_sample_criteria_h

#include "sample_material.h"

// Materials with the criteria of Hosford and Hill to test with.

const std::vector<std::string> all_criteria = {"Hosford 6",
                                               "Hosford 40",
                                               "Hill"};

/// Those that do not recover.
const std::vector<std::string> lasting_laws = {"perfectly plastic",
                                               "isotropic hardening",
                                               "kinematic hardening",
                                               "combined hardening",
                                               "Voce",
                                               "power law",
                                               "steeper table"};



inline void
set_criterion(ElastoPlastic::MaterialParameters &parameters,
              const std::string                 &name)
{
  ElastoPlastic::YieldCriterionParameters &criteria = parameters.criteria;
  if (name == "Hill")
    {
      criteria.criteria    = {ElastoPlastic::YieldCriterion::hill};
      criteria.hill_ratios = {"1 | 1.1 | 0.85 | 0.95 | 1.2 | 0.9"};
      criteria.axes        = {"20 | 40 | 70"};
    }
  else
    {
      criteria.criteria          = {ElastoPlastic::YieldCriterion::hosford};
      criteria.hosford_exponents = {std::stod(name.substr(8))};
    }
}



inline ElastoPlastic::Material<double>
material_with(
  const std::string               &criterion,
  const std::string               &law,
  const ElastoPlastic::RateLawType rate_law = ElastoPlastic::RateLawType::none)
{
  ElastoPlastic::MaterialParameters parameters = sample_parameters(law);
  set_criterion(parameters, criterion);
  parameters.rates.types                   = {rate_law};
  parameters.rates.exponents               = {3.};
  parameters.rates.stresses                = {300.};
  ElastoPlastic::Material<double> material = parameters.materials().front();
  material.step_duration                   = 0.01;
  return material;
}



inline double
equivalent_stress(const ElastoPlastic::GeneralCriterion &criterion,
                  const dealii::SymmetricTensor<2, 3>   &stress)
{
  return std::visit(
    [&](const auto &of_type) {
      return of_type.equivalent_stress(deviator(stress));
    },
    criterion);
}



/// dq/ds
inline dealii::SymmetricTensor<2, 3>
normal(const ElastoPlastic::GeneralCriterion &criterion,
       const dealii::SymmetricTensor<2, 3>   &stress)
{
  return std::visit(
    [&](const auto &of_type) {
      return
        typename std::decay_t<decltype(of_type)>::Relaxation(of_type,
                                                             deviator(stress))
          .normal();
    },
    criterion);
}

#endif
