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
    , time_steps(load_program.segment_ends(),
                 parameters.loading.n_steps,
                 parameters.loading.is_single_step() ?
                   0 :
                   parameters.loading.max_cuts)
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
    , contact([this](const Point<dim> &x) { return gap_function.value(x); },
              model.strain_model.kinematics,
              model.edge_rule)
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
    if constexpr (dim == 2)
      if (parameters.analysis == Analysis::contact_with_error_bound)
        error_bound.emplace(model, parameters, communicator, gap_function);
    parameters.refinement.check_first_mesh(
      estimated_unknowns(triangulation.n_global_active_cells(), fe));
    setup_body();
    setup_contact();
    check_loads(model, load_program, time_steps, dof_handler);
    check_supports(model, dof_handler, supports, contact, external_forces);
    parameters.refinement.check_first_mesh(dof_handler.n_dofs());
    imprint.check_lines(contact_surface());
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
      check_reach(load_program, time_steps, parameters.loading, contact);
  }



  template <int dim>
  void
  ElastoPlasticContact<dim>::run(const bool overwrite)
  {
    check_contact();
    log.print_banner(Utilities::MPI::n_mpi_processes(communicator));
    output_directory.begin_run(overwrite, parameters.effective_input);
    write_table_reference(communicator, parameters.output);
    output_initial_state();
    run_load_history(Statistics::Progress());
  }



  template <int dim>
  void
  ElastoPlasticContact<dim>::resume()
  {
    log.print_banner(Utilities::MPI::n_mpi_processes(communicator));
    output_directory.resume_run();
    run_load_history(load_checkpoint());
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
    note_termination_requests();
    try
      {
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
  // and tried again in two halves.
  template <int dim>
  void
  ElastoPlasticContact<dim>::take_load_steps(Statistics &statistics)
  {
    const unsigned int interval = parameters.output.checkpoint_interval;
    bool               cut      = false;
    while (!time_steps.finished())
      {
        try
          {
            step_is_under_way = true;
            apply_load();
            if (!cut)
              predict();
            SolveResult      result = solve_on_mesh_sequence(statistics);
            const StepResult step   = evaluate_step(result);
            commit_step(result);
            statistics.add_step(step);
            if (const std::string warning = small_strain_guard.warning(result);
                !warning.empty())
              log.warn(warning);
            step_is_under_way = false;
          }
        catch (const ConvergenceError &error)
          {
            if (!time_steps.cut())
              give_up_step(error,
                           model,
                           {contact.force(), time_steps.next_time()},
                           tractions_grow(),
                           last_step.result);
            log.warn("The step from t = " +
                     Patterns::Tools::to_string(time_steps.time()) +
                     " has not converged; trying half of it.");
            take_back_step();
            contact.unite_edge();
            cut = true;
            continue;
          }
        adapt_mesh(statistics);
        time_steps.advance();
        cut = false;
        if (interval > 0 && (time_steps.number() - 1) % interval == 0 &&
            !time_steps.finished())
          save_checkpoint(statistics);
      }
    statistics.finish();
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



  // In a history, the fields of a step are those on its last mesh.
  template <int dim>
  void
  ElastoPlasticContact<dim>::output_results(const bool last_cycle)
  {
    const bool single_step = parameters.loading.is_single_step();
    const bool is_last = time_steps.next_time() == load_program.final_time();
    const bool every_time =
      (parameters.output.fields == FieldOutputTimes::every_cycle);
    if (parameters.output.fields == FieldOutputTimes::never ||
        (!last_cycle && !(every_time && single_step)) ||
        (!is_last && !every_time))
      return;

    const unsigned int number = single_step ? cycle : time_steps.number();
    write_fields(every_time ? Utilities::int_to_string(number, 3) : "last",
                 single_step ? cycle : time_steps.next_time());
    if (error_bound && error_bound->why_missing().empty())
      error_bound->write_fields(cycle);
  }



  // The virgin body and the indenter where it stands, at t = 0 of a history.
  template <int dim>
  void
  ElastoPlasticContact<dim>::output_initial_state()
  {
    if (parameters.loading.is_single_step() ||
        parameters.output.fields != FieldOutputTimes::every_cycle)
      return;
    contact.place(0.);
    write_fields(Utilities::int_to_string(0, 3), 0.);
  }



  // What the tables say of the end of a step, before the material points take
  // it as the beginning of the next one. (The result that it refers to is still
  // to grow.)
  template <int dim>
  StepResult
  ElastoPlasticContact<dim>::evaluate_step(const SolveResult &result) const
  {
    TimerOutput::Scope scope(timer, "Evaluation");
    StepResult         step = {result,
                               reactions.compute(*solid,
                                         displacement,
                                         contact.forces_on_body(residual),
                                         result.time),
                               boundary_displacements.compute(dof_handler,
                                                      displacement),
                               {}};
    for (const double value :
         probe_points.compute(dof_handler, *solid, displacement))
      step.probes.push_back(value);
    if (writes_surface_profile(result.time))
      step.surface_profile = imprint.profile(result, contact_surface());
    return step;
  }



  template <int dim>
  void
  ElastoPlasticContact<dim>::write_fields(const std::string &name,
                                          const double       time)
  {
    TimerOutput::Scope scope(timer, "Output");
    field_output.write({dof_handler,
                        supports.constraints(),
                        *solid,
                        contact,
                        model.boundary_conditions.ids(
                          BoundaryConditionType::contact),
                        displacement,
                        residual,
                        error_indicators},
                       name,
                       time);
  }



  template <int dim>
  bool
  ElastoPlasticContact<dim>::writes_surface_profile(const double time) const
  {
    switch (parameters.output.surface_profile)
      {
        case SurfaceProfileSteps::every_step:
          return true;
        case SurfaceProfileSteps::segment_ends:
          return load_program.is_segment_end(time);
        case SurfaceProfileSteps::last_step:
          return time == load_program.final_time();
        case SurfaceProfileSteps::none:
          return false;
      }
    Assert(false, ExcInternalError());
    return false;
  }



  template class ElastoPlasticContact<2>;
  template class ElastoPlasticContact<3>;
} // namespace ElastoPlastic
