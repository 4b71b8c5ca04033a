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



    /// Yield conditions must be second-order cones; where rates change the
    /// volume, von Mises' only are known.
    void
    check_criteria_of_bounds(const MaterialParameters &material,
                             const Analysis            analysis)
    {
      if (material.criteria.has(YieldCriterion::hosford))
        refuse(material,
               "'Analysis = " + Patterns::Tools::to_string(analysis) +
                 "' has no bounds for the criterion of Hosford. Choose another "
                 "one, or 'Analysis = contact'.");
      for (unsigned int id = 0; id < material.n_materials(); ++id)
        if (material.criteria.has_varying_axes(id))
          throw InputError("Material/Axes",
                           material.criteria.axes,
                           "'Analysis = " +
                             Patterns::Tools::to_string(analysis) +
                             "' knows axes that are the same everywhere. Write "
                             "numbers, or choose 'Analysis = contact'.");
      if (material.criteria.has_soil())
        refuse(
          material,
          "beside soil, other materials can obey the criterion of von Mises "
          "only. Choose 'von Mises' in place of 'Hill'.");
    }
  } // namespace



  // The flow rule of soil is that of a rigid body that collapses, and changes
  // its volume.
  void
  Parameters::check_soil() const
  {
    if (!material.criteria.has_soil())
      return;
    const std::string name =
      material.criteria.has(YieldCriterion::mohr_coulomb) ? "Mohr-Coulomb" :
                                                            "Drucker-Prager";
    if (analysis != Analysis::limit_load)
      refuse(material,
             "'" + name +
               "' is for limit loads. Set 'Analysis = limit load', or choose "
               "'von Mises'.");
    const Kinematics kinematics = discretization.kinematics;
    if (material.criteria.has(YieldCriterion::mohr_coulomb) &&
        (dimension == 3 || kinematics != Kinematics::cartesian))
      refuse(material,
             "'Mohr-Coulomb' is for plane strain. Set 'Dimension = 2' and "
             "'Kinematics = plane strain', or choose 'von Mises', or in space "
             "or in a body of revolution 'Drucker-Prager'.");
    if (material.criteria.has(YieldCriterion::drucker_prager) &&
        dimension == 2 && kinematics != Kinematics::axisymmetric)
      refuse(material,
             "'Drucker-Prager' is for bodies of revolution and for bodies in "
             "space. Set 'Kinematics = axisymmetric' or 'Dimension = 3', or "
             "choose 'von Mises', or in plane strain 'Mohr-Coulomb', which "
             "bears the same there.");
    if (contact.geometry == ContactGeometry::normal)
      throw InputError("Contact/Geometry",
                       contact.geometry,
                       "on soil ('Material/Yield criterion = " + name +
                         "') indenters press vertically. Choose 'vertical'.");
  }



  void
  Parameters::check_yield_criterion() const
  {
    if (!material.criteria.are_general())
      return;
    if (dimension == 2)
      material.criteria.check_third_axis();
    if (analysis != Analysis::contact)
      check_criteria_of_bounds(material, analysis);
    if (analysis == Analysis::limit_load)
      return;
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
  }
} // namespace ElastoPlastic
