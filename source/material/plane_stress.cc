// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>

#include "base/tensors.h"
#include "material/plane_stress.h"
#include "material/positive_root.h"

namespace ElastoPlastic
{
  PlaneStressReturn::PlaneStressReturn(const Material<double>      &material,
                                       const SymmetricTensor<2, 3> &strain,
                                       const MaterialState<double> &old_state)
    : material(material)
    , strain(strain)
    , old_state(old_state)
  {}



  double
  PlaneStressReturn::radius(const double multiplier) const
  {
    const double ratio = std::sqrt(2. / 3.);
    const double alpha =
      old_state.equivalent_plastic_strain + ratio * multiplier;
    double modulus = 2. * material.shear_modulus;
    for (const auto &law : material.back_stresses)
      modulus += law.modulus / (1. + law.recovery * multiplier);
    return modulus * multiplier + material.yield_radius +
           material.isotropic_modulus * alpha / ratio +
           (material.curves[0] ? ratio * material.curves[0]->value(alpha) : 0.);
  }



  SymmetricTensor<2, 3>
  PlaneStressReturn::back_stress(const double multiplier) const
  {
    SymmetricTensor<2, 3> sum;
    for (unsigned int k = 0; k < material.back_stresses.size(); ++k)
      sum += old_state.back_stresses[k] /
             (1. + material.back_stresses[k].recovery * multiplier);
    return sum;
  }



  // 0 = sigma_33 = 2 G (e_33 - e_p,33 - multiplier n_33) + K tr(strain), with
  // n = z / radius and z = 2 G (e - e_p) - back stress, is linear in the
  // strain.
  double
  PlaneStressReturn::out_of_plane_strain(const double multiplier) const
  {
    const double bulk  = material.bulk_modulus;
    const double two_g = 2. * material.shear_modulus;
    const double shed  = two_g * multiplier / radius(multiplier);
    const double trace = strain[0][0] + strain[1][1];
    return ((1. - shed) * two_g *
              (trace / 3. + old_state.plastic_strain[2][2]) -
            shed * back_stress(multiplier)[2][2] - bulk * trace) /
           ((1. - shed) * two_g * 2. / 3. + bulk);
  }



  double
  PlaneStressReturn::excess(const double multiplier) const
  {
    SymmetricTensor<2, 3> complete = strain;
    complete[2][2]                 = out_of_plane_strain(multiplier);
    return (2. * material.shear_modulus *
              (strain_deviator(complete) - old_state.plastic_strain) -
            back_stress(multiplier))
             .norm() -
           radius(multiplier);
  }



  double
  PlaneStressReturn::out_of_plane_strain() const
  {
    const double first_excess = excess(0.);
    if (!(first_excess > 0))
      return out_of_plane_strain(0.);

    return out_of_plane_strain(positive_root(
      [this](const double multiplier) { return excess(multiplier); },
      first_excess,
      first_excess / (2. * material.shear_modulus)));
  }
} // namespace ElastoPlastic
