// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "base/exceptions.h"
#include "base/text.h"
#include "loading/load_program.h"

namespace ElastoPlastic
{
  namespace
  {
    void
    check_force(const std::string &path,
                const std::string &text,
                const double       force)
    {
      if (force < 0)
        throw InputError(path,
                         text,
                         "a force cannot be negative: the indenter presses, it "
                         "does not pull.");
    }



    /// What is not more than rounding leaves of zero, where a depth or a force
    /// is as large as this @p load at the ends of equal steps.
    double
    rounding_of(const Expression<1> &load, const LoadingParameters &parameters)
    {
      constexpr double rounding = 1e-14;

      double largest = 0;
      for (unsigned int i = 1; i <= parameters.n_steps; ++i)
        {
          const double time = parameters.final_time * i / parameters.n_steps;
          largest = std::max(largest, std::abs(load.value(Point<1>(time))));
        }
      return rounding * largest;
    }



    /// Separated by blanks; the first colon is one of them.
    std::vector<std::string>
    words_of(std::string row)
    {
      const auto colon = row.find(':');
      if (colon != std::string::npos)
        row.replace(colon, 1, " : ");
      std::istringstream       stream(row);
      std::vector<std::string> words;
      for (std::string word; stream >> word;)
        words.push_back(word);
      return words;
    }
  } // namespace



  LoadProgram::LoadProgram(const LoadingParameters &parameters)
    : indenter_path(parameters.path)
  {
    if (!parameters.history.empty())
      {
        read_history(parameters.history);
        return;
      }
    if (!(parameters.final_time > 0 && std::isfinite(parameters.final_time)))
      throw InputError("Loading/Final time",
                       Patterns::Tools::to_string(parameters.final_time),
                       "it must be a number greater than 0.");
    read_expression(parameters);
  }



  void
  LoadProgram::read_history(const std::string &table)
  {
    static const std::string path = "Loading/History";
    for (const std::string &row : split(path, table, '|'))
      {
        const std::vector<std::string> words = words_of(row);
        std::optional<double>          time, value;
        Control                        control = Control::depth;
        if (words.size() == 4 && words[1] == ":" &&
            (words[2] == "depth" || words[2] == "force"))
          {
            time    = as_number(words[0]);
            value   = as_number(words[3]);
            control = words[2] == "depth" ? Control::depth : Control::force;
          }
        else if (words.size() == 3 && words[1] == ":" && words[2] == "hold" &&
                 !segments.empty())
          {
            time    = as_number(words[0]);
            value   = segments.back().end_value;
            control = segments.back().control;
          }
        if (!time || !value)
          throw InputError(
            path,
            row,
            "a row must look like '1.5: depth 0.02', '2: force "
            "0' or, but for the first, '3: hold': a time, then "
            "what is reached at that time. Rows are separated by "
            "'|'.");
        if (!std::isfinite(*time) || !std::isfinite(*value))
          throw InputError(path, row, "its numbers must be finite.");
        const double last_time = segments.empty() ? 0. : final_time();
        if (*time <= last_time)
          throw InputError(path,
                           row,
                           "the times must increase, and the first must be "
                           "greater than 0.");
        if (control == Control::force)
          check_force(path, row, *value);
        std::optional<double> begin;
        if (segments.empty())
          begin = 0.;
        else if (segments.back().control == control)
          begin = segments.back().end_value;
        segments.push_back({*time, control, *value, begin});
      }
  }



  void
  LoadProgram::read_expression(const LoadingParameters &parameters)
  {
    const Control     control  = parameters.control;
    const bool        by_depth = (control == Control::depth);
    const std::string path     = by_depth ? "Loading/Depth" : "Loading/Force";
    const std::string text     = by_depth ? parameters.depth : parameters.force;

    const auto number = as_number(text);
    if (!number)
      {
        const auto expression =
          std::make_shared<const Expression<1>>(path, text);
        segments.push_back({parameters.final_time,
                            control,
                            0.,
                            0.,
                            expression,
                            rounding_of(*expression, parameters)});
        return;
      }
    if (!std::isfinite(*number))
      throw InputError(path, text, "it must be finite.");
    if (by_depth && *number <= 0)
      throw InputError(path,
                       text,
                       "it must be greater than 0. For a body that is loaded "
                       "by its boundary conditions alone set 'Indenter/Type = "
                       "none'.");
    if (!by_depth)
      check_force(path, text, *number);
    segments.push_back({parameters.final_time, control, *number});
  }



  double
  LoadProgram::final_time() const
  {
    return segments.back().end_time;
  }



  std::vector<double>
  LoadProgram::segment_ends() const
  {
    std::set<double> ends;
    for (const Segment &segment : segments)
      ends.insert(segment.end_time);
    for (const double time : indenter_path.corners())
      if (time < final_time())
        ends.insert(time);
    return {ends.begin(), ends.end()};
  }



  bool
  LoadProgram::is_segment_end(const double time) const
  {
    const std::vector<double> ends = segment_ends();
    return std::binary_search(ends.begin(), ends.end(), time);
  }



  bool
  LoadProgram::is_piecewise_linear() const
  {
    return std::none_of(segments.begin(),
                        segments.end(),
                        [](const Segment &segment) {
                          return segment.expression != nullptr;
                        }) &&
           (indenter_path.is_at_rest() || !indenter_path.corners().empty());
  }



  std::vector<std::pair<double, double>>
  LoadProgram::holds() const
  {
    std::vector<std::pair<double, double>> result;
    double                                 begin_time = 0;
    for (const Segment &segment : segments)
      {
        if (!segment.expression && segment.begin_value == segment.end_value)
          result.emplace_back(begin_time, segment.end_time);
        begin_time = segment.end_time;
      }
    return result;
  }



  std::optional<Load>
  LoadProgram::load(const double time) const
  {
    double begin_time = 0;
    auto   segment    = segments.begin();
    for (; segment + 1 != segments.end() && time > segment->end_time; ++segment)
      begin_time = segment->end_time;

    if (segment->expression)
      {
        const double value = segment->expression->value(Point<1>(time));
        if (std::abs(value) <= segment->rounding)
          return Load{segment->control, 0.};
        if (segment->control == Control::force)
          check_force("Loading/Force",
                      "at t = " + Patterns::Tools::to_string(time) + ": " +
                        Patterns::Tools::to_string(value),
                      value);
        return Load{segment->control, value};
      }
    if (time == segment->end_time)
      return Load{segment->control, segment->end_value};

    std::optional<double> begin_value = segment->begin_value;
    if (!begin_value)
      {
        const auto reached = turning_points.find(begin_time);
        if (reached == turning_points.end())
          return {};
        begin_value = segment->control == Control::depth ?
                        reached->second.first :
                        reached->second.second;
      }
    const double fraction =
      (time - begin_time) / (segment->end_time - begin_time);
    return Load{segment->control,
                (1 - fraction) * *begin_value + fraction * segment->end_value};
  }



  void
  LoadProgram::reached(const double time,
                       const double depth,
                       const double force)
  {
    if (is_segment_end(time))
      turning_points[time] = {depth, force};
  }
} // namespace ElastoPlastic
