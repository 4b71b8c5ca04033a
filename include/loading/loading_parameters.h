// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef loading_loading_parameters_h
#define loading_loading_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <string>

#include "base/enum_names.h"
#include "loading/time_steps.h"

namespace ElastoPlastic
{
  using namespace dealii;



  enum class Control
  {
    depth, ///< the depth of the indenter is given, the force results
    force  ///< the force is given, the depth results
  };

  template <>
  inline const EnumNames<Control> enum_names<Control> = {
    {"depth", Control::depth}, {"force", Control::force}};



  /// How the law of the material is integrated over the load steps.
  enum class Integration
  {
    backward_euler, ///< of first order in the length of the steps
    bdf2            ///< two-step backward differentiation, of second order
  };

  template <>
  inline const EnumNames<Integration> enum_names<Integration> = {
    {"backward Euler", Integration::backward_euler},
    {"BDF2", Integration::bdf2}};



  /// What drives the indenter at one moment: a depth or a force.
  struct Load
  {
    Control control;
    double  value;
  };



  /// The entries of the section "Loading"; see LoadProgram for their meaning.
  struct LoadingParameters
  {
    Control      control = Control::depth;
    std::string  depth   = "0.01";
    std::string  force   = "1";
    std::string  history;
    std::string  path;
    unsigned int n_steps        = 1;
    StepControl  step_control   = StepControl::fixed;
    double       step_tolerance = 0.002;
    double       final_time     = 1;
    Integration  integration    = Integration::backward_euler;
    unsigned int max_cuts       = 6;

    void
    add_parameters(ParameterHandler &prm);

    /// @throws InputError
    void
    check() const;

    /// Whether the load is one step from the virgin state, Johnson's stationary
    /// problem, rather than a history.
    bool
    is_single_step() const
    {
      return n_steps == 1 && history.empty() && path.empty();
    }
  };



  /// Checks that the load history @p now can go on where @p before has got to
  /// at @p time: the steps until then end at the same times under the same
  /// loads. What comes after may be different, and longer or shorter.
  /// @throws InputError that names the first difference
  void
  check_same_past(const LoadingParameters &before,
                  const LoadingParameters &now,
                  const double             time);
} // namespace ElastoPlastic

#endif
