// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "material/material_lists.h"
#include "material/material_parameters.h"

namespace ElastoPlastic
{
  void
  RateLawParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter(
      "Rate law",
      types,
      "How the flow depends on the rate r of the equivalent plastic strain; "
      "time is that of the load history. 'none': not at all. With the "
      "overstress ratio y = (r / r_0)^(1/n) the flow stress is sigma_Y + D y "
      "('Perzyna'), sigma_Y (1 + y) ('Cowper-Symonds'), or the smaller of D y "
      "and sigma_Y ('Norton': creep, together with 'Law = linear elastic' "
      "without yielding). 'Duvaut-Lions': stress and hardening relax "
      "towards what they would be without rate dependence.",
      Patterns::List(*Patterns::Tools::Convert<RateLawType>::to_pattern(), 1));
    prm.add_parameter("Rate exponent",
                      exponents,
                      "n, from 1 (linear viscosity) to 1000. The rate "
                      "sensitivity is 1/n. Not used by 'Duvaut-Lions'. No "
                      "unit.",
                      Patterns::List(Patterns::Double(), 1));
    prm.add_parameter("Reference rate",
                      reference_rates,
                      "r_0 > 0. Not used by 'Duvaut-Lions'. Unit: 1 / time.",
                      Patterns::List(Patterns::Double(), 1));
    prm.add_parameter("Rate stress",
                      stresses,
                      "D > 0, the stress, for 'Perzyna' the one beyond the "
                      "yield stress, at the reference rate. Unit: stress.",
                      Patterns::List(Patterns::Double(), 1));
    prm.add_parameter("Relaxation time",
                      relaxation_times,
                      "t_r > 0 of 'Duvaut-Lions'. Unit: time.",
                      Patterns::List(Patterns::Double(), 1));
  }



  void
  RateLawParameters::check() const
  {
    require(
      "Rate exponent",
      exponents,
      [](const double n) { return n >= 1 && n <= 1000; },
      "it must lie between 1 (linear viscosity) and 1000 (hardly any "
      "dependence on the rate). It is n in r = r_0 (stress / D)^n, the "
      "reciprocal of the rate sensitivity.");
    const auto is_positive = [](const double value) {
      return value > 0;
    };
    require("Reference rate",
            reference_rates,
            is_positive,
            "it must be greater than 0.");
    require("Rate stress", stresses, is_positive, "it must be greater than 0.");
    require("Relaxation time",
            relaxation_times,
            is_positive,
            "it must be greater than 0. A body without rate dependence has "
            "'Rate law = none'.");
  }



  std::vector<std::pair<std::string, unsigned int>>
  RateLawParameters::list_lengths() const
  {
    return {{"Rate law", types.size()},
            {"Rate exponent", exponents.size()},
            {"Reference rate", reference_rates.size()},
            {"Rate stress", stresses.size()},
            {"Relaxation time", relaxation_times.size()}};
  }



  RateLaw
  RateLawParameters::rate_law(const unsigned int id) const
  {
    return {of_material(types, id),
            of_material(exponents, id),
            of_material(reference_rates, id),
            of_material(stresses, id),
            of_material(relaxation_times, id)};
  }
} // namespace ElastoPlastic
