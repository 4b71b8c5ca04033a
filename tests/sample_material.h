// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tests_sample_material_h
#define tests_sample_material_h

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



/// E = 200000, nu = 0.3, Y = 400; the hardening moduli add up to 2000.
inline ElastoPlastic::MaterialParameters
sample_parameters(const std::string &law)
{
  const double modulus = (law == "combined hardening" ? 1000. : 2000.);
  ElastoPlastic::MaterialParameters parameters;
  parameters.laws             = {law};
  parameters.young_moduli     = {200000.};
  parameters.poisson_ratios   = {0.3};
  parameters.yield_stresses   = {400.};
  parameters.isotropic_moduli = {modulus};
  parameters.kinematic_moduli = {modulus};
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



/// What a point might remember of a load far beyond yield.
inline ElastoPlastic::MaterialState<double>
sample_state(const ElastoPlastic::Material<double> &material)
{
  ElastoPlastic::MaterialState<double> state;
  state.plastic_strain = deviator(sample_tensor<3>(17, 0.003));
  state.back_stress    = material.kinematic_modulus * state.plastic_strain;
  state.equivalent_plastic_strain =
    2. * std::sqrt(2. / 3.) * state.plastic_strain.norm();
  return state;
}

#endif
