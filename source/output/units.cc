// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <map>
#include <utility>

#include "output/units.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Force over squared length, if it has a name of its own.
    std::string
    stress_unit(const std::string &force, const std::string &length)
    {
      static const std::map<std::pair<std::string, std::string>, std::string>
                 names = {{{"N", "m"}, "Pa"},
                          {{"N", "mm"}, "MPa"},
                          {{"kN", "mm"}, "GPa"},
                          {{"mN", "µm"}, "GPa"},
                          {{"µN", "µm"}, "MPa"},
                          {{"nN", "nm"}, "GPa"},
                          {{"lbf", "in"}, "psi"}};
      const auto found = names.find({force, length});
      return found == names.end() ? force + "/" + length + "^2" : found->second;
    }
  } // namespace



  bool
  Units::are_named() const
  {
    return !length.empty() && !force.empty();
  }



  std::string
  Units::of(const std::string &quantity) const
  {
    if (quantity == "length" && !length.empty())
      return length;
    if (quantity == "area" && !length.empty())
      return length + "^2";
    if (quantity == "volume" && !length.empty())
      return length + "^3";
    if (quantity == "force" && !force.empty())
      return force;
    if (quantity == "stress" && are_named())
      return stress_unit(force, length);
    if (quantity == "force x length" && are_named())
      return force + " " + length;
    if (quantity == "force / length" && are_named())
      return force + "/" + length;
    return quantity;
  }
} // namespace ElastoPlastic
