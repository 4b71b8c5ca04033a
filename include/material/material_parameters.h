// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef material_material_parameters_h
#define material_material_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <utility>
#include <vector>

#include "base/enum_names.h"
#include "material/rate_law.h"
#include "material/yield_criterion_parameters.h"

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



  /// The values of the entry "Law".
  enum class MaterialLaw
  {
    linear_elastic,
    perfectly_plastic,
    isotropic_hardening,
    kinematic_hardening,
    combined_hardening,
    nonlinear_hardening
  };

  template <>
  inline const EnumNames<MaterialLaw> enum_names<MaterialLaw> = {
    {"linear elastic", MaterialLaw::linear_elastic},
    {"perfectly plastic", MaterialLaw::perfectly_plastic},
    {"isotropic hardening", MaterialLaw::isotropic_hardening},
    {"kinematic hardening", MaterialLaw::kinematic_hardening},
    {"combined hardening", MaterialLaw::combined_hardening},
    {"nonlinear hardening", MaterialLaw::nonlinear_hardening}};



  /// The entries of the section "Material". Every list holds one value for all
  /// materials or one value per material id 0, 1, 2, ...
  struct MaterialParameters
  {
    std::vector<MaterialLaw> laws         = {MaterialLaw::isotropic_hardening};
    std::vector<double>      young_moduli = {200000.};
    std::vector<double>      poisson_ratios   = {0.3};
    std::vector<double>      yield_stresses   = {400.};
    std::vector<double>      isotropic_moduli = {2000.};
    std::vector<double>      kinematic_moduli = {0.};

    // nonlinear hardening; the texts are read by material_lists.h
    std::vector<double>      voce_stresses               = {0.};
    std::vector<double>      voce_rates                  = {0.};
    std::vector<double>      power_law_exponents         = {0.};
    std::vector<double>      power_law_reference_strains = {0.01};
    std::vector<std::string> hardening_tables            = {"none"};
    std::vector<std::string> back_stress_moduli          = {"none"};
    std::vector<std::string> recovery_rates              = {"none"};
    RateLawParameters        rates;
    YieldCriterionParameters criteria;

    void
    add_parameters(ParameterHandler &prm);

    /// @throws InputError for a value out of range and for lists of different
    /// lengths.
    void
    check() const;

    /// The constants of all material ids, in their order. A single one stands
    /// for every id.
    std::vector<Material<double>>
    materials() const;

    /// The longest list.
    unsigned int
    n_materials() const;

  private:
    void
    add_nonlinear_hardening(ParameterHandler &prm);

    void
    check_yield_strains() const;

    void
    check_nonlinear_hardening() const;

    void
    check_rate_laws() const;

    /// The number of values of each entry.
    std::vector<std::pair<std::string, unsigned int>>
    list_lengths() const;

    /// What the material @p id has beyond linear isotropic hardening if its law
    /// is nonlinear hardening.
    HardeningCurve
    hardening_curve(const unsigned int id) const;

    std::vector<BackStressLaw<double>>
    nonlinear_back_stresses(const unsigned int id) const;

    std::vector<BackStressLaw<double>>
    back_stresses(const unsigned int id) const;
  };
} // namespace ElastoPlastic

#endif
