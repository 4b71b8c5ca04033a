// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/exceptions.h"
#include "material/material_parameters.h"

namespace ElastoPlastic
{
  namespace
  {
    const std::string laws_to_choose_from =
      "linear elastic|perfectly plastic|isotropic hardening|"
      "kinematic hardening|combined hardening";

    /// The value for the material @p id of a list that may hold one for all.
    template <typename T>
    const T &
    of_material(const std::vector<T> &values, const unsigned int id)
    {
      return values.size() == 1 ? values[0] : values[id];
    }

    template <typename Condition>
    void
    require(const std::string         &entry,
            const std::vector<double> &values,
            const Condition           &condition,
            const std::string         &what)
    {
      for (const double value : values)
        if (!std::isfinite(value) || !condition(value))
          throw InputError("Material/" + entry,
                           Patterns::Tools::to_string(values),
                           what);
    }

    bool
    uses_isotropic_modulus(const std::string &law)
    {
      return law == "isotropic hardening" || law == "combined hardening";
    }

    bool
    uses_kinematic_modulus(const std::string &law)
    {
      return law == "kinematic hardening" || law == "combined hardening";
    }

    /// The number of materials: the length of the longest list.
    unsigned int
    n_materials(const MaterialParameters &p)
    {
      return std::max({p.laws.size(),
                       p.young_moduli.size(),
                       p.poisson_ratios.size(),
                       p.yield_stresses.size(),
                       p.isotropic_moduli.size(),
                       p.kinematic_moduli.size()});
    }
  } // namespace



  void
  MaterialParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Material");
    prm.add_parameter(
      "Law",
      laws,
      "The material law. A list, here and in all entries of this section: one "
      "value for the whole body, or one value per material id 0, 1, 2, ... "
      "Laws with hardening read the moduli they need below.",
      Patterns::List(Patterns::Selection(laws_to_choose_from), 1));
    prm.add_parameter("Young's modulus",
                      young_moduli,
                      "E > 0. Unit: stress.",
                      Patterns::List(Patterns::Double(), 1));
    prm.add_parameter("Poisson's ratio",
                      poisson_ratios,
                      "nu, -1 < nu < 0.5. Close to 0.5 choose 'Volumetric "
                      "treatment = B-bar'. No unit.",
                      Patterns::List(Patterns::Double(), 1));
    prm.add_parameter("Yield stress",
                      yield_stresses,
                      "sigma_0 > 0, the stress at which a virgin tension "
                      "specimen yields. Not used by 'linear elastic'. Unit: "
                      "stress.",
                      Patterns::List(Patterns::Double(), 1));
    prm.add_parameter("Isotropic hardening modulus",
                      isotropic_moduli,
                      "H >= 0 in sigma_Y = sigma_0 + H alpha, alpha being the "
                      "equivalent plastic strain. Used by 'isotropic "
                      "hardening' and 'combined hardening'. Unit: stress.",
                      Patterns::List(Patterns::Double(), 1));
    prm.add_parameter("Kinematic hardening modulus",
                      kinematic_moduli,
                      "H_k >= 0 in Prager's rule: the back stress grows by 2/3 "
                      "H_k times the plastic strain. Used by 'kinematic "
                      "hardening' and 'combined hardening'. Unit: stress.",
                      Patterns::List(Patterns::Double(), 1));
    prm.leave_subsection();
  }



  void
  MaterialParameters::check() const
  {
    require(
      "Young's modulus",
      young_moduli,
      [](const double E) { return E > 0; },
      "it must be greater than 0.");
    require(
      "Poisson's ratio",
      poisson_ratios,
      [](const double nu) { return nu > -1 && nu < 0.5; },
      "it must lie between -1 and 0.5, both excluded. An incompressible "
      "material can be approached with 0.499 and 'Volumetric treatment = "
      "B-bar'.");
    require(
      "Yield stress",
      yield_stresses,
      [](const double sigma) { return sigma > 0; },
      "it must be greater than 0. A material that never yields is 'Law = "
      "linear elastic'.");
    require(
      "Isotropic hardening modulus",
      isotropic_moduli,
      [](const double H) { return H >= 0; },
      "it must not be negative: softening is not part of this model.");
    require(
      "Kinematic hardening modulus",
      kinematic_moduli,
      [](const double H) { return H >= 0; },
      "it must not be negative: softening is not part of this model.");

    const unsigned int n = n_materials(*this);
    for (const auto &[entry, size] :
         {std::make_pair("Law", laws.size()),
          std::make_pair("Young's modulus", young_moduli.size()),
          std::make_pair("Poisson's ratio", poisson_ratios.size()),
          std::make_pair("Yield stress", yield_stresses.size()),
          std::make_pair("Isotropic hardening modulus",
                         isotropic_moduli.size()),
          std::make_pair("Kinematic hardening modulus",
                         kinematic_moduli.size())})
      if (size != 1 && size != n)
        throw InputError("The entry 'Material/" + std::string(entry) +
                         "' has " + std::to_string(size) +
                         " values, but another entry of this section has " +
                         std::to_string(n) +
                         ". Give one value for all materials or one for each.");
  }



  std::vector<Material<double>>
  MaterialParameters::materials() const
  {
    std::vector<Material<double>> result;
    for (unsigned int id = 0; id < n_materials(*this); ++id)
      {
        const std::string &law     = of_material(laws, id);
        const double       E       = of_material(young_moduli, id);
        const double       nu      = of_material(poisson_ratios, id);
        const double       sigma_0 = law == "linear elastic" ?
                                       std::numeric_limits<double>::infinity() :
                                       of_material(yield_stresses, id);
        const double       H =
          uses_isotropic_modulus(law) ? of_material(isotropic_moduli, id) : 0.;
        const double H_k =
          uses_kinematic_modulus(law) ? of_material(kinematic_moduli, id) : 0.;

        result.push_back({E / (3 * (1 - 2 * nu)),
                          E / (2 * (1 + nu)),
                          std::sqrt(2. / 3.) * sigma_0,
                          2. / 3. * H,
                          2. / 3. * H_k});
      }
    return result;
  }
} // namespace ElastoPlastic
