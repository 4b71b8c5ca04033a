// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef material_rate_law_parameters_h
#define material_rate_law_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <utility>
#include <vector>

#include "base/enum_names.h"
#include "material/rate_law.h"

namespace ElastoPlastic
{
  using namespace dealii;

  template <>
  inline const EnumNames<RateLawType> enum_names<RateLawType> = {
    {"none", RateLawType::none},
    {"Perzyna", RateLawType::perzyna},
    {"Norton", RateLawType::norton},
    {"Cowper-Symonds", RateLawType::cowper_symonds},
    {"Duvaut-Lions", RateLawType::duvaut_lions}};



  /// The entries of the section "Material" about rate dependence: lists like
  /// the others of MaterialParameters.
  struct RateLawParameters
  {
    std::vector<RateLawType> types            = {RateLawType::none};
    std::vector<double>      exponents        = {1.};
    std::vector<double>      reference_rates  = {1.};
    std::vector<double>      stresses         = {100.};
    std::vector<double>      relaxation_times = {1.};

    /// In the section, which has been entered.
    void
    add_parameters(ParameterHandler &prm);

    /// @throws InputError for a value out of range.
    void
    check() const;

    /// The number of values of each entry.
    std::vector<std::pair<std::string, unsigned int>>
    list_lengths() const;

    RateLaw
    rate_law(const unsigned int id) const;
  };
} // namespace ElastoPlastic

#endif
