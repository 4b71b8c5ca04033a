// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include "loading/time_steps.h"

namespace ElastoPlastic
{
  namespace
  {
    double
    segment_begin(const std::vector<double> &ends, const unsigned int segment)
    {
      return segment == 0 ? 0. : ends[segment - 1];
    }



    std::uint64_t
    n_steps_in(const std::vector<double> &ends,
               const unsigned int         segment,
               const unsigned int         n_steps)
    {
      const double share =
        (ends[segment] - segment_begin(ends, segment)) / ends.back() * n_steps;
      return std::max(1., std::ceil(share - 1e-9 * n_steps));
    }
  } // namespace



  TimeSteps::TimeSteps(const std::vector<double> &segment_ends,
                       const unsigned int         n_steps,
                       const unsigned int         max_cuts)
    : segment_ends(segment_ends)
    , n_steps(n_steps)
    , units_per_step(std::uint64_t(1) << max_cuts)
    , length(units_per_step)
  {}



  bool
  TimeSteps::finished() const
  {
    return segment == segment_ends.size();
  }



  unsigned int
  TimeSteps::number() const
  {
    return step_number;
  }



  double
  TimeSteps::time_at(const std::uint64_t units) const
  {
    const std::uint64_t all =
      n_steps_in(segment_ends, segment, n_steps) * units_per_step;
    const double fraction = static_cast<double>(units) / all;
    return (1 - fraction) * segment_begin(segment_ends, segment) +
           fraction * segment_ends[segment];
  }



  double
  TimeSteps::time() const
  {
    return finished() ? segment_ends.back() : time_at(position);
  }



  double
  TimeSteps::next_time() const
  {
    return time_at(position + length);
  }



  void
  TimeSteps::advance()
  {
    ++step_number;
    position += length;
    if (length < units_per_step && position % (2 * length) == 0)
      length *= 2;
    if (position == n_steps_in(segment_ends, segment, n_steps) * units_per_step)
      {
        ++segment;
        position = 0;
      }
  }



  bool
  TimeSteps::cut()
  {
    if (length == 1)
      return false;
    length /= 2;
    return true;
  }
} // namespace ElastoPlastic
