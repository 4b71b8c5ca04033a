// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>

#include "base/process.h"
#include "contact_run/elasto_plastic_contact.h"
#include "mesh/material_ids.h"
#include "output/columns.h"
#include "problem/load_history.h"
#include "problem/problem_checks.h"

namespace ElastoPlastic
{
  // Whatever is wrong with the input shows up here, before the first result is
  // written.
  template <int dim>
  ElastoPlasticContact<dim>::ElastoPlasticContact(
    const Model<dim>               &model,
    const Parameters               &parameters,
    const MPI_Comm                  communicator,
    const MakeGuaranteedError<dim> &make_error_bound)
    : model(model)
    , parameters(parameters)
    , communicator(communicator)
    , newton(parameters.newton,
             [this](const NewtonStep &newton_step) {
               log.newton_step(newton_step);
               stop_if_requested();
             })
    , log(communicator, parameters.output.screen)
    , timer(log.full_stream(), TimerOutput::never, TimerOutput::wall_times)
    , body(model, parameters.linear_solver, communicator, log, timer)
    , step(model, parameters, body)
    , adaptation(parameters.refinement, body, log)
    , evaluation(parameters.output, body, log, timer)
    , error_estimate(parameters, body, log, timer, make_error_bound)
    , output(parameters.output,
             parameters.loading.is_single_step(),
             body,
             error_estimate,
             timer)
    , unloading_stiffness(body, parameters.linear_solver, log, timer)
    , output_directory(communicator, parameters.output.directory)
    , checkpoint(communicator, parameters.output.directory, parameters.entries)
  {
    step.make_body();
    check_contact_boundaries(model, body.triangulation());
    if (body.gap_function().has_indenter())
      {
        check_symmetry_of_materials(model, body.triangulation());
        check_symmetry_of_indenter(model,
                                   body.gap_function(),
                                   body.triangulation());
      }
    check_field_times(parameters.output, model.load_program);
    check_loads(model, step.times(), body.dof_handler(), body.triangulation());
    check_supports(model,
                   body.dof_handler(),
                   body.supports(),
                   body.contact(),
                   body.external_forces());
    parameters.refinement.check_first_mesh(body.dof_handler().n_dofs());
    for (const std::string &warning : warnings(model))
      log.warn(warning);
    if (const std::string warning =
          warning_of_unused_materials(body.triangulation(),
                                      model.materials.size());
        !warning.empty())
      log.warn(warning);
  }



  template <int dim>
  void
  ElastoPlasticContact<dim>::check_contact() const
  {
    if (body.gap_function().has_indenter())
      {
        check_reach(model,
                    step.times(),
                    parameters.loading,
                    adaptation.min_gap());
        check_width(body.gap_function(), body.triangulation());
        check_depth(model,
                    step.times(),
                    parameters.loading,
                    body.triangulation());
        check_path(model,
                   body.gap_function(),
                   step.times(),
                   parameters.loading,
                   body.triangulation());
      }
    evaluation.check_lines();
  }



  template <int dim>
  void
  ElastoPlasticContact<dim>::run(const bool overwrite)
  {
    check_contact();
    log.print_banner(Utilities::MPI::n_mpi_processes(communicator));
    for (const std::string &remark : remarks_on_holds(model))
      log.remark(remark);
    if (model.initial_stress.is_present())
      log.remark(body.remark_on_initial_stress());
    output_directory.begin_run(overwrite, parameters.effective_input);
    body.place_indenter(0., 0.);
    output.write_initial_state();
    run_load_history(RunTables::Progress());
  }



  template <int dim>
  void
  ElastoPlasticContact<dim>::resume()
  {
    log.print_banner(Utilities::MPI::n_mpi_processes(communicator));
    output_directory.resume_run();
    const RunTables::Progress progress = load_checkpoint();
    if (body.gap_function().has_indenter())
      check_path(model,
                 body.gap_function(),
                 step.times(),
                 parameters.loading,
                 body.triangulation());
    run_load_history(progress);
  }



