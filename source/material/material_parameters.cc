// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <limits>

#include "material/material_lists.h"
#include "material/material_parameters.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Smaller elastic strains are lost in the rounding of plastic ones.
    constexpr double smallest_yield_strain = 1e-8;

    /// What a law makes of the entries of the section.
    struct LawProperties
    {
      bool yields, reads_isotropic_modulus, reads_kinematic_modulus,
        is_nonlinear;
    };



    LawProperties
    properties_of(const MaterialLaw law)
    {
      switch (law)
        {
          case MaterialLaw::linear_elastic:
            return {false, false, false, false};
          case MaterialLaw::perfectly_plastic:
            return {true, false, false, false};
          case MaterialLaw::isotropic_hardening:
            return {true, true, false, false};
          case MaterialLaw::kinematic_hardening:
            return {true, false, true, false};
          case MaterialLaw::combined_hardening:
            return {true, true, true, false};
          case MaterialLaw::nonlinear_hardening:
            return {true, true, false, true};
        }
      AssertThrow(false, ExcInternalError());
      return {};
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
      Patterns::List(*Patterns::Tools::Convert<MaterialLaw>::to_pattern(), 1));
    prm.add_parameter("Young's modulus",
                      young_moduli,
                      "E, from 1e-30 to 1e30. Unit: stress.",
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
                      "hardening', 'combined hardening' and 'nonlinear "
                      "hardening'. Unit: stress.",
                      Patterns::List(Patterns::Double(), 1));
    prm.add_parameter("Kinematic hardening modulus",
                      kinematic_moduli,
                      "H_k >= 0 in Prager's rule: the back stress grows by 2/3 "
                      "H_k times the plastic strain. Used by 'kinematic "
                      "hardening' and 'combined hardening'. Unit: stress.",
                      Patterns::List(Patterns::Double(), 1));
    add_nonlinear_hardening(prm);
    criteria.add_parameters(prm);
    rates.add_parameters(prm);
    prm.leave_subsection();
  }



  // What 'nonlinear hardening' reads, and no other law.
  void
  MaterialParameters::add_nonlinear_hardening(ParameterHandler &prm)
  {
    prm.add_parameter("Voce stress",
                      voce_stresses,
                      "Q >= 0: 'nonlinear hardening' adds Q (1 - exp(-b "
                      "alpha)) to the yield stress. Unit: stress.",
                      Patterns::List(Patterns::Double(), 1));
    prm.add_parameter("Voce rate",
                      voce_rates,
                      "b, greater than 0 where Q is. No unit.",
                      Patterns::List(Patterns::Double(), 1));
    prm.add_parameter("Power law exponent",
                      power_law_exponents,
                      "N, from 0 to 1: 'nonlinear hardening' adds sigma_0 ((1 "
                      "+ alpha/eps_0)^N - 1) to the yield stress (Swift). No "
                      "unit.",
                      Patterns::List(Patterns::Double(), 1));
    prm.add_parameter("Power law reference strain",
                      power_law_reference_strains,
                      "eps_0 > 0. No unit.",
                      Patterns::List(Patterns::Double(), 1));
    prm.add_parameter(
      "Hardening table",
      hardening_tables,
      "'none', or pairs of equivalent plastic strain and yield stress, such as "
      "'0.01: 450 | 0.05: 500': 'nonlinear hardening' adds what this table "
      "has beyond sigma_0. It begins with sigma_0 at 0, with or without a pair "
      "that says so, is linear between its points and constant beyond the last "
      "one. Unit: stress.",
      Patterns::List(Patterns::Anything(), 1));
    prm.add_parameter(
      "Back stress moduli",
      back_stress_moduli,
      "'none', or the moduli C of up to four back stresses of 'nonlinear "
      "hardening', such as '20000 | 5000'. In uniaxial tension a back stress X "
      "grows by C - gamma X per unit of plastic strain "
      "(Armstrong-Frederick, Chaboche). Unit: stress.",
      Patterns::List(Patterns::Anything(), 1));
    prm.add_parameter("Recovery rates",
                      recovery_rates,
                      "'none', or the rate gamma >= 0 of each back stress, "
                      "such as '400 | 0'; 0 is Prager's linear hardening. No "
                      "unit.",
                      Patterns::List(Patterns::Anything(), 1));
  }



  void
  MaterialParameters::check() const
  {
    require(
      "Young's modulus",
      young_moduli,
      [](const double E) { return E >= 1e-30 && E <= 1e30; },
      "it must be greater than 0, from 1e-30 to 1e30: tangents are kept in "
      "single precision. Choose a system of units in which it is.");
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

    const unsigned int n = n_materials();
    for (const auto &[entry, size] : list_lengths())
      if (size != 1 && size != n)
        throw InputError("The entry 'Material/" + entry + "' has " +
                         std::to_string(size) +
                         " values, but another entry of this section has " +
                         std::to_string(n) +
                         ". Give one value for all materials or one for "
                         "each. " +
                         decimal_point_hint);
    check_yield_strains();
    check_nonlinear_hardening();
    check_rate_laws();
    criteria.check(materials());
  }



  void
  MaterialParameters::check_yield_strains() const
  {
    for (unsigned int id = 0; id < n_materials(); ++id)
      {
        const double yield_stress  = of_material(yield_stresses, id);
        const double young_modulus = of_material(young_moduli, id);
        if (of_material(laws, id) != MaterialLaw::linear_elastic &&
            !criteria.is_soil(id) &&
            yield_stress < smallest_yield_strain * young_modulus)
          throw InputError(
            "Material/Yield stress",
            yield_stresses,
            "with 'Material/Young's modulus = " +
              Patterns::Tools::to_string(young_modulus) +
              "' the material yields at a strain of " +
              Patterns::Tools::to_string(yield_stress / young_modulus) +
              ". Strains below " +
              Patterns::Tools::to_string(smallest_yield_strain) +
              " are lost in the rounding of plastic ones. Are both numbers in "
              "the same system of units? If the material is to be rigid, a "
              "smaller modulus does as well.");
      }
  }



  void
  MaterialParameters::check_nonlinear_hardening() const
  {
    require(
      "Voce stress",
      voce_stresses,
      [](const double Q) { return Q >= 0; },
      "it must not be negative: softening is not part of this model.");
    require(
      "Voce rate",
      voce_rates,
      [](const double b) { return b >= 0 && b * smallest_strain <= 1; },
      "it must be between 0 and 1e12.");
    require(
      "Power law exponent",
      power_law_exponents,
      [](const double n) { return n >= 0 && n <= 1; },
      "it must lie between 0 (no such hardening) and 1 (linear).");
    require(
      "Power law reference strain",
      power_law_reference_strains,
      [](const double eps_0) { return eps_0 >= smallest_strain; },
      "it must be at least 1e-12.");
    for (unsigned int id = 0; id < n_materials(); ++id)
      {
        if (of_material(voce_stresses, id) > 0 &&
            of_material(voce_rates, id) == 0)
          throw InputError("Material/Voce rate",
                           voce_rates,
                           "'Material/Voce stress' is not 0: then the rate "
                           "must be greater than 0.");
        hardening_curve(id);
        nonlinear_back_stresses(id);
      }
  }



  void
  MaterialParameters::check_rate_laws() const
  {
    rates.check();
    for (unsigned int id = 0; id < n_materials(); ++id)
      {
        const RateLawType type = rates.rate_law(id).type;
        if (of_material(laws, id) == MaterialLaw::linear_elastic &&
            type != RateLawType::none && type != RateLawType::norton)
          throw InputError(
            "Material/Rate law",
            rates.types,
            "with 'Law = linear elastic' the material does not flow, however "
            "fast: choose a law with a yield stress, or 'Norton', which "
            "creeps at any stress.");
      }
  }



  std::vector<std::pair<std::string, unsigned int>>
  MaterialParameters::list_lengths() const
  {
    std::vector<std::pair<std::string, unsigned int>> result = {
      {"Law", laws.size()},
      {"Young's modulus", young_moduli.size()},
      {"Poisson's ratio", poisson_ratios.size()},
      {"Yield stress", yield_stresses.size()},
      {"Isotropic hardening modulus", isotropic_moduli.size()},
      {"Kinematic hardening modulus", kinematic_moduli.size()},
      {"Voce stress", voce_stresses.size()},
      {"Voce rate", voce_rates.size()},
      {"Power law exponent", power_law_exponents.size()},
      {"Power law reference strain", power_law_reference_strains.size()},
      {"Hardening table", hardening_tables.size()},
      {"Back stress moduli", back_stress_moduli.size()},
      {"Recovery rates", recovery_rates.size()}};
    for (const auto &more : {rates.list_lengths(), criteria.list_lengths()})
      result.insert(result.end(), more.begin(), more.end());
    return result;
  }



  unsigned int
  MaterialParameters::n_materials() const
  {
    unsigned int n = 0;
    for (const auto &[entry, size] : list_lengths())
      n = std::max(n, size);
    return n;
  }



  HardeningCurve
  MaterialParameters::hardening_curve(const unsigned int id) const
  {
    const double sigma_0 = of_material(yield_stresses, id);
    return HardeningCurve(
      {of_material(voce_stresses, id), of_material(voce_rates, id)},
      {sigma_0,
       of_material(power_law_exponents, id),
       of_material(power_law_reference_strains, id)},
      read_hardening_table(of_material(hardening_tables, id), sigma_0));
  }



  std::vector<BackStressLaw<double>>
  MaterialParameters::nonlinear_back_stresses(const unsigned int id) const
  {
    return read_back_stresses(of_material(back_stress_moduli, id),
                              of_material(recovery_rates, id));
  }



  std::vector<BackStressLaw<double>>
  MaterialParameters::back_stresses(const unsigned int id) const
  {
    const LawProperties law = properties_of(of_material(laws, id));
    const double        H_k = of_material(kinematic_moduli, id);
    if (law.is_nonlinear)
      return nonlinear_back_stresses(id);
    if (law.reads_kinematic_modulus && H_k > 0)
      return {{2. / 3. * H_k, 0.}};
    return {};
  }



  std::vector<Material<double>>
  MaterialParameters::materials() const
  {
    std::vector<Material<double>> result;
    for (unsigned int id = 0; id < n_materials(); ++id)
      {
        const LawProperties law     = properties_of(of_material(laws, id));
        const double        E       = of_material(young_moduli, id);
        const double        nu      = of_material(poisson_ratios, id);
        const double        sigma_0 = law.yields ?
                                        of_material(yield_stresses, id) :
                                        std::numeric_limits<double>::infinity();
        const double        H =
          law.reads_isotropic_modulus ? of_material(isotropic_moduli, id) : 0.;

        Material<double> material;
        material.bulk_modulus      = E / (3 * (1 - 2 * nu));
        material.shear_modulus     = E / (2 * (1 + nu));
        material.yield_radius      = law.yields && criteria.is_soil(id) ?
                                       criteria.soil_strength(id).yield_radius :
                                       std::sqrt(2. / 3.) * sigma_0;
        material.isotropic_modulus = 2. / 3. * H;
        for (const auto &back_stress : back_stresses(id))
          material.back_stresses.push_back(back_stress);
        if (law.is_nonlinear)
          {
            material.curves[0] =
              std::make_shared<HardeningCurve>(hardening_curve(id));
            material.is_linear = false;
          }
        material.rate_laws[0] = rates.rate_law(id);
        material.criteria[0]  = criteria.criterion(id);
        material.is_linear    = material.is_linear &&
                             !is_rate_dependent(material) &&
                             !has_general_criterion(material);
        result.push_back(material);
      }
    return result;
  }
} // namespace ElastoPlastic
