// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef material_soil_parameters_h
#define material_soil_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <utility>
#include <vector>

namespace ElastoPlastic
{
  using namespace dealii;

  /// The entries of the section "Material" about strength that grows with the
  /// pressure: lists like the others of MaterialParameters. On no plane, the
  /// shear stress of a soil exceeds c + p tan(phi), with the pressure p on the
  /// plane.
  struct SoilParameters
  {
    std::vector<double> cohesions       = {100.}; ///< c, unit: stress
    std::vector<double> friction_angles = {30.};  ///< phi, in degrees

    /// In the section, which has been entered.
    void
    add_parameters(ParameterHandler &prm);

    /// @throws InputError for a value out of range.
    void
    check() const;

    /// The number of values of each entry.
    std::vector<std::pair<std::string, unsigned int>>
    list_lengths() const;

    /// sin(phi) of the material @p id.
    double
    friction_sine(const unsigned int id) const;

    /// Of the deviator of a plane stress without pressure, s_33 being the mean
    /// of s_11 and s_22: sqrt(2) c cos(phi). Unit: stress.
    double
    yield_radius(const unsigned int id) const;
  };
} // namespace ElastoPlastic

#endif
