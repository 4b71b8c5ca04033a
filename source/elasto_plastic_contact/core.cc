// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/fe/fe_q.h>

#include "base/exceptions.h"
#include "base/termination.h"
#include "elasto_plastic_contact.h"
#include "evaluation/modelled_part.h"
#include "io/table_reference.h"
#include "mesh/material_ids.h"
#include "problem_checks.h"
#include "safe_load.h"

namespace ElastoPlastic
{
  namespace
  {
    double
    largest_shear_modulus(const std::vector<Material<double>> &materials)
    {
      double modulus = 0;
      for (const Material<double> &material : materials)
        modulus = std::max(modulus, material.shear_modulus);
      return modulus;
    }



    template <int dim>
    bool
    depends_on_time_elsewhere(const Model<dim> &model)
    {
      return !model.boundary_conditions.prescribed_displacements().empty() ||
             !model.boundary_conditions.tractions().empty() ||
             model.body_force.is_present();
    }



    // Adaptive steps end where fixed ones do if something may turn there.
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
      if (!model.load_program.is_piecewise_linear() ||
          depends_on_time_elsewhere(model))
        stops.insert(stops.end(),
                     fixed.uncut_ends().begin(),
                     fixed.uncut_ends().end());
      return TimeSteps(ends, loading.n_steps, loading.max_cuts, stops);
    }



