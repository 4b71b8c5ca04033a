// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/tensors.h"
#include "bounds/body/hencky_material.h"
#include "material/plane_stress.h"
#include "material/radial_return.h"

namespace ElastoPlastic
{
  namespace
  {
    double
    youngs_modulus(const Material<double> &material)
    {
      return 9. * material.bulk_modulus * material.shear_modulus /
             (3. * material.bulk_modulus + material.shear_modulus);
    }
  } // namespace



  double
  HenckyMaterial::hardening(const Material<double> &material)
  {
    double sum = material.isotropic_modulus;
    for (const auto &law : material.back_stresses)
      sum += law.modulus;
    return sum;
  }



  HenckyMaterial::Units
  HenckyMaterial::units_of(const std::vector<Material<double>> &materials)
  {
    double modulus = 0, radius = std::numeric_limits<double>::infinity();
    for (const Material<double> &material : materials)
      {
        modulus = std::max(modulus, youngs_modulus(material));
        radius  = std::min(radius, material.yield_radius);
      }
    const double stress = std::isfinite(radius) ? radius : 1e-3 * modulus;
    return {stress, stress / modulus};
  }



  SymmetricTensor<2, 3>
  HenckyMaterial::compliance(const Material<double>      &material,
                             const SymmetricTensor<2, 3> &stress)
  {
    return trace(stress) / (9. * material.bulk_modulus) *
             unit_symmetric_tensor<3>() +
           deviator(stress) / (2. * material.shear_modulus);
  }



  double
  HenckyMaterial::elastic_product(const Material<double>      &material,
                                  const SymmetricTensor<2, 3> &strain)
  {
    return material.bulk_modulus * trace(strain) * trace(strain) +
           2. * material.shear_modulus * (deviator(strain) * deviator(strain));
  }



  HenckyMaterial::Strain
  HenckyMaterial::split_strain(const Material<double>      &material,
                               const SymmetricTensor<2, 3> &strain)
  {
    const MaterialState<double> virgin(material.back_stresses.size());
    const RadialReturn<double>  step(material, strain_deviator(strain), virgin);
    const SymmetricTensor<2, 3> plastic =
      strain_deviator(strain) -
      step.deviatoric_stress() / (2. * material.shear_modulus);
    return {strain - plastic, plastic};
  }



  SymmetricTensor<2, 3>
  HenckyMaterial::strain_of_section(const Material<double>      &material,
                                    const SymmetricTensor<2, 3> &strain,
                                    const Kinematics             kinematics)
  {
    SymmetricTensor<2, 3> result = strain;
    if (kinematics == Kinematics::plane_stress)
      result[2][2] = out_of_plane_strain(
        material, strain, MaterialState<double>(material.back_stresses.size()));
    return result;
  }



  double
  HenckyMaterial::quadratic_gap(const Material<double>      &material,
                                const RateNorm              &norm,
                                const SymmetricTensor<2, 3> &strain,
                                const SymmetricTensor<2, 3> &plastic_strain,
                                const SymmetricTensor<2, 3> &stress,
                                const double                 zeta)
  {
    const auto   d = strain - plastic_strain - compliance(material, stress);
    const double h = hardening(material);
    double       result = 0.5 * elastic_product(material, d);
    if (yields(material))
      result -= stress * plastic_strain;
    if (h > 0)
      {
        const double size = norm(plastic_strain);
        result += 0.5 * h * size * size + 0.5 * zeta * zeta / h;
      }
    return result;
  }
} // namespace ElastoPlastic
