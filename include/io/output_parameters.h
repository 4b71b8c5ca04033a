// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef io_output_parameters_h
#define io_output_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

#include "base/enum_names.h"
#include "io/log.h"

namespace ElastoPlastic
{
  using namespace dealii;

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



  /// The entries of the section "Output".
  struct OutputParameters
  {
    std::string      directory = "output";
    FieldOutputTimes fields    = FieldOutputTimes::every_cycle;
    Verbosity        screen    = Verbosity::full;
    /// For FieldOutputTimes::at_times.
    std::vector<double> field_times;
    /// Of wall time; 0: a checkpoint after every load step.
    double minutes_between_checkpoints = 10;

    void
    add_parameters(ParameterHandler &prm);

    /// @throws InputError
    void
    check() const;

    /// Whether one of the field times lies after @p begin, but not after
    /// @p end, up to rounding.
    bool
    has_time_within(const double begin, const double end) const;
  };
} // namespace ElastoPlastic

#endif
