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

  /// How the strength of a soil grows with the pressure: by |dev s| <= R -
  /// sqrt(2) f m, with the mean stress m, tension being positive.
  struct SoilStrength
  {
    double yield_radius; ///< R, unit: stress
    double slope;        ///< f, less than 1
  };



  /// The entries of the section "Material" about strength that grows with the
  /// pressure: lists like the others of MaterialParameters. On no plane, the
  /// shear stress of Mohr and Coulomb's soil exceeds c + p tan(phi), with the
  /// pressure p on the plane.
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

    /// Of the material @p id in plane strain, s_33 being the mean of s_11 and
    /// s_22: R = sqrt(2) c cos(phi), f = sin(phi).
    SoilStrength
    mohr_coulomb(const unsigned int id) const;

    /// Of the cone that Drucker and Prager have chosen @cite
    /// drucker_prager_1952: it bears as much as Mohr and Coulomb's soil where a
    /// body flows in plane strain. Its R and f are those of mohr_coulomb() over
    /// sqrt(1 + sin^2(phi) / 3); they write alpha = f / 3 and k = R / sqrt(2).
    SoilStrength
    drucker_prager(const unsigned int id) const;
  };
} // namespace ElastoPlastic

#endif
