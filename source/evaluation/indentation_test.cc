// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <cmath>

#include "evaluation/indentation_test.h"

namespace ElastoPlastic
{
  using namespace dealii;

  double
  UnloadingResult::hardness(const double area) const
  {
    return area > 0 ? maximum.force / area : 0.;
  }



  double
  UnloadingResult::reduced_modulus(const double area) const
  {
    return area > 0 ?
             0.5 * std::sqrt(numbers::PI / (area * modelled_part)) * stiffness :
             0.;
  }



  IndentationTest::IndentationTest(const std::shared_ptr<const TipShape> &tip,
                                   const double initial_gap,
                                   const double modelled_part)
    : tip(tip)
    , initial_gap(initial_gap)
    , modelled_part(modelled_part)
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
    result.contact_depth =
      result.maximum.depth - initial_gap -
      tip->depth_factor() * result.maximum.force / result.stiffness;
    const double fit_error = 1e-6 * result.maximum.depth;
    if (result.contact_depth > -fit_error)
      result.tip_area =
        modelled_part *
        tip->section_area(std::max(result.contact_depth, fit_error));
    return result;
  }
} // namespace ElastoPlastic
