// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <sstream>

#include "contact_run/load_step.h"
#include "problem/load_history.h"

namespace ElastoPlastic
{
  namespace
  {
    /// In tolerances: half of such a step errs by a quarter of it.
    constexpr double largest_error = 4.;

    /// Of the last step: up to 1 + sqrt(2) of them, two-step backward
    /// differentiation is zero-stable, and steps of a row grow by 2 at most.
    constexpr double longest_continuation = 2. + 1e-6;
  } // namespace



  template <int dim>
  void
  LoadStep<dim>::make_body()
  {
    if (parameters.loading.integration == Integration::bdf2)
      body.keep_increments();
    body.reinit(time_steps.next_time(), load());
    take_initial_forces();
  }



  template <int dim>
  void
  LoadStep<dim>::take_initial_forces()
  {
    if (!model.initial_stress.is_present())
      return;
    last_step.forces = body.forces_at_rest();
    note_forces(body.initial_force_scale());
  }



  template <int dim>
  void
  LoadStep<dim>::begin()
  {
    under_way = true;
    body.begin_step(time_steps.time(), time_steps.next_time(), load());
    const std::optional<double> duration = duration_at_last_pace();
    if (!duration)
      return;
    if (parameters.loading.integration == Integration::bdf2 && !is_first())
      body.go_on(last_step, *duration);
    if (has_rates())
      body.extrapolate(last_step, *duration);
  }



  // Without rate laws, and where no other load depends on the time, the time is
  // only a measure of how far the indenter is.
  template <int dim>
  std::optional<double>
  LoadStep<dim>::duration_at_last_pace() const
  {
    const double duration = time_steps.next_time() - time_steps.time();
    if (!load_program.is_segment_end(time_steps.time()))
      return duration;
    const auto pace = load_program.change_of_pace(time_steps.time());
    if (!pace || has_other_loads(model) || body.solid().is_rate_dependent())
      return {};
    const double at_last_pace = *pace * duration;
    if (at_last_pace > longest_continuation * last_step.duration)
      return {};
    return at_last_pace;
  }



  // (A single step is no beginning of another.)
  template <int dim>
  void
  LoadStep<dim>::commit(SolveResult &result)
  {
    result.external_work =
      last_step.work_to(body.displacement(), body.forces_of_stresses());
    last_step.add_to(result, body.solid().extrapolation_weight());
    last_step.step_error = error_of(result);
    last_step.find_rates(result, body.displacement());
    last_step.mean_force.add(result);
    last_step.largest_contact_area =
      std::max(last_step.largest_contact_area, result.contact_area);
    last_step.result = result;
    load_program.reached(result.time, result.depth, result.force);
    if (!parameters.loading.is_single_step())
      body.commit(last_step);
    under_way = false;
  }



  // (At a turn, there is nothing to compare with.)
  template <int dim>
  double
  LoadStep<dim>::error_of(const SolveResult &result) const
  {
    if (last_step.is_virgin() || load_program.is_segment_end(time_steps.time()))
      return 1.;
    std::optional<Control> control;
    if (body.gap_function().has_indenter())
      control = load().control;
    return last_step.deviation_from_rates(result,
                                          body.displacement(),
                                          control) /
           parameters.loading.step_tolerance;
  }



  template <int dim>
  bool
  LoadStep<dim>::is_too_inaccurate(const SolveResult &result) const
  {
    return parameters.loading.step_control == StepControl::accurate &&
           time_steps.is_longer_than_nominal() &&
           error_of(result) > largest_error;
  }



  template <int dim>
  void
  LoadStep<dim>::take_back()
  {
    body.return_to(last_step);
    under_way = false;
  }



  template <int dim>
  bool
  LoadStep<dim>::halve()
  {
    const bool is_shorter = time_steps.cut();
    has_been_halved       = has_been_halved || is_shorter;
    return is_shorter;
  }



  template <int dim>
  void
  LoadStep<dim>::advance(const unsigned int n_iterations)
  {
    time_steps.advance(n_iterations, last_step.step_error);
    has_been_halved = false;
  }



  template <int dim>
  void
  LoadStep<dim>::change_mesh()
  {
    ++mesh_number;
    body.refine(time_steps.next_time(), load(), last_step);
    if (last_step.is_virgin())
      take_initial_forces();
    if (under_way)
      return;
    last_step.displacement = body.displacement();
    take_back();
  }



  // Of its nodal forces, only those count that hold the body; the others are
  // what it lacks for an equilibrium, and do no work.
  template <int dim>
  void
  LoadStep<dim>::commit_interpolated()
  {
    take_back();
    body.drop_forces_without_support();
    last_step.forces = body.forces_of_stresses();
  }



  template <int dim>
  void
  LoadStep<dim>::commit_on_new_mesh(SolveResult result)
  {
    if (last_step.is_largest(last_step.result.contact_area))
      last_step.largest_contact_area = result.contact_area;
    result.plastic_work           = 0;
    result.dissipation            = 0;
    result.frictional_dissipation = 0;
    last_step.add_to(result, 0.);
    last_step.result = result;
    load_program.reached(result.time, result.depth, result.force);
    body.commit(last_step);
  }



  template <int dim>
  void
  LoadStep<dim>::restore(const std::string &mesh_file)
  {
    if (is_done())
      time_steps.end_step_at(last_step.result.time);
    body.restore(mesh_file, time_steps.next_time(), load(), last_step);
    take_back();
  }



  template <int dim>
  ConvergenceError
  LoadStep<dim>::failure(const ConvergenceError &error) const
  {
    if (parameters.loading.is_single_step())
      return error;
    return ConvergenceError(
      "Load step " + std::to_string(time_steps.number()) +
      " from t = " + Patterns::Tools::to_string(time_steps.time()) +
      " (depth " + Patterns::Tools::to_string(last_step.result.depth) +
      ") fails even if it ends at t = " +
      Patterns::Tools::to_string(time_steps.next_time()) +
      ", and 'Loading/Maximum number of cuts' allows for no shorter one. " +
      error.what());
  }



  template <int dim>
  void
  LoadStep<dim>::give_up(const ConvergenceError &error) const
  {
    const SolveResult &last = last_step.result;
    const double force = body.contact().force(), time = time_steps.next_time();
    const bool   force_grows = force > last.force;
    if (std::none_of(model.materials.begin(),
                     model.materials.end(),
                     has_limit) ||
        !(force_grows || tractions_grow()))
      throw failure(error);

    const std::string where =
      "to be beyond the limit load of the body, whose material stops "
      "hardening. ";
    std::ostringstream message;
    message.precision(10);
    message << "No equilibrium has been found ";
    if (force_grows)
      message << "for the force " << force << " (t = " << time << "): it seems "
              << where << "The largest force reached is " << last.force
              << ", at the depth " << last.depth
              << ". Prescribe the depth, or a smaller force";
    else
      message << "under the tractions and body forces at t = " << time
              << ": they seem " << where
              << "The last equilibrium is that at t = " << last.time
              << ". Prescribe smaller ones ('Boundary conditions/Traction', "
                 "'Body force'), or displacements instead";
    message << "; several load steps come closer to the limit.";
    throw EquilibriumError(message.str());
  }



  template <int dim>
  bool
  LoadStep<dim>::tractions_grow() const
  {
    VectorType growth = body.external_forces();
    if (!last_step.is_virgin() || model.initial_stress.is_present())
      growth -= body.external_forces_at(time_steps.time());
    return growth * body.external_forces() > 0;
  }



  template class LoadStep<2>;
  template class LoadStep<3>;
} // namespace ElastoPlastic
