// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <map>
#include <utility>

#include "base/exceptions.h"
#include "output/output_parameters.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Force over squared length, if it has a name of its own.
    std::string
    stress_unit(const std::string &force, const std::string &length)
    {
      static const std::map<std::pair<std::string, std::string>, std::string>
                 names = {{{"N", "m"}, "Pa"},
                          {{"N", "mm"}, "MPa"},
                          {{"kN", "mm"}, "GPa"},
                          {{"mN", "µm"}, "GPa"},
                          {{"µN", "µm"}, "MPa"},
                          {{"nN", "nm"}, "GPa"},
                          {{"lbf", "in"}, "psi"}};
      const auto found = names.find({force, length});
      return found == names.end() ? force + "/" + length + "^2" : found->second;
    }



    /// Fields are written in XML, where these mean something else.
    void
    check_unit(const std::string &entry, const std::string &unit)
    {
      if (unit.find_first_of("\"<>&") != std::string::npos)
        throw InputError("Output/" + entry,
                         unit,
                         "a unit is a name such as mm, without any of \" < > "
                         "&.");
    }
  } // namespace



  std::string
  Units::of(const std::string &quantity) const
  {
    if (quantity == "length" && !length.empty())
      return length;
    if (quantity == "area" && !length.empty())
      return length + "^2";
    if (quantity == "volume" && !length.empty())
      return length + "^3";
    if (quantity == "force" && !force.empty())
      return force;
    if (quantity == "stress" && are_named())
      return stress_unit(force, length);
    if (quantity == "force x length" && are_named())
      return force + " " + length;
    if (quantity == "force / length" && are_named())
      return force + "/" + length;
    return quantity;
  }



  void
  OutputParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Output");
    prm.add_parameter("Directory",
                      directory,
                      "Where the results go. It is created if it does not "
                      "exist; results that are there already are replaced only "
                      "with the option --overwrite.");
    prm.add_parameter(
      "Fields",
      fields,
      "When solution-*.vtu and surface-*.vtu are written: after "
      "every cycle (in a load history: after every step), after the last one "
      "only, at the 'Field times', or never. The tables (.csv) are always "
      "written. With 'every cycle', the fields of a load history begin with the "
      "state at t = 0.");
    prm.add_parameter(
      "Additional fields",
      additional_fields,
      "What else solution-*.vtu holds. principal stresses: "
      "principal_stress_1, _2 and _3, the largest first. pressure: the mean "
      "pressure, minus a third of the trace of the stress. triaxiality: minus "
      "the pressure over von Mises' stress; 0 where there is none. back stress: "
      "the tensor, the sum of all back stresses.");
    prm.add_parameter("Length unit",
                      units.length,
                      "What the unit of length of this file is called, such as "
                      "mm: for the fields (attribute units in the .vtu files), "
                      "for the file tables.md, which says what the columns of "
                      "the tables are, and for plots and pictures. It changes "
                      "no number. Empty: not named.",
                      Patterns::Anything());
    prm.add_parameter("Force unit",
                      units.force,
                      "The same for the unit of force, such as N.",
                      Patterns::Anything());
    prm.add_parameter(
      "Field times",
      field_times,
      "For 'Fields = at times': values of the time t, such as 1, 1.5, 2. The "
      "fields are those at the end of the load step that reaches or passes one "
      "of them. They must be within the load history. Unit: time.",
      Patterns::List(Patterns::Double(0)));
    prm.add_parameter(
      "Minutes between checkpoints",
      minutes_between_checkpoints,
      "In a load history: how often the folder checkpoint is written, from "
      "which the option --resume goes on: at the end of the load step under "
      "way after so many minutes, and at the end of the history. A run that "
      "receives the signal SIGTERM, or whose load step fails, writes one "
      "before it ends, so that only what kills at once or takes the power away "
      "can cost so many minutes of work. 0: after every step.",
      Patterns::Double(0));
    prm.add_parameter(
      "Screen",
      screen,
      "What is printed. full: versions, one line per Newton "
      "step, times. summary: only the table of results, without "
      "anything that a clock or the number of processes could "
      "change. quiet: nothing but errors and warnings.");
    prm.add_parameter(
      "Surface profile",
      surface_profile,
      "The load steps whose deformed contact surface is written to "
      "surface_profile.csv: every step, those at the ends of the segments of "
      "'Loading/History' (such as the largest depth and the end of the "
      "unloading; without a history the last step), the last step, or none.");
    prm.add_parameter(
      "Profile lines",
      profile_lines,
      "The lines on the contact surface of a body in space, seen from above, "
      "that surface_profile.csv is about: 'x, y; x, y', the ends of a line, "
      "with '|' between lines. There is a row wherever a line meets the side "
      "of a face. Empty: the line along x through the axis of the indenter. In "
      "two dimensions there is one surface, and all of its nodes are written.",
      Patterns::Anything());
    prm.add_parameter(
      "Probe points",
      probe_points,
      "Points of the undeformed body whose displacement, stress and strain are "
      "written to probes.csv at the end of each step: 'name: x, y, z' (in two "
      "dimensions 'name: x, y'), with '|' between points. The mean "
      "displacements of all boundaries are always there.",
      Patterns::Anything());
    prm.leave_subsection();
  }



  void
  OutputParameters::check() const
  {
    if (directory.empty())
      throw InputError("Output/Directory",
                       directory,
                       "it must name a folder; '.' is the one that the program "
                       "runs in.");
    check_unit("Length unit", units.length);
    check_unit("Force unit", units.force);
    if (fields == FieldOutputTimes::at_times && field_times.empty())
      throw InputError("Output/Field times",
                       "",
                       "with 'Output/Fields = at times' it must name at least "
                       "one time.");
  }



  bool
  OutputParameters::has_time_within(const double begin, const double end) const
  {
    constexpr double rounding = 1e-9;
    return std::any_of(field_times.begin(),
                       field_times.end(),
                       [&](const double time) {
                         return time > begin + rounding * end &&
                                time <= end + rounding * end;
                       });
  }
} // namespace ElastoPlastic
