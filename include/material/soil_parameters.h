// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef material_soil_parameters_h
#define material_soil_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <utility>
#include <vector>

#include "material/yield_criterion.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// The entries of the section "Material" about the yield criterion, and about
  /// strength that grows with the pressure: lists like the others of
  /// MaterialParameters. On no plane, the shear stress of a soil exceeds
  /// c + p tan(phi), with the pressure p on the plane.
  struct SoilParameters
  {
    std::vector<YieldCriterion> criteria        = {YieldCriterion::von_mises};
    std::vector<double>         cohesions       = {100.}; ///< c, unit: stress
    std::vector<double>         friction_angles = {30.};  ///< phi, in degrees

    /// In the section, which has been entered.
    void
    add_parameters(ParameterHandler &prm);

    /// @throws InputError for a value out of range.
    void
    check() const;

    /// The number of values of each entry.
    std::vector<std::pair<std::string, unsigned int>>
    list_lengths() const;

    /// Whether the criterion of a material is that of Mohr and Coulomb.
    bool
    is_soil(const unsigned int id) const;

    /// Whether that of any is.
    bool
    has_soil() const;

    /// By material id, of the first @p n_materials: sin(phi) of a soil, or 0.
    std::vector<double>
    friction_sines(const unsigned int n_materials) const;

    /// Of the deviator of a plane stress without pressure, s_33 being the mean
    /// of s_11 and s_22: sqrt(2) c cos(phi). Unit: stress.
    double
    yield_radius(const unsigned int id) const;
  };
} // namespace ElastoPlastic

#endif
