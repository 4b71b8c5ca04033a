// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef material_material_parameters_h
#define material_material_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

#include "material/material.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// The entries of the section "Material". Every list holds one value for all
  /// materials or one value per material id 0, 1, 2, ...
  struct MaterialParameters
  {
    std::vector<std::string> laws             = {"isotropic hardening"};
    std::vector<double>      young_moduli     = {200000.};
    std::vector<double>      poisson_ratios   = {0.3};
    std::vector<double>      yield_stresses   = {400.};
    std::vector<double>      isotropic_moduli = {2000.};
    std::vector<double>      kinematic_moduli = {0.};

    void
    add_parameters(ParameterHandler &prm);

    /// @throws InputError for a value out of range and for lists of different
    /// lengths.
    void
    check() const;

    /// The constants of all material ids, in their order. A single one stands
    /// for every id.
    std::vector<Material<double>>
    materials() const;
  };
} // namespace ElastoPlastic

#endif
