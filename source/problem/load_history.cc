// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <variant>

#include "problem/load_history.h"

namespace ElastoPlastic
{
  namespace
  {
    template <int dim>
    bool
    has_rate_law(const Model<dim> &model)
    {
      return std::any_of(model.materials.begin(),
                         model.materials.end(),
                         is_rate_dependent);
    }



    bool
    has_limit_load(const Model<2> &model)
    {
      return !model.strain_model.is_finite() &&
             model.contact.friction_coefficient() == 0. &&
             !(model.body_force.is_present() &&
               model.strain_model.kinematics == Kinematics::plane_stress) &&
             std::all_of(model.materials.begin(),
                         model.materials.end(),
                         [](const Material<double> &material) {
                           return is_perfect(material) &&
                                  std::isfinite(material.yield_radius) &&
                                  !has_varying_criterion(material) &&
                                  (!has_general_criterion(material) ||
                                   std::holds_alternative<HillCriterion>(
                                     *material.criteria[0]));
                         });
    }
  } // namespace



  template <int dim>
  bool
  has_other_loads(const Model<dim> &model)
  {
    return !model.boundary_conditions.prescribed_displacements().empty() ||
           !model.boundary_conditions.tractions().empty() ||
           model.body_force.is_present();
  }



  template <int dim>
  TimeSteps
  make_time_steps(const Model<dim> &model, const Parameters &parameters)
  {
    const LoadingParameters  &loading = parameters.loading;
    const std::vector<double> ends    = model.load_program.segment_ends();
    const TimeSteps           fixed(ends,
                          loading.n_steps,
                          loading.is_single_step() ? 0 : loading.max_cuts);
    if (loading.step_control == StepControl::fixed)
      return fixed;
    std::vector<double> stops = parameters.output.field_times;
    if (!model.load_program.turns_at_segment_ends_only() ||
        has_other_loads(model))
      stops.insert(stops.end(),
                   fixed.uncut_ends().begin(),
                   fixed.uncut_ends().end());
    return TimeSteps(
      ends, loading.n_steps, loading.max_cuts, loading.step_control, stops);
  }



  template <int dim>
  std::optional<RateTest>
  make_rate_test(const Model<dim> &model, const LoadingParameters &loading)
  {
    if (!has_rate_law(model))
      return {};
    LoadingParameters at_rest = loading;
    at_rest.path.clear();
    return RateTest(LoadProgram(at_rest).segment_ends(),
                    model.load_program.holds());
  }



  template <int dim>
  std::vector<std::string>
  remarks_on_holds(const Model<dim> &model)
  {
    std::vector<std::string> remarks;
    if (model.load_program.path().is_at_rest() && !has_other_loads(model) &&
        !has_rate_law(model))
      for (const auto &[begin, end] : model.load_program.holds())
        remarks.push_back("'Loading/History' holds the load from t = " +
                          Patterns::Tools::to_string(begin) + " to " +
                          Patterns::Tools::to_string(end) +
                          ": nothing happens meanwhile, because no material "
                          "has a rate law. The steps repeat the same "
                          "equilibrium.");
    return remarks;
  }



  template bool
  has_other_loads(const Model<2> &);
  template bool
  has_other_loads(const Model<3> &);

  template TimeSteps
  make_time_steps(const Model<2> &, const Parameters &);
  template TimeSteps
  make_time_steps(const Model<3> &, const Parameters &);

  template std::optional<RateTest>
  make_rate_test(const Model<2> &, const LoadingParameters &);
  template std::optional<RateTest>
  make_rate_test(const Model<3> &, const LoadingParameters &);

  template std::vector<std::string>
  remarks_on_holds(const Model<2> &);
  template std::vector<std::string>
  remarks_on_holds(const Model<3> &);



  std::optional<double>
  largest_load(const LoadProgram &load_program,
               TimeSteps          steps,
               const Control      control)
  {
    std::optional<double> largest;
    for (; !steps.finished(); steps.advance())
      if (const auto load = load_program.load(steps.next_time());
          load && load->control == control)
        largest = std::max(largest.value_or(load->value), load->value);
    return largest;
  }



  template <>
  std::optional<LoadInQuestion>
  load_in_question(const Model<2> &model, const Parameters &parameters)
  {
    const bool has_tractions = !model.boundary_conditions.tractions().empty() ||
                               model.body_force.is_present();
    if (!has_limit_load(model) ||
        has_tractions == (model.indenter.shape != nullptr))
      return {};
    const TimeSteps steps(model.load_program.segment_ends(),
                          parameters.loading.n_steps,
                          0);
    if (has_tractions)
      return LoadInQuestion{0., steps.uncut_ends()};
    const double force =
      largest_load(model.load_program, steps, Control::force).value_or(0.);
    return force > 0 ? std::make_optional(LoadInQuestion{force, {}}) :
                       std::nullopt;
  }



  // In space, bounds that are close enough to decide take minutes or more.
  template <>
  std::optional<LoadInQuestion>
  load_in_question(const Model<3> &, const Parameters &)
  {
    return {};
  }
} // namespace ElastoPlastic
