// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>
#include <sstream>

#include "base/exceptions.h"
#include "base/text.h"
#include "loading/load_program.h"
#include "loading/loading_parameters.h"
#include "loading/time_steps.h"

namespace ElastoPlastic
{
  namespace
  {
    constexpr double rounding = 1e-9;



    std::string
    text(const double number)
    {
      return Patterns::Tools::to_string(number);
    }



    std::string
    text(const std::optional<Load> &load)
    {
      return !load ? "a load that depends on what is reached" :
                     Patterns::Tools::to_string(load->control) + " " +
                       text(load->value);
    }



    bool
    are_equal(const double a, const double b)
    {
      return std::abs(a - b) <= rounding * std::max(std::abs(a), std::abs(b));
    }



    bool
    are_equal(const std::optional<Load> &a, const std::optional<Load> &b)
    {
      return a.has_value() == b.has_value() &&
             (!a ||
              (a->control == b->control && are_equal(a->value, b->value)));
    }



    std::vector<double>
    ends_of_steps(const LoadProgram       &program,
                  const LoadingParameters &parameters)
    {
      return TimeSteps(program.segment_ends(), parameters.n_steps, 0)
        .uncut_ends();
    }



    /// What the row of the table that leads to @p time says behind its colon.
    std::string
    row_at(const LoadingParameters &parameters, const double time)
    {
      for (const std::string &row :
           split("Loading/History", parameters.history, '|'))
        {
          const auto colon = row.find(':');
          if (as_number(row.substr(0, colon)) < time)
            continue;
          std::istringstream words(row.substr(colon + 1));
          std::string        result;
          for (std::string word; words >> word;)
            result += (result.empty() ? "" : " ") + word;
          return result;
        }
      return {};
    }



    void
    refuse(const double time, const std::string &what)
    {
      throw InputError(
        "The run cannot be resumed with this load history: " + what +
        ". Up to t = " + text(time) +
        ", where the checkpoint is, loads and steps must be what they were; "
        "what comes after may change. (To go on for longer at the same pace, "
        "'Loading/Number of steps' must grow with the final time.)");
    }
  } // namespace



  // The step under way at @p time, if it has been cut, belongs to the past.
  // (Where the load depends on what is reached, it is the same if the row is.)
  void
  check_same_past(const LoadingParameters &before,
                  const LoadingParameters &now,
                  const double             time)
  {
    if (before.integration != now.integration)
      refuse(time,
             "'Loading/Integration' is '" +
               Patterns::Tools::to_string(now.integration) + "' instead of '" +
               Patterns::Tools::to_string(before.integration) + "'");
    const LoadProgram         old_program(before), program(now);
    const std::vector<double> old_ends = ends_of_steps(old_program, before);
    const std::vector<double> ends     = ends_of_steps(program, now);
    for (unsigned int i = 0; i < old_ends.size(); ++i)
      {
        const std::string step = "step " + std::to_string(i + 1);
        if (i == ends.size())
          refuse(time, "it ends before " + step);
        if (!are_equal(old_ends[i], ends[i]))
          refuse(time,
                 step + " ends at t = " + text(ends[i]) + " instead of " +
                   text(old_ends[i]));
        const auto old_load = old_program.load(old_ends[i]);
        const auto load     = program.load(ends[i]);
        if (!are_equal(old_load, load))
          refuse(time,
                 step + " leads to " + text(load) + " instead of " +
                   text(old_load));
        if (!load)
          {
            const std::string old_row = row_at(before, old_ends[i]);
            const std::string row     = row_at(now, ends[i]);
            if (row != old_row)
              refuse(time,
                     step + " follows '" + row + "' instead of '" + old_row +
                       "'");
          }
        const auto old_place = old_program.path().displacement(old_ends[i]);
        const auto place     = program.path().displacement(ends[i]);
        if ((place - old_place).norm() > rounding * old_place.norm())
          refuse(time,
                 step + " leads sideways to " +
                   Patterns::Tools::to_string(place) + " instead of " +
                   Patterns::Tools::to_string(old_place));
        if (old_ends[i] >= time)
          return;
      }
  }
} // namespace ElastoPlastic
