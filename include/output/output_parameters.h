// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef output_output_parameters_h
#define output_output_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

#include "base/enum_names.h"
#include "output/log.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// What the user calls the units of length and force. No number depends on
  /// them.
  struct Units
  {
    std::string length; ///< empty if it has no name
    std::string force;  ///< likewise

    /// Whether both have a name.
    bool
    are_named() const
    {
      return !length.empty() && !force.empty();
    }

    /// The unit of a @p quantity, as the columns of the tables call them:
    /// "force", "force x length", "stress" and so on. A quantity that is none
    /// of force and length, or whose units have no names, stays as it is.
    std::string
    of(const std::string &quantity) const;
  };



  /// When the fields are written; see the entry "Fields".
  enum class FieldOutputTimes
  {
    every_cycle,
    last_cycle,
    at_times,
    never
  };

  template <>
  inline const EnumNames<FieldOutputTimes> enum_names<FieldOutputTimes> = {
    {"every cycle", FieldOutputTimes::every_cycle},
    {"last cycle", FieldOutputTimes::last_cycle},
    {"at times", FieldOutputTimes::at_times},
    {"never", FieldOutputTimes::never}};



  /// Fields of the body that are written on request only; see the entry
  /// "Additional fields".
  enum class AdditionalField
  {
    principal_stresses,
    pressure,
    triaxiality,
    back_stress
  };

  template <>
  inline const EnumNames<AdditionalField> enum_names<AdditionalField> = {
    {"principal stresses", AdditionalField::principal_stresses},
    {"pressure", AdditionalField::pressure},
    {"triaxiality", AdditionalField::triaxiality},
    {"back stress", AdditionalField::back_stress}};
  /// The load steps that surface_profile.csv is about; see the entry "Surface
  /// profile".
  enum class SurfaceProfileSteps
  {
    every_step,
    segment_ends,
    last_step,
    none
  };

  template <>
  inline const EnumNames<SurfaceProfileSteps> enum_names<SurfaceProfileSteps> =
    {{"every step", SurfaceProfileSteps::every_step},
     {"segment ends", SurfaceProfileSteps::segment_ends},
     {"last step", SurfaceProfileSteps::last_step},
     {"none", SurfaceProfileSteps::none}};



  /// The entries of the section "Output".
  struct OutputParameters
  {
    std::string      directory = "output";
    FieldOutputTimes fields    = FieldOutputTimes::every_cycle;
    /// For FieldOutputTimes::at_times.
    std::vector<double>          field_times;
    std::vector<AdditionalField> additional_fields;
    Units                        units;
    Verbosity                    screen = Verbosity::full;
    /// Wall time; 0 stands for a checkpoint after every load step.
    double              minutes_between_checkpoints = 10;
    SurfaceProfileSteps surface_profile = SurfaceProfileSteps::segment_ends;
    std::string         profile_lines; ///< see read_profile_lines()
    std::string         probe_points;  ///< see ProbePoints

    void
    add_parameters(ParameterHandler &prm);

    /// @throws InputError for the first value that is not allowed.
    void
    check() const;

    /// Whether one of the field times lies after @p begin, but not after
    /// @p end, up to rounding.
    bool
    has_time_within(const double begin, const double end) const;
  };
} // namespace ElastoPlastic

#endif
