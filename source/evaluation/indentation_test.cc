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
    prm.add_parameter(
      "Young's modulus of the indenter",
      indenter_modulus,
      "With it the reduced moduli of indentation.csv become those of a real "
      "indenter, 1/E_r = (1 - nu^2)/E + (1 - nu_i^2)/E_i, as measured ones are: "
      "1141 GPa for diamond. The simulation itself has a rigid indenter, and the "
      "other columns remain those of a rigid one. 0 stands for rigid. Unit: "
      "stress, >= 0.",
      Patterns::Double());
    prm.add_parameter(
      "Poisson's ratio of the indenter",
      indenter_ratio,
      "nu_i of the entry above; the default is that of diamond. Allowed: between "
      "-1, excluded, and 0.5.",
      Patterns::Double());
    prm.add_parameter(
      "Continuous stiffness",
      continuous_stiffness,
      "Whether the stiffness with which a small unloading would begin is found "
      "at the end of each load step, from one linear system with the elastic "
      "tangent: the column contact_stiffness of history.csv and, with hardness "
      "and modulus at each depth, continuous_stiffness.csv. It changes nothing "
      "of the run. For load histories with an indenter.");
    prm.leave_subsection();
  }



  void
  EvaluationParameters::check() const
  {
    if (!(beta > 0.))
      throw InputError("Evaluation/Beta", beta, "it must be greater than 0.");
    if (!(epsilon >= 0. && epsilon <= 1.))
      throw InputError("Evaluation/Epsilon",
                       epsilon,
                       "it must lie between 0, which stands for that of the "
                       "tip's shape, and 1, that of a flat face.");
    if (!(indenter_modulus >= 0.))
      throw InputError("Evaluation/Young's modulus of the indenter",
                       indenter_modulus,
                       "it must not be negative; 0 stands for a rigid "
                       "indenter.");
    if (!(indenter_ratio > -1. && indenter_ratio <= 0.5))
      throw InputError("Evaluation/Poisson's ratio of the indenter",
                       indenter_ratio,
                       "it must lie between -1 and 0.5, -1 excluded.");
  }



  double
  UnloadingResult::reduced_modulus(const double area) const
  {
    if (!(area > 0))
      return 0.;
    const double of_rigid_indenter =
      0.5 / beta * std::sqrt(numbers::PI / (area * modelled_part)) * stiffness;
    return of_rigid_indenter / (1. + indenter_compliance * of_rigid_indenter);
  }



  IndentationTest::IndentationTest(
    const std::shared_ptr<const TipOnSurface> &tip,
    const double                               modelled_part,
    const EvaluationParameters                &constants)
    : tip(tip)
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
  // rounding.
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

    const PowerLaw          law     = fit_power_law(points);
    const IndentationPoint &maximum = memory.unloading.front();
    UnloadingResult         result =
      with_stiffness(maximum, law.stiffness(maximum.depth));
    result.law = law;
    return result;
  }



  // A flat punch touches an elastic body at the depth zero, up to the error of
  // the fit.
  UnloadingResult
  IndentationTest::with_stiffness(const IndentationPoint &maximum,
                                  const double            stiffness) const
  {
    UnloadingResult result;
    result.maximum             = maximum;
    result.stiffness           = stiffness;
    result.modelled_part       = modelled_part;
    result.beta                = constants.beta;
    result.indenter_compliance = constants.indenter_compliance();
    const double epsilon =
      constants.epsilon > 0. ? constants.epsilon : tip->depth_factor();
    result.contact_depth = result.maximum.depth - tip->initial_gap() -
                           epsilon * result.maximum.force / result.stiffness;
    const double fit_error = 1e-6 * result.maximum.depth;
    if (result.contact_depth > -fit_error)
      result.tip_area =
        modelled_part *
        tip->overlapped_area(std::max(result.contact_depth, fit_error));
    return result;
  }
} // namespace ElastoPlastic
