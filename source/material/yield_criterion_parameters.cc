// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

#include "base/exceptions.h"
#include "base/expression.h"
#include "base/text.h"
#include "material/material_lists.h"
#include "material/yield_criterion_parameters.h"

namespace ElastoPlastic
{
  namespace
  {
    const std::string ratios_path = "Material/Hill ratios";
    const std::string axes_path   = "Material/Axes";

    /// The numbers in @p text between '|'; fewer where one of the parts is
    /// none.
    std::vector<double>
    parts_of(const std::string &path, const std::string &text)
    {
      std::vector<double> numbers;
      for (const auto &part : split(path, text, '|'))
        if (const auto number = as_number(part); number && is_moderate(*number))
          numbers.push_back(*number);
        else
          return {};
      return numbers;
    }



    HillRatios
    read_ratios(const std::string &text)
    {
      const auto numbers = parts_of(ratios_path, text);
      HillRatios ratios;
      if (numbers.size() != ratios.size())
        throw InputError(ratios_path,
                         text,
                         "it must be six numbers, R_11 | R_22 | R_33 | R_12 | "
                         "R_13 | R_23, such as '1 | 1.1 | 0.9 | 1 | 1 | 1'.");
      std::copy(numbers.begin(), numbers.end(), ratios.begin());
      if (std::any_of(ratios.begin(), ratios.end(), [](const double ratio) {
            return ratio < 0.01 || ratio > 100.;
          }))
        throw InputError(ratios_path,
                         text,
                         "the ratios must be greater than 0, from 0.01 to "
                         "100.");
      if (!HillCriterion::are_convex(ratios))
        throw InputError(
          ratios_path,
          text,
          "with these ratios the yield surface would not be closed and "
          "convex: of 1 / R_11, 1 / R_22 and 1 / R_33, the largest must be "
          "smaller than the sum of the others, by 1 percent at least, so that "
          "F G + G H + H F is positive.");
      return ratios;
    }



    Tensor<2, 3>
    rotation(const unsigned int axis, const double degrees)
    {
      const double       angle = degrees * numbers::PI / 180.;
      const unsigned int i = (axis + 1) % 3, j = (axis + 2) % 3;
      Tensor<2, 3>       result;
      result[axis][axis] = 1.;
      result[i][i] = result[j][j] = std::cos(angle);
      result[j][i]                = std::sin(angle);
      result[i][j]                = -std::sin(angle);
      return result;
    }



    /// The axes as columns, of one angle or three.
    Tensor<2, 3>
    turned_by(const std::vector<double> &angles)
    {
      if (angles.size() == 1)
        return rotation(2, angles[0]);
      return rotation(2, angles[0]) * rotation(0, angles[1]) *
             rotation(2, angles[2]);
    }



    Tensor<2, 3>
    read_axes(const std::string &text)
    {
      const auto angles = parts_of(axes_path, text);
      if (angles.size() != 1 && angles.size() != 3)
        throw InputError(axes_path,
                         text,
                         "it must be one angle, about the third axis, or "
                         "Bunge's three Euler angles, such as '30 | 90 | 0'. "
                         "Unit: degrees.");
      return turned_by(angles);
    }



    /// Whether an angle is an expression instead of a number.
    bool
    vary(const std::string &text)
    {
      const auto parts = split(axes_path, text, '|');
      return !std::all_of(parts.begin(),
                          parts.end(),
                          [](const std::string &part) {
                            return as_number(part).has_value();
                          });
    }



    template <int dim>
    std::vector<std::shared_ptr<const Expression<dim>>>
    read_expressions(const std::string &text)
    {
      std::vector<std::shared_ptr<const Expression<dim>>> expressions;
      for (const std::string &part : split(axes_path, text, '|'))
        expressions.push_back(std::make_shared<const Expression<dim>>(
          axes_path, part, ExpressionVariables::position));
      return expressions;
    }
  } // namespace



