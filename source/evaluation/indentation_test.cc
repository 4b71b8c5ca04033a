// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <cmath>

#include "base/exceptions.h"
#include "evaluation/indentation_test.h"

namespace ElastoPlastic
{
  void
  EvaluationParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Evaluation");
    prm.add_parameter(
      "Beta",
      beta,
      "The factor beta in the stiffness 2 beta E_r sqrt(A / pi) at the "
      "beginning of an unloading, by which indentation.csv finds the reduced "
      "modulus E_r. 1 is exact for the small contact of a smooth axisymmetric "
      "tip; laboratories use 1.034 to 1.05 for Berkovich's pyramid. To compare "
      "with a measured modulus, take that of the measurement. Allowed: > 0.",
      Patterns::Double());
    prm.add_parameter(
      "Epsilon",
      epsilon,
      "The factor epsilon in the contact depth h_max - epsilon F_max / S of "
      "Oliver and Pharr; laboratories mostly use 0.75. 0 stands for that of "
      "the tip's shape: 1 for a flat face, 2 - 4/pi for a cone, 0.75 for all "
      "others. Allowed: from 0 to 1.",
      Patterns::Double());
    prm.leave_subsection();
  }



  void
  EvaluationParameters::check() const
  {
    if (!(beta > 0.))
      throw InputError("Evaluation/Beta",
                       Patterns::Tools::to_string(beta),
                       "it must be greater than 0.");
    if (!(epsilon >= 0. && epsilon <= 1.))
      throw InputError("Evaluation/Epsilon",
                       Patterns::Tools::to_string(epsilon),
                       "it must lie between 0, which stands for that of the "
                       "tip's shape, and 1, that of a flat face.");
  }



  double
  UnloadingResult::hardness(const double area) const
  {
    return area > 0 ? maximum.force / area : 0.;
  }



  double
  UnloadingResult::reduced_modulus(const double area) const
  {
    return area > 0 ?
             0.5 / beta * std::sqrt(numbers::PI / (area * modelled_part)) *
               stiffness :
             0.;
  }



  IndentationTest::IndentationTest(const std::shared_ptr<const TipShape> &tip,
                                   const double                initial_gap,
                                   const double                modelled_part,
                                   const EvaluationParameters &constants)
    : tip(tip)
    , initial_gap(initial_gap)
    , modelled_part(modelled_part)
    , constants(constants)
  {}



  std::optional<UnloadingResult>
  IndentationTest::add(const IndentationPoint &point)
  {
    IndentationPoint next = point;
    next.depth += memory.depth_shift;
    next.force *= memory.force_scale;
    if (!memory.unloading.empty() &&
        next.force < memory.unloading.back().force &&
        next.depth < memory.unloading.back().depth)
      {
        memory.unloading.push_back(next);
        if (next.force < lowest_share * memory.unloading.front().force)
          return finish();
        return {};
      }
    const auto result = finish();
    memory            = Progress();
    memory.unloading  = {point};
    return result;
  }



  // Without force there is nothing that could be scaled, nor unloaded.
  void
  IndentationTest::change_mesh(const IndentationPoint &before,
                               const IndentationPoint &after)
  {
    memory.depth_shift += before.depth - after.depth;
    if (before.force > 0 && after.force > 0)
      memory.force_scale *= before.force / after.force;
  }



  std::optional<UnloadingResult>
  IndentationTest::finish()
  {
    if (memory.evaluated)
      return {};
    memory.evaluated = true;
    return evaluate();
  }



  // Forces that are prescribed in equal steps hit the ends of the range, up to
  // rounding; and a flat punch touches an elastic body at the depth zero, up to
  // the error of the fit.
  std::optional<UnloadingResult>
  IndentationTest::evaluate()
  {
    const double                           rounding = 1e-9;
    std::vector<std::pair<double, double>> points;
    for (const IndentationPoint &point : memory.unloading)
      {
        const double share = point.force / memory.unloading.front().force;
        if (share >= lowest_share - rounding &&
            share <= highest_share + rounding)
          points.emplace_back(point.depth, point.force);
      }
    if (points.size() < 3)
      return {};

    UnloadingResult result;
    result.maximum       = memory.unloading.front();
    result.law           = fit_power_law(points);
    result.stiffness     = result.law.stiffness(result.maximum.depth);
    result.modelled_part = modelled_part;
    result.beta          = constants.beta;
    const double epsilon =
      constants.epsilon > 0. ? constants.epsilon : tip->depth_factor();
    result.contact_depth = result.maximum.depth - initial_gap -
                           epsilon * result.maximum.force / result.stiffness;
    const double fit_error = 1e-6 * result.maximum.depth;
    if (result.contact_depth > -fit_error)
      result.tip_area =
        modelled_part *
        tip->section_area(std::max(result.contact_depth, fit_error));
    return result;
  }
} // namespace ElastoPlastic
