// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef material_yield_criterion_parameters_h
#define material_yield_criterion_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/enum_names.h"
#include "material/material.h"

namespace ElastoPlastic
{
  using namespace dealii;



  /// The values of the entry "Yield criterion": which stresses a material bears
  /// without plastic flow.
  enum class YieldCriterion
  {
    von_mises,
    hosford,
    hill,
    mohr_coulomb,
    drucker_prager
  };

  template <>
  inline const EnumNames<YieldCriterion> enum_names<YieldCriterion> = {
    {"von Mises", YieldCriterion::von_mises},
    {"Hosford", YieldCriterion::hosford},
    {"Hill", YieldCriterion::hill},
    {"Mohr-Coulomb", YieldCriterion::mohr_coulomb},
    {"Drucker-Prager", YieldCriterion::drucker_prager}};



  /// How the strength of a soil grows with the pressure: by |dev s| <= R -
  /// sqrt(2) f m, with the mean stress m, tension being positive.
  struct SoilStrength
  {
    double yield_radius; ///< R, unit: stress
    double slope;        ///< f, less than 1
  };



  /// The entries of the section "Material" about strength that grows with the
  /// pressure: lists like the others of MaterialParameters. On no plane, the
  /// shear stress of Mohr and Coulomb's soil exceeds c + p tan(phi), with the
  /// pressure p on the plane.
  struct SoilParameters
  {
    std::vector<double> cohesions       = {100.}; ///< c, unit: stress
    std::vector<double> friction_angles = {30.};  ///< phi, in degrees

    /// In the section, which has been entered.
    void
    add_parameters(ParameterHandler &prm);

    /// @throws InputError for a value out of range.
    void
    check() const;

    /// The number of values of each entry.
    std::vector<std::pair<std::string, unsigned int>>
    list_lengths() const
    {
      return {{"Cohesion", cohesions.size()},
              {"Friction angle", friction_angles.size()}};
    }

    /// Of the material @p id in plane strain, s_33 being the mean of s_11 and
    /// s_22: R = sqrt(2) c cos(phi), f = sin(phi).
    SoilStrength
    mohr_coulomb(const unsigned int id) const;

    /// Of the cone that Drucker and Prager have chosen @cite
    /// drucker_prager_1952: it bears as much as Mohr and Coulomb's soil where a
    /// body flows in plane strain. Its R and f are those of mohr_coulomb() over
    /// sqrt(1 + sin^2(phi) / 3); they write alpha = f / 3 and k = R / sqrt(2).
    SoilStrength
    drucker_prager(const unsigned int id) const;
  };



  /// The entries of the section "Material" that have to do with the
  /// YieldCriterion: lists as in MaterialParameters.
  struct YieldCriterionParameters
  {
    std::vector<YieldCriterion> criteria          = {YieldCriterion::von_mises};
    std::vector<double>         hosford_exponents = {8.};
    std::vector<std::string>    hill_ratios       = {"1 | 1 | 1 | 1 | 1 | 1"};
    std::vector<std::string>    axes              = {"0"};
    SoilParameters              soil;

    /// Adds the entries to the section that has been entered.
    void
    add_parameters(ParameterHandler &prm);

    /// @throws InputError for a value out of range, and if one of the
    /// @p materials has back stresses that recover beside a general criterion,
    /// which would make tangents unsymmetric.
    void
    check(const std::vector<Material<double>> &materials) const;

    /// The number of values of each entry.
    std::vector<std::pair<std::string, unsigned int>>
    list_lengths() const;

    /// Whether any material has this criterion.
    bool
    has(const YieldCriterion criterion) const
    {
      return std::find(criteria.begin(), criteria.end(), criterion) !=
             criteria.end();
    }

    /// Whether the criterion of a material is that of Mohr and Coulomb, or of
    /// Drucker and Prager.
    bool
    is_soil(const unsigned int id) const;

    /// Whether that of any is.
    bool
    has_soil() const
    {
      return has(YieldCriterion::mohr_coulomb) ||
             has(YieldCriterion::drucker_prager);
    }

    /// Of a material whose criterion is one of these.
    SoilStrength
    soil_strength(const unsigned int id) const;

    /// By material id, of the first @p n_materials: that of SoilStrength, or 0.
    std::vector<double>
    friction_slopes(const unsigned int n_materials) const;

    /// Whether a material has the criterion of Hosford or of Hill.
    bool
    are_general() const;

    /// That of the material @p id. Where others have a general one, that of von
    /// Mises is one of Hill; where none has, none. Soil has none: beside it,
    /// there are no general ones.
    std::shared_ptr<const GeneralCriterion>
    criterion(const unsigned int id) const;

    /// Whether a material obeys Hill's criterion with axes that depend on the
    /// position. Then criterion() has those of the body.
    bool
    has_varying_axes(const unsigned int id) const;

    /// The criterion of such a material, see Material::criterion_at.
    /// @throws InputError for what is no expression.
    template <int dim>
    std::function<GeneralCriterion(const Point<3> &)>
    criterion_along_axes(const unsigned int id) const;

    /// @throws InputError if the third axis of the body is none of a material
    /// that obeys Hill's criterion: then two dimensions are not enough.
    void
    check_third_axis() const;
  };
} // namespace ElastoPlastic

#endif
