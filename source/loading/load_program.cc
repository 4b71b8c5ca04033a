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
    const std::string path_of_table = "Loading/History";



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



    void
    check_growing_depth(const std::string &row, const double begin)
    {
      if (!(begin > 0))
        throw InputError(path_of_table,
                         row,
                         "a strain rate is a part of the depth per time, and "
                         "the depth there is " +
                           Patterns::Tools::to_string(begin) +
                           ". Push the indenter in before, as by '1: depth "
                           "0.001'.");
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
                       parameters.final_time,
                       "it must be a number greater than 0.");
    read_expression(parameters);
  }



  LoadProgram::Segment
  LoadProgram::read_row(const std::string &row) const
  {
    static const std::map<std::string, std::pair<Control, Ramp>> kinds = {
      {"depth", {Control::depth, Ramp::to_value}},
      {"force", {Control::force, Ramp::to_value}},
      {"depth rate", {Control::depth, Ramp::at_rate}},
      {"force rate", {Control::force, Ramp::at_rate}},
      {"strain rate", {Control::depth, Ramp::at_strain_rate}}};

    const std::vector<std::string> words  = words_of(row);
    const bool                     is_row = words.size() > 2 && words[1] == ":";
    const auto time = is_row ? as_number(words[0]) : std::nullopt;
    if (time && words.size() == 3 && words[2] == "hold" && !segments.empty())
      return {*time, segments.back().control, Ramp::at_rate, 0., row};
    const auto number = is_row ? as_number(words.back()) : std::nullopt;
    const auto kind =
      words.size() == 4 ? kinds.find(words[2]) :
      words.size() == 5 ? kinds.find(words[2] + " " + words[3]) :
                          kinds.end();
    if (!time || !number || kind == kinds.end())
      throw InputError(
        path_of_table,
        row,
        "a row must look like '1.5: depth 0.02', '2: force "
        "0' or, but for the first, '3: hold': a time, then "
        "what is reached at that time; or '1.5: depth rate 0.01', '2: force "
        "rate 5', '3: strain rate 0.05': a time, then how fast the load "
        "changes until then. Rows are separated by '|'.");
    if (!std::isfinite(*time) || !std::isfinite(*number))
      throw InputError(path_of_table, row, "its numbers must be finite.");
    return {*time, kind->second.first, kind->second.second, *number, row};
  }



  void
  LoadProgram::read_history(const std::string &table)
  {
    for (const std::string &row : split(path_of_table, table, '|'))
      {
        const Segment segment   = read_row(row);
        const double  last_time = segments.empty() ? 0. : final_time();
        if (segment.end_time <= last_time)
          throw InputError(path_of_table,
                           row,
                           "the times must increase, and the first must be "
                           "greater than 0.");
        segments.push_back(segment);
        const auto end = value(segments.size() - 1, segment.end_time);
        if (end && !std::isfinite(*end))
          throw InputError(path_of_table, row, "it leads to no finite load.");
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
                            Ramp::to_value,
                            0.,
                            text,
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
    segments.push_back(
      {parameters.final_time, control, Ramp::to_value, *number, text});
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



  std::optional<double>
  LoadProgram::change_of_pace(const double time) const
  {
    const auto segment = std::find_if(segments.begin(),
                                      segments.end(),
                                      [time](const Segment &candidate) {
                                        return candidate.end_time == time;
                                      });
    if (!indenter_path.is_at_rest() || time >= final_time())
      return {};
    const auto next = std::next(segment);
    if (segment->control != next->control)
      return {};
    const unsigned int number = std::distance(segments.begin(), segment);
    const auto         before = rate(number, time);
    const auto         after  = rate(number + 1, time);
    if (!before || !after || !(*before * *after > 0.))
      return {};
    return *after / *before;
  }



  bool
  LoadProgram::turns_at_segment_ends_only() const
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
    for (unsigned int i = 0; i < segments.size(); ++i)
      {
        const Segment &segment = segments[i];
        const bool     holds   = segment.ramp == Ramp::to_value ?
                                   begin_value(i) == segment.number :
                                   segment.number == 0.;
        if (!segment.expression && holds)
          result.emplace_back(begin_time(i), segment.end_time);
      }
    return result;
  }



  std::optional<double>
  LoadProgram::begin_value(const unsigned int segment) const
  {
    if (segment == 0)
      return 0.;
    const Control control = segments[segment].control;
    if (segments[segment - 1].control == control)
      return value(segment - 1, begin_time(segment));
    const auto reached = turning_points.find(begin_time(segment));
    if (reached == turning_points.end())
      return {};
    return control == Control::depth ? reached->second.first :
                                       reached->second.second;
  }



  std::optional<double>
  LoadProgram::value(const unsigned int i, const double time) const
  {
    const Segment &segment = segments[i];
    if (segment.control == Control::force && segment.ramp == Ramp::to_value)
      check_force(path_of_table, segment.row, segment.number);
    if (segment.ramp == Ramp::to_value && time == segment.end_time)
      return segment.number;
    const std::optional<double> begin = begin_value(i);
    if (!begin)
      return {};
    const double begins = begin_time(i);
    switch (segment.ramp)
      {
        case Ramp::to_value:
          {
            const double fraction =
              (time - begins) / (segment.end_time - begins);
            return (1 - fraction) * *begin + fraction * segment.number;
          }
        case Ramp::at_rate:
          {
            const double result = *begin + segment.number * (time - begins);
            if (segment.control == Control::force)
              check_force(path_of_table, segment.row, result);
            return result;
          }
        case Ramp::at_strain_rate:
          check_growing_depth(segment.row, *begin);
          return *begin * std::exp(segment.number * (time - begins));
      }
    Assert(false, ExcInternalError());
    return {};
  }



  std::optional<double>
  LoadProgram::rate(const unsigned int i, const double time) const
  {
    const Segment &segment = segments[i];
    if (segment.ramp == Ramp::at_rate)
      return segment.number;
    const std::optional<double> begin = begin_value(i);
    if (!begin)
      return {};
    if (segment.ramp == Ramp::to_value)
      return (segment.number - *begin) / (segment.end_time - begin_time(i));
    return segment.number * *value(i, time);
  }



  std::optional<Load>
  LoadProgram::load(const double time) const
  {
    unsigned int i = 0;
    while (i + 1 < segments.size() && time > segments[i].end_time)
      ++i;
    const Segment &segment = segments[i];
    if (!segment.expression)
      {
        const auto load = value(i, time);
        return load ? std::make_optional(Load{segment.control, *load}) :
                      std::nullopt;
      }
    const double load = segment.expression->value(Point<1>(time));
    if (std::abs(load) <= segment.rounding)
      return Load{segment.control, 0.};
    if (segment.control == Control::force)
      check_force("Loading/Force",
                  "at t = " + Patterns::Tools::to_string(time) + ": " +
                    Patterns::Tools::to_string(load),
                  load);
    return Load{segment.control, load};
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