  void
  YieldCriterionParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter(
      "Yield criterion",
      criteria,
      "What is compared with the yield stress. 'von Mises': the equivalent "
      "stress of that name. 'Hosford': ((|s_1 - s_2|^a + |s_2 - s_3|^a + |s_3 "
      "- s_1|^a) / 2)^(1/a) with the principal stresses s_i. 'Hill': that of "
      "1948 for orthotropic materials. These two are for small strains in "
      "plane strain, revolution and space, with all laws but back stresses "
      "that recover; 'Hill' is for limit loads, too, also in plane stress, "
      "and for error bounds without back stresses. "
      "'Mohr-Coulomb', a soil: bears the "
      "stresses with which the shear stress on each plane is not more than "
      "'Cohesion' plus tan('Friction angle') times the pressure on it, "
      "whatever the yield stress; flow along the normal of this condition "
      "dilates it. That is for limit loads in plane strain, with 'Law = "
      "perfectly plastic'. 'Drucker-Prager': a cone for bodies of revolution "
      "and in space, sqrt(J_2) + alpha I_1 <= k with the second invariant J_2 "
      "of the deviator and the sum I_1 of the principal stresses. Of the cones with "
      "this name it is the first, that of Drucker and Prager (1952), which "
      "bears in plane strain what 'Mohr-Coulomb' does: alpha = tan(phi) / "
      "sqrt(9 + 12 tan^2(phi)), k = 3 c / sqrt(9 + 12 tan^2(phi)).",
      Patterns::List(*Patterns::Tools::Convert<YieldCriterion>::to_pattern(),
                     1));
    prm.add_parameter("Hosford exponent",
                      hosford_exponents,
                      "a of 'Hosford', from 2 to 100. 2 and 4 are von Mises, "
                      "8 (aluminium) and 6 (iron) are customary, large ones "
                      "tend to Tresca. No unit.",
                      Patterns::List(Patterns::Double(), 1));
    prm.add_parameter(
      "Hill ratios",
      hill_ratios,
      "R_11 | R_22 | R_33 | R_12 | R_13 | R_23 of 'Hill': the yield stress in "
      "tension along an axis of the material, or sqrt(3) times that in shear "
      "between two of them, over that of the entry 'Yield stress'. No unit.",
      Patterns::List(Patterns::Anything(), 1));
    prm.add_parameter(
      "Axes",
      axes,
      "How the axes 1, 2, 3 of the material lie, of 'Hill'. One angle: they "
      "are those of the body, turned about the third by so much, from the "
      "first to the second. Three: Bunge's Euler angles phi_1 | Phi | phi_2, "
      "turns about the third, the new first and the new third axis. In two "
      "dimensions the third axis of the body is out of plane, of a body of "
      "revolution circumferential. An angle may be an expression of the "
      "position without commas, such as '180/pi*atan(y/x)' for axes along and "
      "around a ring; not for bounds of limit loads and errors. Unit: degrees.",
      Patterns::List(Patterns::Anything(), 1));
    soil.add_parameters(prm);
  }



  void
  YieldCriterionParameters::check(
    const std::vector<Material<double>> &materials) const
  {
    require(
      "Hosford exponent",
      hosford_exponents,
      [](const double a) { return a >= 2 && a <= 100; },
      "it must lie between 2 (von Mises) and 100 (almost Tresca).");
    soil.check();
    for (const std::string &text : hill_ratios)
      read_ratios(text);
    for (const std::string &text : axes)
      if (vary(text))
        read_expressions<3>(text);
      else
        read_axes(text);
    if (are_general() &&
        std::any_of(materials.begin(), materials.end(), has_recovery))
      throw InputError("Material/Yield criterion",
                       criteria,
                       "with other criteria than that of von Mises back "
                       "stresses cannot recover. Set 'Recovery rates' to 0, "
                       "or choose 'von Mises' for all materials.");
  }



  std::vector<std::pair<std::string, unsigned int>>
  YieldCriterionParameters::list_lengths() const
  {
    std::vector<std::pair<std::string, unsigned int>> result =
      soil.list_lengths();
    result.insert(result.end(),
                  {{"Yield criterion", criteria.size()},
                   {"Hosford exponent", hosford_exponents.size()},
                   {"Hill ratios", hill_ratios.size()},
                   {"Axes", axes.size()}});
    return result;
  }



  bool
  YieldCriterionParameters::is_soil(const unsigned int id) const
  {
    const YieldCriterion criterion = of_material(criteria, id);
    return criterion == YieldCriterion::mohr_coulomb ||
           criterion == YieldCriterion::drucker_prager;
  }



  SoilStrength
  YieldCriterionParameters::soil_strength(const unsigned int id) const
  {
    return of_material(criteria, id) == YieldCriterion::mohr_coulomb ?
             soil.mohr_coulomb(id) :
             soil.drucker_prager(id);
  }



  std::vector<double>
  YieldCriterionParameters::friction_slopes(
    const unsigned int n_materials) const
  {
    std::vector<double> result;
    for (unsigned int id = 0; id < n_materials; ++id)
      result.push_back(is_soil(id) ? soil_strength(id).slope : 0.);
    return result;
  }



  bool
  YieldCriterionParameters::are_general() const
  {
    return std::any_of(criteria.begin(),
                       criteria.end(),
                       [](const YieldCriterion criterion) {
                         return criterion == YieldCriterion::hosford ||
                                criterion == YieldCriterion::hill;
                       });
  }



  std::shared_ptr<const GeneralCriterion>
  YieldCriterionParameters::criterion(const unsigned int id) const
  {
    if (!are_general())
      return nullptr;
    switch (of_material(criteria, id))
      {
        case YieldCriterion::von_mises:
          return std::make_shared<GeneralCriterion>(
            HillCriterion({{1., 1., 1., 1., 1., 1.}}, rotation(2, 0.)));
        case YieldCriterion::hosford:
          return std::make_shared<GeneralCriterion>(
            HosfordCriterion(of_material(hosford_exponents, id)));
        case YieldCriterion::hill:
          return std::make_shared<GeneralCriterion>(
            HillCriterion(read_ratios(of_material(hill_ratios, id)),
                          has_varying_axes(id) ?
                            rotation(2, 0.) :
                            read_axes(of_material(axes, id))));
        case YieldCriterion::mohr_coulomb:
        case YieldCriterion::drucker_prager:
          return nullptr;
      }
    AssertThrow(false, ExcInternalError());
    return nullptr;
  }



  bool
  YieldCriterionParameters::has_varying_axes(const unsigned int id) const
  {
    return of_material(criteria, id) == YieldCriterion::hill &&
           vary(of_material(axes, id));
  }



  template <int dim>
  std::function<GeneralCriterion(const Point<3> &)>
  YieldCriterionParameters::criterion_along_axes(const unsigned int id) const
  {
    const std::string text   = of_material(axes, id);
    const auto        angles = read_expressions<dim>(text);
    if (angles.size() != 1 && !(angles.size() == 3 && dim == 3))
      throw InputError(axes_path,
                       text,
                       "angles that are expressions of the position must be "
                       "one, about the third axis, or in space three, such as "
                       "'30*x | 0 | 0'.");
    const HillRatios ratios = read_ratios(of_material(hill_ratios, id));
    return [ratios, angles](const Point<3> &point) {
      Point<dim> place;
      for (unsigned int d = 0; d < dim; ++d)
        place[d] = point[d];
      std::vector<double> degrees;
      for (const auto &angle : angles)
        degrees.push_back(angle->value(place));
      return HillCriterion(ratios, turned_by(degrees));
    };
  }



  void
  YieldCriterionParameters::check_third_axis() const
  {
    const auto lengths = list_lengths();
    const auto longest = std::max_element(lengths.begin(),
                                          lengths.end(),
                                          [](const auto &a, const auto &b) {
                                            return a.second < b.second;
                                          });
    for (unsigned int id = 0; id < longest->second; ++id)
      if (of_material(criteria, id) == YieldCriterion::hill &&
          !has_varying_axes(id) &&
          !HillCriterion(read_ratios(of_material(hill_ratios, id)),
                         read_axes(of_material(axes, id)))
             .has_third_axis())
        throw InputError(axes_path,
                         of_material(axes, id),
                         "in two dimensions one of the axes of the material "
                         "must be the third of the body. Give one angle, or "
                         "set 'Dimension = 3'.");
  }



  template std::function<GeneralCriterion(const Point<3> &)>
  YieldCriterionParameters::criterion_along_axes<2>(const unsigned int) const;
  template std::function<GeneralCriterion(const Point<3> &)>
  YieldCriterionParameters::criterion_along_axes<3>(const unsigned int) const;
} // namespace ElastoPlastic
