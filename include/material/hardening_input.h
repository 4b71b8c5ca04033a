// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef material_hardening_input_h
#define material_hardening_input_h

#include <cmath>
#include <string>
#include <vector>

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
