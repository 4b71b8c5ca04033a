// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef material_value_per_material_h
#define material_value_per_material_h

#include <deal.II/base/patterns.h>

#include <string>
#include <vector>

#include "base/exceptions.h"
#include "material/hardening_input.h"

namespace ElastoPlastic
{
  /// The value for the material @p id of a list that may hold one for all.
  template <typename T>
  const T &
  of_material(const std::vector<T> &values, const unsigned int id)
  {
    return values.size() == 1 ? values[0] : values[id];
  }



  /// @throws InputError for the @p entry of the section "Material", saying
  /// @p what is allowed, if one of its @p values does not satisfy the
  /// @p condition.
  template <typename Condition>
  void
  require(const std::string         &entry,
          const std::vector<double> &values,
          const Condition           &condition,
          const std::string         &what)
  {
    for (const double value : values)
      if (!condition(value) || !is_moderate(value))
        throw InputError("Material/" + entry,
                         dealii::Patterns::Tools::to_string(values),
                         condition(value) ?
                           "its numbers must not exceed 1e100." :
                           what);
  }
} // namespace ElastoPlastic

#endif
