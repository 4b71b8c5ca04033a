// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/utilities.h>

#include <algorithm>

#include "input/entry_effects.h"

namespace ElastoPlastic
{
  namespace
  {
    using namespace EntryReasons;

    /// The value of material @p id, in a list with one for each or one for all.
    template <typename Value>
    const Value &
    of_material(const std::vector<Value> &list, const unsigned int id)
    {
      return list[std::min<std::size_t>(id, list.size() - 1)];
    }
  } // namespace



  std::vector<std::string>
  doubtful_units(const EntryValues &values)
  {
    constexpr double          largest_ratio = 1e5;
    const std::vector<double> moduli =
      numbers(values, "Material/Young's modulus");
    const std::vector<double> stresses =
      numbers(values, "Material/Yield stress");
    const Names laws =
      dealii::Utilities::split_string_list(values.at("Material/Law"));
    const std::string isotropic = "Material/Isotropic hardening modulus";
    const std::string kinematic = "Material/Kinematic hardening modulus";
    const std::size_t n_materials =
      std::max({moduli.size(),
                stresses.size(),
                laws.size(),
                numbers(values, isotropic).size(),
                numbers(values, kinematic).size()});

    std::vector<std::string> sentences;
    for (unsigned int id = 0; id < n_materials; ++id)
      {
        const std::string &law     = of_material(laws, id);
        const double       modulus = of_material(moduli, id);
        const std::string  where   = " of material " + std::to_string(id);
        if (law != "linear elastic" &&
            modulus > largest_ratio * of_material(stresses, id))
          sentences.push_back(
            "'Material/Young's modulus'" + where +
            " is more than 1e5 times its 'Yield stress', as no solid's is");
        const auto look_at = [&](const std::string &path, const Names &users) {
          if (std::find(users.begin(), users.end(), law) != users.end() &&
              of_material(numbers(values, path), id) > modulus)
            sentences.push_back("'" + path + "'" + where +
                                " is larger than its 'Young's modulus'");
        };
        look_at(isotropic,
                {"isotropic hardening",
                 "combined hardening",
                 "nonlinear hardening"});
        look_at(kinematic, {"kinematic hardening", "combined hardening"});
      }
    return sentences;
  }
} // namespace ElastoPlastic
