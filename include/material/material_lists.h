// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef material_material_lists_h
#define material_material_lists_h

#include <deal.II/base/patterns.h>

#include <cmath>
#include <string>
#include <vector>

#include "base/exceptions.h"
#include "material/material.h"

namespace ElastoPlastic
{
  /// The scale of plastic strain on which a yield stress may change: smaller
  /// ones are lost in rounding, and slopes become infinite.
  constexpr double smallest_strain = 1e-12;

  /// Whether products of @p number with others are finite.
  inline bool
  is_moderate(const double number)
  {
    return std::abs(number) <= 1e100;
  }



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
                         values,
                         condition(value) ?
                           "its numbers must not exceed 1e100." :
                         values.size() == 1 ? what :
                                              what + " " + decimal_point_hint);
  }



  /// Reads the entry 'Material/Hardening table' of one material: "none", or
  /// pairs of equivalent plastic strain and yield stress such as
  /// "0.01: 450 | 0.05: 500". The table begins at (0, @p yield_stress).
  /// @throws InputError if it cannot be read or decreases.
  std::vector<HardeningCurve::Point>
  read_hardening_table(const std::string &text, const double yield_stress);

  /// Reads the entries 'Material/Back stress moduli' and 'Material/Recovery
  /// rates' of one material: "none", or numbers such as "20000 | 5000", one for
  /// each back stress.
  /// @throws InputError for numbers out of range, or not as many rates as
  /// moduli.
  std::vector<BackStressLaw<double>>
  read_back_stresses(const std::string &moduli, const std::string &rates);
} // namespace ElastoPlastic

#endif
