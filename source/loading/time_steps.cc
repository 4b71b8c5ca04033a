// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <set>

#include "loading/time_steps.h"

namespace ElastoPlastic
{
  namespace
  {
    constexpr double negligible = 1e-9;



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
    , control(StepControl::fixed)
    , shortest(std::ldexp(1., -static_cast<int>(max_cuts)))
  {
    for (const double time : segment_ends)
      segments.push_back(position_at(time));
    for (const double time : ends)
      stops.push_back(position_at(time));
  }



  TimeSteps::TimeSteps(const std::vector<double> &segment_ends,
                       const unsigned int         n_steps,
                       const unsigned int         max_cuts,
                       const StepControl          step_control,
                       const std::vector<double> &more_stops)
    : TimeSteps(segment_ends, n_steps, max_cuts)
  {
    control = step_control;
    std::set<double> all(segments.begin(), segments.end());
    for (const double time : more_stops)
      if (time > 0 && time < ends.back())
        all.insert(position_at(time));
    stops.assign(all.begin(), all.end());
  }



  double
  TimeSteps::time_at(const double a_position) const
  {
    const auto n_behind = static_cast<std::size_t>(a_position);
    if (n_behind == ends.size())
      return ends.back();
    return between(n_behind == 0 ? 0. : ends[n_behind - 1],
                   ends[n_behind],
                   a_position - n_behind);
  }



  // (What is as good as the end of a nominal step is taken for it.)
  double
  TimeSteps::position_at(const double time) const
  {
    const auto   next  = std::lower_bound(ends.begin(), ends.end(), time);
    const double begin = next == ends.begin() ? 0. : *(next - 1);
    const double part  = (time - begin) / (*next - begin);
    return (next - ends.begin()) + (part < negligible     ? 0. :
                                    part > 1 - negligible ? 1. :
                                                            part);
  }



  void
  TimeSteps::end_step_at(const double time)
  {
    const double stop = position_at(time);
    const auto   next =
      stops.erase(std::upper_bound(stops.begin(), stops.end(), position),
                  std::lower_bound(stops.begin(), stops.end(), stop));
    if (next == stops.end() || *next != stop)
      stops.insert(next, stop);
  }



  double
  TimeSteps::end() const
  {
    if (finished())
      return position;
    const double stop = *std::upper_bound(stops.begin(), stops.end(), position);
    const double n    = std::ceil((stop - position) / length - negligible);
    return n > 1 ? position + (stop - position) / n : stop;
  }



  bool
  TimeSteps::is_longer_than_nominal() const
  {
    return end() - position > 1 + negligible;
  }



  void
  TimeSteps::advance(const unsigned int n_iterations, const double error)
  {
    const double begin = position;
    position           = end();
    ++step_number;
    if (control == StepControl::adaptive)
      adapt(position - begin,
            std::sqrt(target_iterations / std::max(1., 1. * n_iterations)));
    else if (control == StepControl::accurate)
      adapt(position - begin, 1. / std::sqrt(std::max(error, 1e-10)));
    else if (length < 1 && (std::fmod(position, 2 * length) == 0 ||
                            position == std::floor(position)))
      length = std::min(1., 2 * length);
  }



  // A step that had to meet a stop says nothing against longer ones.
  void
  TimeSteps::adapt(const double taken, const double wanted)
  {
    if (std::binary_search(segments.begin(), segments.end(), position))
      {
        length = 1;
        return;
      }
    const double growth = std::clamp(wanted, 0.5, 2.);
    length =
      growth < 1 ?
        std::max(growth * taken, shortest) :
        std::min(std::max(length, growth * taken),
                 control == StepControl::accurate ? longest_accurate : longest);
  }



  bool
  TimeSteps::cut()
  {
    const double failed = end() - position;
    if (failed <= (1 + negligible) * shortest)
      return false;
    length = std::max(0.5 * failed, shortest);
    return true;
  }
} // namespace ElastoPlastic
