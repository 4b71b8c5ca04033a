// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <limits>

#include "evaluation/rate_test.h"

namespace ElastoPlastic
{
  namespace
  {
    constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

    /// A depth that grows by a smaller part of itself is held, up to rounding.
    constexpr double smallest_growth = 1e-12;



    /// That of the line of least squares through ln H over ln r of the steps
    /// after @p begin; not a number if they are fewer than three.
    double
    slope(const std::vector<RateTest::Step> &steps, const double begin)
    {
      double n = 0, x = 0, y = 0, xx = 0, xy = 0;
      for (const RateTest::Step &step : steps)
        if (step.time > begin)
          {
            const double log_rate     = std::log(step.rate);
            const double log_hardness = std::log(step.hardness);
            n += 1.;
            x += log_rate;
            y += log_hardness;
            xx += log_rate * log_rate;
            xy += log_rate * log_hardness;
          }
      return n < 3. ? not_a_number : (n * xy - x * y) / (n * xx - x * x);
    }
  } // namespace



  UnloadingResult
  RateSensitivity::row(const double modelled_part) const
  {
    UnloadingResult result;
    result.maximum               = end;
    result.modelled_part         = modelled_part;
    result.stiffness             = not_a_number;
    result.law.exponent          = not_a_number;
    result.law.final_depth       = not_a_number;
    result.contact_depth         = not_a_number;
    result.creep_depth           = creep_depth;
    result.hold_rate_sensitivity = of_hold;
    result.jump_rate_sensitivity = of_jump;
    return result;
  }



  std::optional<RateSensitivity>
  RateTest::add(const IndentationPoint &point)
  {
    const IndentationPoint last = std::exchange(memory.last, point);
    if (point.contact_area > 0. && last.depth > 0. &&
        point.depth > (1. + smallest_growth) * last.depth)
      memory.steps.push_back(
        {point.time,
         std::log(point.depth / last.depth) / (point.time - last.time),
         point.force / point.contact_area});
    if (!std::binary_search(segment_ends.begin(),
                            segment_ends.end(),
                            point.time))
      return {};

    const Progress segment = std::exchange(memory, {});
    memory.last = memory.begin = point;
    if (segment.steps.empty() || segment.steps.back().time != point.time)
      return {};
    RateSensitivity result = {point, not_a_number, not_a_number, not_a_number};
    if (const auto begin = begin_of_hold(point.time))
      {
        result.creep_depth = point.depth - segment.begin.depth;
        result.of_hold =
          slope(segment.steps, *begin + first_part * (point.time - *begin));
        return result;
      }
    memory.before = segment.steps.back();
    if (segment.before.rate == 0.)
      return {};
    const double jump = std::log(memory.before.rate / segment.before.rate);
    if (std::abs(jump) < std::log(least_jump))
      return {};
    result.of_jump =
      std::log(memory.before.hardness / segment.before.hardness) / jump;
    return result;
  }



  void
  RateTest::change_mesh(const IndentationPoint &before,
                        const IndentationPoint &after)
  {
    memory.last = after;
    memory.begin.depth += after.depth - before.depth;
  }



  std::optional<double>
  RateTest::begin_of_hold(const double time) const
  {
    for (const auto &[begin, end] : holds)
      if (end == time)
        return begin;
    return {};
  }
} // namespace ElastoPlastic
