// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <sstream>

#include "evaluation/small_strain_guard.h"

namespace ElastoPlastic
{
  template <int dim>
  SmallStrainGuard<dim>::SmallStrainGuard(const NominalContact<dim> &contact)
    : contact(contact)
  {}



  template <int dim>
  void
  SmallStrainGuard<dim>::compare(const std::string &what,
                                 const double       value,
                                 const double       limit,
                                 std::string       &text)
  {
    if (!(value > limit) || !exceeded.insert(what).second)
      return;
    std::ostringstream comparison;
    comparison.precision(3);
    comparison << what << " is " << value << " (limit: " << limit << ")";
    text += (text.empty() ? "" : ", ") + comparison.str();
  }



  template <int dim>
  std::string
  SmallStrainGuard<dim>::warning(const SolveResult &result)
  {
    std::string text;
    compare("the largest equivalent plastic strain",
            result.max_equivalent_plastic_strain,
            largest_plastic_strain,
            text);
    if (contact.is_single() && contact.radius_at_surface(result.depth) &&
        result.contact_area > 0.)
      {
        const double touched = contact.radius(result.contact_area);
        const auto   slope   = contact.slope(touched);
        if (slope)
          compare("the slope of the indenter at the edge of the contact",
                  *slope,
                  largest_slope,
                  text);
        else if (!contact.is_strip())
          compare("the depth over the contact radius",
                  contact.depth_of_tip(result.depth) / touched,
                  largest_relative_depth,
                  text);
      }
    if (text.empty())
      return text;
    return "Step " + std::to_string(result.step) +
           " leaves the theory of small strains: " + text +
           ". What follows is approximate, most of all at the edge of the "
           "contact; see doc/trust/small_strains.md. "
           "This is not said again.";
  }



  template class SmallStrainGuard<2>;
  template class SmallStrainGuard<3>;
} // namespace ElastoPlastic