  // Whatever ends the step under way, what has been computed before it is kept
  // (but where nothing can be written).
  template <int dim>
  void
  ElastoPlasticContact<dim>::run_load_history(
    const RunTables::Progress &progress)
  {
    RunTables statistics(communicator,
                         parameters.output.directory,
                         evaluation.names(),
                         make_indentation_test(evaluation.nominal_contact(),
                                               model,
                                               model.indenter,
                                               body.triangulation(),
                                               body.gap_function(),
                                               parameters.evaluation),
                         make_rate_test(model, parameters.loading),
                         progress);
    output_directory.write_input(parameters.effective_input);
    write_table_reference(communicator, parameters.output);
    note_termination_requests();
    try
      {
        if (step.is_done())
          go_on_after_end(statistics);
        take_load_steps(statistics);
      }
    catch (const FileError &)
      {
        throw;
      }
    catch (const Error &error)
      {
        if (!step.is_under_way() || step.is_first())
          throw;
        keep_what_has_been_computed(error, statistics);
      }
    timer.print_summary();
    log.remark("Results are in " + parameters.output.directory);
    if (const std::string reason = error_estimate.why_bound_is_missing();
        !reason.empty())
      throw ConvergenceError(
        "The contact problem has been solved, and the results are written, but "
        "there is no error bound on the last mesh. " +
        reason);
  }



  // One load step after the other. The checkpoint at the end of a history is
  // that before the step to the next one, which depends on whether the history
  // goes on.
  template <int dim>
  void
  ElastoPlasticContact<dim>::take_load_steps(RunTables &statistics)
  {
    while (!step.times().finished())
      {
        if (!take_step(statistics))
          continue;
        const bool is_last = step.is_history_complete();
        if (is_last && !parameters.loading.is_single_step())
          save_checkpoint(statistics);
        go_on_to_next_step(statistics);
        if (!is_last && checkpoint_is_due())
          save_checkpoint(statistics);
      }
    statistics.finish();
  }



  // @return whether it has converged, and is accurate enough. If not, it has
  // been taken back, and half of it is to be tried.
  template <int dim>
  bool
  ElastoPlasticContact<dim>::take_step(RunTables &statistics)
  {
    try
      {
        step.begin();
        SolveResult result = solve_on_mesh_sequence(statistics);
        if (step.is_too_inaccurate(result))
          {
            log.remark("The step from t = " +
                       Patterns::Tools::to_string(step.times().time()) +
                       " errs by more than 'Loading/Step tolerance' allows; "
                       "trying half of it.");
            step.halve();
            step.take_back();
            return false;
          }
        const StepResult row = evaluation.of_step(result);
        step.commit(result);
        if (parameters.evaluation.continuous_stiffness)
          result.contact_stiffness = unloading_stiffness.compute();
        evaluation.note(result, step.last());
        statistics.add_step(row);
        evaluation.warn_of_limits(result);
        return true;
      }
    catch (const ConvergenceError &error)
      {
        if (!step.halve())
          step.give_up(error);
        log.warn("The step from t = " +
                 Patterns::Tools::to_string(step.times().time()) +
                 " has not converged; trying half of it.");
        step.take_back();
        return false;
      }
  }



  // The mesh is adapted in the first load step, in a number of cycles. Each
  // solution, interpolated to the next mesh, is the starting guess there, so
  // that the fine meshes need only a few Newton steps.
  template <int dim>
  SolveResult
  ElastoPlasticContact<dim>::solve_on_mesh_sequence(RunTables &statistics)
  {
    while (true)
      {
        const SolveResult result = solve();
        const bool        is_last =
          !adaptation.mark_in_step(result.step, result.cycle);
        statistics.add_solve(result);
        if (is_last && step.is_too_inaccurate(result))
          return result;
        output.write(step, is_last);
        output_directory.accept_results();
        if (is_last)
          return result;
        if (const std::string reason = error_estimate.why_bound_is_missing();
            !reason.empty())
          log.warn(
            "The contact problem has been solved, but there is no "
            "error bound on this mesh. " +
            reason);
        step.change_mesh();
      }
  }