    /// What to say of the shortest possible one of @p steps that has failed
    /// with @p error, the last equilibrium being @p last.
    ConvergenceError
    failure_of_shortest_step(const ConvergenceError &error,
                             const TimeSteps        &steps,
                             const SolveResult      &last)
    {
      return ConvergenceError(
        "Load step " + std::to_string(steps.number()) +
        " from t = " + Patterns::Tools::to_string(steps.time()) + " (depth " +
        Patterns::Tools::to_string(last.depth) + ") fails even if it ends at " +
        "t = " + Patterns::Tools::to_string(steps.next_time()) +
        ", and 'Loading/Maximum number of cuts' allows for no shorter one. " +
        error.what());
    }
  } // namespace



  // The members are constructed in the order in which the problem is
  // described: first the body, then what holds it, then what presses on it.
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
    , field_output(parameters.output)
    , triangulation(communicator)
    , gap_function(make_mesh_and_place_indenter(model, triangulation))
    , finest_first_level(triangulation.n_global_levels() - 1)
    , small_strain_guard(
        NominalContact<dim>(model, triangulation, gap_function))
    , fe(FE_Q<dim>(model.degree), dim)
    , dof_handler(triangulation)
    , supports(model)
    , solid(std::make_unique<SolidOperator<dim>>(model.degree,
                                                 model.strain_model,
                                                 model.materials))
    , reactions(model, dof_handler, supports)
    , contact(make_contact_bounds(model, gap_function, triangulation),
              model.strain_model.kinematics,
              model.contact.edge,
              CoulombFriction<dim>(model.contact.friction_coefficient(),
                                   largest_shear_modulus(model.materials)))
    , boundary_displacements(model, triangulation)
    , probe_points(parameters.output.probe_points,
                   model.boundary_conditions.names(),
                   triangulation)
    , imprint(model,
              gap_function,
              triangulation,
              parameters.output.profile_lines)
    , output_directory(communicator, parameters.output.directory)
    , checkpoint(communicator, parameters.output.directory, parameters.entries)
  {
    if (parameters.analysis == Analysis::contact_with_error_bound)
      error_bound.emplace(
        model, parameters, communicator, gap_function, triangulation);
    parameters.refinement.check_first_mesh(
      estimated_unknowns(triangulation.n_global_active_cells(), fe));
    setup_body();
    setup_contact();
    check_loads(model, load_program, time_steps, dof_handler);
    check_supports(model, dof_handler, supports, contact, external_forces);
    parameters.refinement.check_first_mesh(dof_handler.n_dofs());
    for (const std::string &warning : model.geometry.warnings())
      log.warn(warning);
    if (const std::string warning =
          warning_of_unused_materials(triangulation, model.materials.size());
        !warning.empty())
      log.warn(warning);
  }



  template <int dim>
  void
  ElastoPlasticContact<dim>::check_contact() const
  {
    if (gap_function.has_indenter())
      {
        check_reach(load_program, time_steps, parameters.loading, contact);
        check_path(model, time_steps, parameters.loading, triangulation);
      }
    imprint.check_lines(contact_surface());
  }



  template <int dim>
  void
  ElastoPlasticContact<dim>::run(const bool overwrite)
  {
    check_contact();
    log.print_banner(Utilities::MPI::n_mpi_processes(communicator));
    remark_on_holds();
    output_directory.begin_run(overwrite, parameters.effective_input);
    output_initial_state();
    run_load_history(Statistics::Progress());
  }



  template <int dim>
  void
  ElastoPlasticContact<dim>::resume()
  {
    log.print_banner(Utilities::MPI::n_mpi_processes(communicator));
    output_directory.resume_run();
    const Statistics::Progress progress = load_checkpoint();
    if (gap_function.has_indenter())
      check_path(model, time_steps, parameters.loading, triangulation);
    run_load_history(progress);
  }



  // When the user wants to stop, the step under way is given up.
  template <int dim>
  void
  ElastoPlasticContact<dim>::run_load_history(
    const Statistics::Progress &progress)
  {
    auto probes = boundary_displacements.names();
    for (const std::string &name : probe_points.names())
      probes.push_back(name);
    Statistics statistics(communicator,
                          parameters.output.directory,
                          {dim, reactions.names(), probes},
                          make_indentation_test(model,
                                                triangulation,
                                                gap_function,
                                                parameters.evaluation),
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
    catch (const TerminationError &)
      {
        if (time_steps.number() > 1)
          {
            take_back_step();
            save_checkpoint(statistics);
          }
        throw;
      }
    timer.print_summary();
    log.remark("Results are in " + parameters.output.directory);
    if (error_bound && !error_bound->why_missing().empty())
      throw ConvergenceError(
        "The contact problem has been solved, and the results are written, but "
        "there is no error bound on the last mesh. " +
        error_bound->why_missing());
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
            apply_load();
            if (!cut || model.strain_model.is_finite())
              predict();
            SolveResult      result = solve_on_mesh_sequence(statistics);
            const StepResult step   = evaluate_step(result);
            commit_step(result);
            statistics.add_step(step);
            if (!model.strain_model.is_finite())
              warn_of_large_strains(result);
            step_is_under_way = false;
          }
        catch (const ConvergenceError &error)
          {
            if (!time_steps.cut())
              give_up_step(parameters.loading.is_single_step() ?
                             error :
                             failure_of_shortest_step(error,
                                                      time_steps,
                                                      last_step.result),
                           model,
                           {contact.force(), time_steps.next_time()},
                           tractions_grow(),
                           last_step.result);
            log.warn("The step from t = " +
                     Patterns::Tools::to_string(time_steps.time()) +
                     " has not converged; trying half of it.");
            take_back_step();
            if (!model.strain_model.is_finite())
              contact.unite_edge();
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



  template <int dim>
  void
  ElastoPlasticContact<dim>::warn_of_large_strains(const SolveResult &result)
  {
    if (const std::string warning = small_strain_guard.warning(result);
        !warning.empty())
      log.warn(warning);
  }



  // What the next step needs, if there is one.
  template <int dim>
  void
  ElastoPlasticContact<dim>::finish_step(Statistics &statistics)
  {
    const unsigned int n_iterations = last_step.result.newton_iterations;
    if (last_step.result.time != load_program.final_time())
      adapt_mesh(statistics);
    time_steps.advance(n_iterations);
  }



  // The checkpoint is that of a history which had come to its end. The mesh is
  // what this step has left.
  template <int dim>
  void
  ElastoPlasticContact<dim>::go_on_after_end(Statistics &statistics)
  {
    if (adaptation_is_due())
      find_error_indicators();
    finish_step(statistics);
    if (time_steps.finished())
      log.remark(
        "The load history is complete, and nothing is left to do. To "
        "go on, make it longer: 'Loading/History', or 'Final time', and "
        "'Number of steps'.");
  }



  // No material depends on rates; but what is prescribed elsewhere may depend
  // on time.
  template <int dim>
  void
  ElastoPlasticContact<dim>::remark_on_holds()
  {
    if (load_program.path().is_at_rest() && !depends_on_time_elsewhere(model))
      for (const auto &[begin, end] : load_program.holds())
        log.remark(
          "'Loading/History' holds the load from t = " +
          Patterns::Tools::to_string(begin) + " to " +
          Patterns::Tools::to_string(end) +
          ": nothing happens meanwhile, because no material depends on "
          "rates. The steps repeat the same equilibrium.");
  }



  // The mesh is adapted in the first load step, in a number of cycles. Each
  // solution, interpolated to the next mesh, is the starting guess there, so
  // that the fine meshes need only a few Newton steps.
  template <int dim>
  SolveResult
  ElastoPlasticContact<dim>::solve_on_mesh_sequence(Statistics &statistics)
  {
    while (true)
      {
        const SolveResult result  = solve();
        const bool        is_last = !mark_next_mesh();
        statistics.add_solve(result);
        output_results(is_last);
        output_directory.accept_results();
        if (is_last)
          return result;
        if (error_bound && !error_bound->why_missing().empty())
          log.warn(
            "The contact problem has been solved, but there is no "
            "error bound on this mesh. " +
            error_bound->why_missing());
        refine_mesh();
      }
  }



  template class ElastoPlasticContact<2>;
  template class ElastoPlasticContact<3>;
} // namespace ElastoPlastic
