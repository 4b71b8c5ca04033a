// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "base/tensors.h"
#include "material/plane_stress.h"
#include "material/positive_root.h"

namespace ElastoPlastic
{
  SymmetricTensor<2, 3>
  PlaneStressReturn::back_stress(const double multiplier) const
  {
    SymmetricTensor<2, 3> sum;
    for (unsigned int k = 0; k < material.back_stresses.size(); ++k)
      sum += material.back_stresses[k].remainder(multiplier) *
             old_state.back_stresses[k];
    return sum;
  }



  // 0 = sigma_33 = 2 G (e_33 - e_p,33 - w x n_33) + K tr(strain), with n = z /
  // resistance, z = 2 G (e - e_p) - back stress and the RateLaw's relaxation w,
  // is linear in the strain.
  double
  PlaneStressReturn::out_of_plane_strain(const Flow &flow) const
  {
    const double bulk  = material.bulk_modulus;
    const double two_g = 2. * material.shear_modulus;
    const double shed =
      flow.multiplier > 0 ?
        material.rate_laws[0].relaxation(material.step_duration) * two_g *
          flow.multiplier / flow.resistance :
        0.; // (where nothing flows, there may be no resistance)
    const double trace = strain[0][0] + strain[1][1];
    return ((1. - shed) * two_g *
              (trace / 3. + old_state.plastic_strain[2][2]) -
            shed * back_stress(flow.multiplier)[2][2] - bulk * trace) /
           ((1. - shed) * two_g * 2. / 3. + bulk);
  }



  double
  PlaneStressReturn::excess(const Flow &flow) const
  {
    SymmetricTensor<2, 3> complete = strain;
    complete[2][2]                 = out_of_plane_strain(flow);
    return (2. * material.shear_modulus *
              (strain_deviator(complete) - old_state.plastic_strain) -
            back_stress(flow.multiplier))
             .norm() -
           flow.resistance;
  }



  double
  PlaneStressReturn::out_of_plane_strain() const
  {
    const Flow   without      = resistance.at(0.);
    const double first_excess = excess(without);
    if (!(first_excess > 0) || !resistance.flow_stress.can_flow())
      return out_of_plane_strain(without);

    return out_of_plane_strain(resistance.at(positive_root(
      [this](const double unknown) { return excess(resistance.at(unknown)); },
      first_excess,
      resistance.upper_bound(first_excess))));
  }
} // namespace ElastoPlastic
