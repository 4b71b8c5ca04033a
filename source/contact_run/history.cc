// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "base/rethrow_collectively.h"
#include "base/termination.h"
#include "contact_run/elasto_plastic_contact.h"
#include "evaluation/modelled_part.h"
#include "mesh/material_ids.h"
#include "output/table_reference.h"
#include "problem/load_checks.h"
#include "problem/load_history.h"
#include "problem/problem_checks.h"
#include "problem/support_checks.h"

namespace ElastoPlastic
{
  // Whatever is wrong with the input shows up here, before the first result is
  // written.
  template <int dim>
  ElastoPlasticContact<dim>::ElastoPlasticContact(const Model<dim> &model,
                                                  const Parameters &parameters,
                                                  const MPI_Comm communicator)
    : model(model)
    , parameters(parameters)
    , communicator(communicator)
    , load_program(model.load_program)
    , time_steps(make_time_steps(model, parameters))
    , log(communicator, parameters.output.screen)
    , timer(log.full_stream(), TimerOutput::never, TimerOutput::wall_times)
    , body(model, parameters.linear_solver, communicator, log, timer)
    , adaptation(parameters.refinement, body, log)
    , evaluation(parameters.output, body, log, timer)
    , error_estimate(parameters, body, log, timer)
    , output(parameters.output,
             parameters.loading.is_single_step(),
             body,
             error_estimate,
             timer)
    , output_directory(communicator, parameters.output.directory)
    , checkpoint(communicator, parameters.output.directory, parameters.entries)
  {
    body.reinit(time_steps.next_time(), load_at_end_of_step());
    check_contact_boundaries(model, body.triangulation);
    check_field_times(parameters.output, load_program);
    check_loads(model, time_steps, body.dof_handler, body.triangulation);
    check_supports(model,
                   body.dof_handler,
                   body.supports,
                   body.contact,
                   body.external_forces);
    parameters.refinement.check_first_mesh(body.dof_handler.n_dofs());
    for (const std::string &warning : warnings(model))
      log.warn(warning);
    if (const std::string warning =
          warning_of_unused_materials(body.triangulation,
                                      model.materials.size());
        !warning.empty())
      log.warn(warning);
  }



  template <int dim>
  void
  ElastoPlasticContact<dim>::check_contact() const
  {
    if (body.gap_function.has_indenter())
      {
        check_reach(model,
                    time_steps,
                    parameters.loading,
                    adaptation.min_gap());
        check_width(body.gap_function, body.triangulation);
        check_depth(model, time_steps, parameters.loading, body.triangulation);
        check_path(model,
                   body.gap_function,
                   time_steps,
                   parameters.loading,
                   body.triangulation);
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
    output_directory.begin_run(overwrite, parameters.effective_input);
    body.move_indenter(0.);
    body.contact.place(0.);
    output.write_initial_state();
    run_load_history(Statistics::Progress());
  }



  template <int dim>
  void
  ElastoPlasticContact<dim>::resume()
  {
    log.print_banner(Utilities::MPI::n_mpi_processes(communicator));
    output_directory.resume_run();
    const Statistics::Progress progress = load_checkpoint();
    if (body.gap_function.has_indenter())
      check_path(model,
                 body.gap_function,
                 time_steps,
                 parameters.loading,
                 body.triangulation);
    run_load_history(progress);
  }



  // Whatever ends the step under way, what has been computed before it is kept
  // (but where nothing can be written).
  template <int dim>
  void
  ElastoPlasticContact<dim>::run_load_history(
    const Statistics::Progress &progress)
  {
    Statistics statistics(communicator,
                          parameters.output.directory,
                          evaluation.names(),
                          make_indentation_test(model,
                                                model.indenter,
                                                body.triangulation,
                                                body.gap_function,
                                                parameters.evaluation),
                          make_rate_test(model),
                          progress);
    output_directory.write_input(parameters.effective_input);
    write_table_reference(communicator, parameters.output);
    note_termination_requests();
    try
      {
        if (last_step.result.step == time_steps.number())
          go_on_after_end(statistics);
        take_load_steps(statistics);
      }
    catch (const FileError &)
      {
        throw;
      }
    catch (const Error &error)
      {
        if (!step_is_under_way || time_steps.number() == 1)
          throw;
        take_back_step();
        save_checkpoint(statistics);
        throw_error(error.status,
                    std::string(error.what()) +
                      " What has been computed up to t = " +
                      Patterns::Tools::to_string(last_step.result.time) +
                      " is kept: the option --resume goes on from there, also "
                      "with other entries of 'Nonlinear solver', 'Linear "
                      "solver' and 'Loading'.");
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



  // One load step after the other. A step that does not converge is taken back
  // and tried again in two halves. The checkpoint at the end of a history is
  // that before finish_step(), which depends on whether the history goes on.
  template <int dim>
  void
  ElastoPlasticContact<dim>::take_load_steps(Statistics &statistics)
  {
    bool cut = false;
    while (!time_steps.finished())
      {
        try
          {
            step_is_under_way = true;
            body.apply_load(time_steps.next_time(), load_at_end_of_step());
            body.solid.begin_step(time_steps.next_time() - time_steps.time());
            if (!cut || model.strain_model.is_finite())
              predict();
            SolveResult      result = solve_on_mesh_sequence(statistics);
            const StepResult step   = evaluation.of_step(result);
            commit_step(result);
            statistics.add_step(step);
            evaluation.warn_of_limits(result);
            step_is_under_way = false;
          }
        catch (const ConvergenceError &error)
          {
            if (!time_steps.cut())
              give_up_step(error, step_under_way(), last_step.result);
            log.warn("The step from t = " +
                     Patterns::Tools::to_string(time_steps.time()) +
                     " has not converged; trying half of it.");
            take_back_step();
            cut = true;
            continue;
          }
        const bool is_last = last_step.result.time == load_program.final_time();
        if (is_last && !parameters.loading.is_single_step())
          save_checkpoint(statistics);
        finish_step(statistics);
        cut = false;
        if (!is_last && checkpoint_is_due())
          save_checkpoint(statistics);
      }
    statistics.finish();
  }



  // What the next step needs, if there is one.
  template <int dim>
  void
  ElastoPlasticContact<dim>::finish_step(Statistics &statistics)
  {
    const unsigned int n_iterations = last_step.result.newton_iterations;
    if (last_step.result.time != load_program.final_time())
      adapt_mesh(statistics);
    time_steps.advance(n_iterations, last_step.step_error);
  }



  // The checkpoint is that of a history which had come to its end. The mesh is
  // what this step has left.
  template <int dim>
  void
  ElastoPlasticContact<dim>::go_on_after_end(Statistics &statistics)
  {
    if (adaptation.is_due(last_step.result.step))
      error_estimate.find_indicators();
    finish_step(statistics);
    if (time_steps.finished())
      log.remark(
        "The load history is complete, and nothing is left to do. To "
        "go on, make it longer: 'Loading/History', or 'Final time', and "
        "'Number of steps'.");
  }



  template class ElastoPlasticContact<2>;
  template class ElastoPlasticContact<3>;
} // namespace ElastoPlastic
