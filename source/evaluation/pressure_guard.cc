// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <limits>

#include "evaluation/pressure_guard.h"

namespace ElastoPlastic
{
  namespace
  {
    /// The largest stress at which the material yields in one direction, its
    /// back stresses included, at this equivalent plastic strain.
    double
    largest_yield_stress(const Material<double> &material, const double strain)
    {
      double stress = std::sqrt(1.5) * material.yield_radius +
                      1.5 * material.isotropic_modulus * strain;
      if (material.curves[0])
        stress += material.curves[0]->value(strain);
      for (const auto &[modulus, recovery] : material.back_stresses)
        {
          const double growth = 1.5 * modulus * strain;
          stress += recovery > 0. ?
                      std::min(growth, std::sqrt(1.5) * modulus / recovery) :
                      growth;
        }
      return stress;
    }
  } // namespace



  double
  largest_indentation_pressure(const Material<double> &material,
                               const double            plastic_strain)
  {
    const double yield_stress = largest_yield_stress(material, plastic_strain);
    if (!(yield_stress < std::numeric_limits<double>::infinity()) ||
        is_rate_dependent(material) || has_general_criterion(material))
      return std::numeric_limits<double>::infinity();
    const double K = material.bulk_modulus, G = material.shear_modulus;
    const double E      = 9. * K * G / (3. * K + G);
    const double nu     = E / (2. * G) - 1.;
    const double cavity = 2. / 3. * yield_stress *
                          (1. + std::log(E / (3. * (1. - nu) * yield_stress)));
    return std::max(3. * yield_stress, cavity);
  }



  PressureGuard::PressureGuard(const std::vector<Material<double>> &materials)
    : materials(materials)
  {}



  double
  PressureGuard::limit(const double plastic_strain) const
  {
    double largest = 0;
    for (const Material<double> &material : materials)
      largest =
        std::max(largest,
                 largest_indentation_pressure(material, plastic_strain));
    return factor * largest;
  }



  bool
  PressureGuard::is_exceeded(const double pressure, const double plastic_strain)
  {
    if (was_exceeded || !(pressure > limit(plastic_strain)))
      return false;
    was_exceeded = true;
    return true;
  }
} // namespace ElastoPlastic