  // One solve on one mesh, and what its solution says. Errors are estimated
  // only where the user sees them or the mesh depends on them.
  template <int dim>
  SolveResult
  ElastoPlasticContact<dim>::solve()
  {
    Timer       wall_clock(communicator, /* sync_lap_times = */ true);
    SolveResult result;
    result.step  = step.times().number();
    result.time  = step.times().next_time();
    result.cycle = step.cycle();
    result.cells = body.triangulation().n_global_active_cells();
    result.dofs  = body.dof_handler().n_dofs();
    log.begin_solve(result);

    require_reachable_surface();
    body.find_equilibrium(newton, step.last(), result);
    evaluation.warn_of_residual(result, parameters.newton.tolerance);
    step.note_forces(evaluation.measure(result, step.last()));
    if (adaptation.needs_errors(result.step) || output.are_due(step.times()))
      error_estimate.evaluate(result, step.load(), [this](const double depth) {
        const SemismoothNewton silent(parameters.newton,
                                      [this](const NewtonStep &) {
                                        stop_if_requested();
                                      });
        return body.displacement_at(depth, silent, step.last());
      });

    result.memory_mb = peak_memory(communicator);
    wall_clock.stop();
    result.wall_seconds = wall_clock.wall_time();
    log.end_solve(result);
    return result;
  }



  template <int dim>
  void
  ElastoPlasticContact<dim>::require_reachable_surface() const
  {
    if (body.gap_function().has_indenter() &&
        (std::isinf(adaptation.min_gap()) ||
         (body.contact().force() > 0. && body.contact().n_candidates() == 0)))
      throw ConvergenceError(
        "The indenter has left the contact boundary: there is nothing below it "
        "that it could touch. Check 'Loading/Path', or model more of the body.");
  }



  // What the next step needs, if there is one.
  template <int dim>
  void
  ElastoPlasticContact<dim>::go_on_to_next_step(RunTables &statistics)
  {
    const unsigned int n_iterations = step.last().result.newton_iterations;
    if (!step.is_history_complete())
      for (bool changes = adaptation.mark_after(step.last()); changes;)
        changes =
          change_mesh(statistics) && adaptation.mark_until_touched(step.last());
    step.advance(n_iterations);
  }



  // In a history, the mesh may follow the contact, in no time. On the new one,
  // the interpolated state is not in equilibrium, nor are all its stresses
  // admissible: the solution under the same load is both, and the difference
  // is what the change of the mesh has cost. A finer mesh may not bear the
  // load, though; then the next step, which can be cut, has to find the next
  // equilibrium. @return whether there is one on the new mesh.
  template <int dim>
  bool
  ElastoPlasticContact<dim>::change_mesh(RunTables &statistics)
  {
    step.change_mesh();
    try
      {
        const SolveResult result = solve();
        statistics.add_solve(result);
        statistics.add_mesh_change(step.last().result, result);
        step.commit_on_new_mesh(result);
        return true;
      }
    catch (const ConvergenceError &error)
      {
        log.warn(
          "No equilibrium has been found on the adapted mesh under "
          "the load of step " +
          std::to_string(step.last().result.step) +
          "; the next step begins with the interpolated state. " +
          error.what());
        step.commit_interpolated();
        return false;
      }
  }
} // namespace ElastoPlastic

// The rest of the class, which is compiled and instantiated as a whole:
#include "checkpoint.cc"

namespace ElastoPlastic
{
  template class ElastoPlasticContact<2>;
  template class ElastoPlasticContact<3>;
} // namespace ElastoPlastic
