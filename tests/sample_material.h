// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tests_sample_material_h
#define tests_sample_material_h

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "material/material_parameters.h"
#include "material/radial_return.h"

// Materials and states of a point to test with.

const std::vector<std::string> all_laws = {"linear elastic",
                                           "perfectly plastic",
                                           "isotropic hardening",
                                           "kinematic hardening",
                                           "combined hardening"};



/// The examples of 'nonlinear hardening' in sample_parameters().
const std::vector<std::string> nonlinear_laws = {"Voce",
                                                 "power law",
                                                 "table",
                                                 "steeper table",
                                                 "Armstrong-Frederick",
                                                 "Chaboche",
                                                 "everything"};



inline void
set_nonlinear_hardening(const std::string                 &law,
                        ElastoPlastic::MaterialParameters &parameters)
{
  const bool all  = (law == "everything");
  parameters.laws = {ElastoPlastic::MaterialLaw::nonlinear_hardening};
  parameters.isotropic_moduli = {all ? 500. : 0.};
  if (law == "Voce" || all)
    {
      parameters.voce_stresses = {200.};
      parameters.voce_rates    = {15.};
    }
  if (law == "power law" || all)
    {
      parameters.power_law_exponents         = {0.2};
      parameters.power_law_reference_strains = {0.002};
    }
  if (law == "table" || all)
    parameters.hardening_tables = {"0.001: 430 | 0.01: 500 | 0.02: 500"};
  if (law == "steeper table")
    parameters.hardening_tables = {"0.015: 400 | 0.1: 5000"};
  if (law == "Armstrong-Frederick")
    {
      parameters.back_stress_moduli = {"30000"};
      parameters.recovery_rates     = {"150"};
    }
  if (law == "Chaboche" || all)
    {
      parameters.back_stress_moduli = {"60000 | 10000 | 1000"};
      parameters.recovery_rates     = {"1000 | 100 | 0"};
    }
}



/// E = 200000, nu = 0.3, Y = 400; linear hardening moduli add up to 2000.
inline ElastoPlastic::MaterialParameters
sample_parameters(const std::string &law)
{
  const double modulus = (law == "combined hardening" ? 1000. : 2000.);
  ElastoPlastic::MaterialParameters parameters;
  parameters.young_moduli     = {200000.};
  parameters.poisson_ratios   = {0.3};
  parameters.yield_stresses   = {400.};
  parameters.isotropic_moduli = {modulus};
  parameters.kinematic_moduli = {modulus};
  if (std::count(all_laws.begin(), all_laws.end(), law) == 0)
    set_nonlinear_hardening(law, parameters);
  else
    parameters.laws = {
      dealii::Patterns::Tools::Convert<ElastoPlastic::MaterialLaw>::to_value(
        law)};
  return parameters;
}



inline ElastoPlastic::Material<double>
sample_material(const std::string &law)
{
  return sample_parameters(law).materials().front();
}



/// A symmetric tensor with entries up to @p size, a different one for each
/// @p number.
template <int dim>
dealii::SymmetricTensor<2, dim>
sample_tensor(const unsigned int number, const double size)
{
  dealii::SymmetricTensor<2, dim> tensor;
  for (unsigned int i = 0; i < tensor.n_independent_components; ++i)
    tensor.access_raw_entry(i) = size * std::sin(1. + 2.3 * number + 1.7 * i);
  return tensor;
}



/// What a point might remember of a load far beyond yield. Several back
/// stresses have different directions.
inline ElastoPlastic::MaterialState<double>
sample_state(const ElastoPlastic::Material<double> &material)
{
  ElastoPlastic::MaterialState<double> state(material.back_stresses.size());
  state.plastic_strain = deviator(sample_tensor<3>(17, 0.003));
  for (unsigned int k = 0; k < state.back_stresses.size(); ++k)
    {
      const auto &[modulus, recovery] = material.back_stresses[k];
      const auto strain = deviator(sample_tensor<3>(17 + k, 0.003));
      state.back_stresses[k] =
        modulus / (1. + recovery * strain.norm()) * strain;
    }
  state.equivalent_plastic_strain =
    2. * std::sqrt(2. / 3.) * state.plastic_strain.norm();
  return state;
}

#endif
