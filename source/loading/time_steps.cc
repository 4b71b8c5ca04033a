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
    between(const double begin, const double end, const double fraction)
    {
      return (1 - fraction) * begin + fraction * end;
    }



    std::vector<double>
    ends_of_steps(const std::vector<double> &segment_ends,
                  const unsigned int         n_steps)
    {
      std::vector<double> ends;
      double              begin = 0;
      for (const double end : segment_ends)
        {
          const double share = (end - begin) / segment_ends.back() * n_steps;
          const double n     = std::max(1., std::ceil(share - 1e-9 * n_steps));
          for (unsigned int i = 1; i <= n; ++i)
            ends.push_back(between(begin, end, i / n));
          begin = end;
        }
      return ends;
    }
  } // namespace



  TimeSteps::TimeSteps(const std::vector<double> &segment_ends,
                       const unsigned int         n_steps,
                       const unsigned int         max_cuts)
    : ends(ends_of_steps(segment_ends, n_steps))
    , units_per_step(std::uint64_t(1) << max_cuts)
    , length(units_per_step)
  {}



  bool
  TimeSteps::finished() const
  {
    return n_uncut == ends.size();
  }



  unsigned int
  TimeSteps::number() const
  {
    return step_number;
  }



  double
  TimeSteps::time_at(const std::uint64_t units) const
  {
    if (finished())
      return ends.back();
    return between(n_uncut == 0 ? 0. : ends[n_uncut - 1],
                   ends[n_uncut],
                   static_cast<double>(units) / units_per_step);
  }



  double
  TimeSteps::time() const
  {
    return time_at(position);
  }



  double
  TimeSteps::next_time() const
  {
    return time_at(position + length);
  }



  const std::vector<double> &
  TimeSteps::uncut_ends() const
  {
    return ends;
  }



  void
  TimeSteps::advance()
  {
    ++step_number;
    position += length;
    if (length < units_per_step && position % (2 * length) == 0)
      length *= 2;
    if (position == units_per_step)
      {
        ++n_uncut;
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
