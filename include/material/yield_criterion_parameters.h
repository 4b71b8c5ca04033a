// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef material_yield_criterion_parameters_h
#define material_yield_criterion_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "material/material.h"
#include "material/soil_parameters.h"
#include "material/yield_criterion.h"

namespace ElastoPlastic
{
  using namespace dealii;

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
    has(const YieldCriterion criterion) const;

    /// Whether the criterion of a material is that of Mohr and Coulomb, or of
    /// Drucker and Prager.
    bool
    is_soil(const unsigned int id) const;

    /// Whether that of any is.
    bool
    has_soil() const;

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

    /// @throws InputError if the third axis of the body is none of a material
    /// that obeys Hill's criterion: then two dimensions are not enough.
    void
    check_third_axis() const;
  };
} // namespace ElastoPlastic

#endif
