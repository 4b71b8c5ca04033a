// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>

#include "base/exceptions.h"
#include "base/text.h"
#include "material/material_lists.h"

namespace ElastoPlastic
{
  namespace
  {
    /// The numbers in @p text, none of them negative.
    std::vector<double>
    read_numbers(const std::string &path, const std::string &text)
    {
      std::vector<double> numbers;
      if (text != "none")
        for (const auto &part : split(path, text, '|'))
          {
            const auto number = as_number(part);
            if (!number || !is_moderate(*number) || *number < 0)
              throw InputError(path,
                               text,
                               "it must be 'none', or numbers that are finite "
                               "and not negative, at most 1e100, one for each "
                               "back stress, separated by '|'.");
            numbers.push_back(*number);
          }
      return numbers;
    }
  } // namespace



  std::vector<HardeningCurve::Point>
  read_hardening_table(const std::string &text, const double yield_stress)
  {
    static const std::string path = "Material/Hardening table";

    std::vector<HardeningCurve::Point> table;
    if (text == "none")
      return table;
    HardeningCurve::Point last = {0., 0.};
    for (const auto &row : split(path, text, '|'))
      {
        const auto parts  = split(path, row, ':');
        const auto strain = as_number(parts.empty() ? "" : parts.front());
        const auto stress = as_number(parts.empty() ? "" : parts.back());
        if (parts.size() != 2 || !strain || !stress || !is_moderate(*strain) ||
            !is_moderate(*stress))
          throw InputError(path,
                           text,
                           "it must be 'none', or pairs of equivalent plastic "
                           "strain and yield stress, such as '0.01: 450 | "
                           "0.05: 500'.");
        if (table.empty() && *strain == 0. && *stress == yield_stress)
          continue;
        if (*strain - last.strain < smallest_strain)
          throw InputError(path,
                           text,
                           "its strains must increase, and be greater than 0: "
                           "there, the yield stress is 'Material/Yield "
                           "stress'. Steps below 1e-12 are lost in rounding.");
        const double rise = *stress - yield_stress;
        if (rise < last.rise)
          throw InputError(path,
                           text,
                           "its stresses must not decrease, nor begin below "
                           "'Material/Yield stress': softening is not part of "
                           "this model.");
        last = {*strain, rise};
        table.push_back(last);
      }
    return table;
  }



  std::vector<BackStressLaw<double>>
  read_back_stresses(const std::string &moduli, const std::string &rates)
  {
    const auto C     = read_numbers("Material/Back stress moduli", moduli);
    const auto gamma = read_numbers("Material/Recovery rates", rates);
    if (C.size() > max_back_stresses)
      throw InputError("Material/Back stress moduli",
                       moduli,
                       "a material can have at most " +
                         std::to_string(max_back_stresses) + " back stresses.");
    if (gamma.size() != C.size())
      throw InputError("Material/Recovery rates",
                       rates,
                       "'Material/Back stress moduli' is '" + moduli +
                         "': give one rate for each modulus, 0 where nothing "
                         "recovers.");

    std::vector<BackStressLaw<double>> laws;
    for (unsigned int k = 0; k < C.size(); ++k)
      if (C[k] > 0) // without it, there is nothing that could recover
        laws.push_back({2. / 3. * C[k], std::sqrt(2. / 3.) * gamma[k]});
    return laws;
  }
} // namespace ElastoPlastic
