// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Which problems go with which yield criteria.

#include "base/exceptions.h"
#include "input/parameters.h"

namespace ElastoPlastic
{
  namespace
  {
    [[noreturn]] void
    refuse(const MaterialParameters &material, const std::string &reason)
    {
      throw InputError("Material/Yield criterion",
                       material.criteria.criteria,
                       reason);
    }
  } // namespace



  // The flow rule of soil is that of a rigid body that collapses, where it
  // changes the volume in the plane.
  void
  Parameters::check_soil() const
  {
    if (!material.criteria.has_soil())
      return;
    if (analysis != Analysis::limit_load)
      refuse(material,
             "'Mohr-Coulomb' is for limit loads. Set 'Analysis = limit load', "
             "or choose 'von Mises'.");
    if (dimension == 3 || discretization.kinematics != Kinematics::cartesian)
      refuse(material,
             "'Mohr-Coulomb' is for plane strain. Set 'Dimension = 2' and "
             "'Kinematics = plane strain', or choose 'von Mises'.");
    if (contact.geometry == ContactGeometry::normal)
      throw InputError("Contact/Geometry",
                       contact.geometry,
                       "on soil ('Material/Yield criterion = Mohr-Coulomb') "
                       "indenters press vertically. Choose 'vertical'.");
  }



  void
  Parameters::check_yield_criterion() const
  {
    if (!material.criteria.are_general())
      return;
    if (analysis != Analysis::contact)
      refuse(material,
             "'Analysis = " + Patterns::Tools::to_string(analysis) +
               "' has bounds for the criterion of von Mises only. Choose 'von "
               "Mises', or 'Analysis = contact'.");
    if (discretization.kinematics == Kinematics::plane_stress)
      refuse(material,
             "the strain across a sheet is known for the criterion of von "
             "Mises only. Choose 'von Mises', 'Kinematics = plane strain', or "
             "model the sheet in space.");
    if (discretization.strain == Strain::logarithmic)
      refuse(material,
             "with 'Strain = logarithmic' Newton's method converges for the "
             "criterion of von Mises only. Choose 'von Mises', or 'Strain = "
             "small'.");
    if (dimension == 2)
      material.criteria.check_third_axis();
  }
} // namespace ElastoPlastic
