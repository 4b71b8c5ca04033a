// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <cmath>

#include "material/material_lists.h"
#include "material/yield_criterion_parameters.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Beyond, a body that can collapse is hard to tell from one that cannot.
    constexpr double largest_friction_angle = 60.;

    /// Below, but for zero, rates of volume are not much more than what
    /// rounding errors leave of those of shear, and the interior point method
    /// ends before the bounds are the closest ones of a mesh.
    constexpr double smallest_friction_angle = 0.1;



    double
    in_radians(const double degrees)
    {
      return degrees * numbers::PI / 180.;
    }
  } // namespace



  void
  SoilParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Cohesion",
                      cohesions,
                      "c > 0, the shear stress that a 'Mohr-Coulomb' or "
                      "'Drucker-Prager' material bears on planes without "
                      "pressure. A ground without cohesion is approached by a "
                      "small one. Unit: stress.",
                      Patterns::List(Patterns::Double(), 1));
    prm.add_parameter("Friction angle",
                      friction_angles,
                      "phi, 0 or from 0.1 to 60 degrees: the shear stress "
                      "that a 'Mohr-Coulomb' material bears, and in plane "
                      "strain a 'Drucker-Prager' one, grows by tan(phi) times "
                      "the pressure on its plane. Unit: degrees.",
                      Patterns::List(Patterns::Double(), 1));
  }



  void
  SoilParameters::check() const
  {
    require(
      "Cohesion",
      cohesions,
      [](const double c) { return c > 0; },
      "it must be greater than 0: without cohesion, stresses at a free surface "
      "are at the limit whatever the load. A small one (a thousandth of weight "
      "times width) changes little.");
    require(
      "Friction angle",
      friction_angles,
      [](const double phi) {
        return phi == 0 || (phi >= smallest_friction_angle &&
                            phi <= largest_friction_angle);
      },
      "it must be 0, or lie between 0.1 and 60 degrees: with less friction, "
      "rounding errors would decide whether the soil dilates. Set it to 0.");
  }



  SoilStrength
  SoilParameters::mohr_coulomb(const unsigned int id) const
  {
    const double phi = in_radians(of_material(friction_angles, id));
    return {std::sqrt(2.) * of_material(cohesions, id) * std::cos(phi),
            std::sin(phi)};
  }



  SoilStrength
  SoilParameters::drucker_prager(const unsigned int id) const
  {
    const auto [radius, sine] = mohr_coulomb(id);
    const double factor       = 1. / std::sqrt(1. + sine * sine / 3.);
    return {factor * radius, factor * sine};
  }
} // namespace ElastoPlastic
