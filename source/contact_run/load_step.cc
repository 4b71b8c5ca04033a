// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>

#include "base/memory.h"
#include "contact_run/elasto_plastic_contact.h"

namespace ElastoPlastic
{
  // What the load step under way asks for.
  template <int dim>
  Load
  ElastoPlasticContact<dim>::load_at_end_of_step() const
  {
    return load_program.load(time_steps.next_time()).value();
  }



  // The starting guess for a step that continues the last one: things go on at
  // the same rate. (Finite strains need a guess as soon as there is one: a
  // surface that moves alone would crush the elements below.)
  template <int dim>
  void
  ElastoPlasticContact<dim>::predict()
  {
    const double       begin  = time_steps.time();
    const unsigned int n_past = model.strain_model.is_finite() ? 1 : 2;
    if (time_steps.number() <= n_past || load_program.is_segment_end(begin))
      return;
    const double duration = time_steps.next_time() - begin;
    body.displacement.add(duration, last_step.displacement_rate);
    if (body.contact.is_force_driven())
      body.contact.place(last_step.result.depth +
                         duration * last_step.depth_rate);
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
        const SolveResult result = solve();
        const bool        is_last =
          time_steps.number() > 1 || !adaptation.mark_in_first_step(cycle);
        statistics.add_solve(result);
        output.write(time_steps, cycle, is_last, last_step);
        output_directory.accept_results();
        if (is_last)
          return result;
        if (const std::string reason = error_estimate.why_bound_is_missing();
            !reason.empty())
          log.warn(
            "The contact problem has been solved, but there is no "
            "error bound on this mesh. " +
            reason);
        ++cycle;
        body.refine(time_steps.next_time(), load_at_end_of_step(), last_step);
      }
  }



  // One solve on one mesh, and what its solution says.
  template <int dim>
  SolveResult
  ElastoPlasticContact<dim>::solve()
  {
    Timer       wall_clock(communicator, /* sync_lap_times = */ true);
    SolveResult result;
    result.step  = time_steps.number();
    result.time  = time_steps.next_time();
    result.cycle = cycle;
    result.cells = body.triangulation.n_global_active_cells();
    result.dofs  = body.dof_handler.n_dofs();
    log.begin_solve(result);

    find_equilibrium(result);
    evaluation.measure(result, last_step);
    // in a history, only where the user sees it or the mesh depends on it
    if (time_steps.number() == 1 || adaptation.is_due(result.step) ||
        output.are_due(time_steps))
      error_estimate.evaluate(result,
                              load_at_end_of_step(),
                              [this](const double depth) {
                                return displacement_at(depth);
                              });

    result.memory_mb = peak_memory(communicator);
    wall_clock.stop();
    result.wall_seconds = wall_clock.wall_time();
    log.end_solve(result);
    return result;
  }



  // The heart of the program: the primal-dual active set loop. It lives in
  // SemismoothNewton, which treats contact and plasticity as one nonlinear
  // problem; ContactProblem tells it about energy, forces, tangent and active
  // set. What remains to be done here is a good first guess of the active set:
  // all nodes that the starting displacement brings to the indenter.
  template <int dim>
  void
  ElastoPlasticContact<dim>::find_equilibrium(SolveResult &result)
  {
    TimerOutput::Scope     scope(timer, "Nonlinear solver");
    const SemismoothNewton newton(parameters.newton,
                                  [this](const NewtonStep &step) {
                                    log.newton_step(step);
                                    stop_if_requested();
                                  });

    body.contact.begin_step(last_step.is_virgin() ?
                              VectorType(body.displacement.get_partitioner()) :
                              last_step.displacement,
                            last_step.is_virgin() ? 0. : last_step.result.depth,
                            body.sideways_position(time_steps.next_time()) -
                              body.sideways_position(last_step.result.time));
    if (body.gap_function.has_indenter() &&
        (std::isinf(adaptation.min_gap()) ||
         (body.contact.force() > 0. && body.contact.n_candidates() == 0)))
      throw ConvergenceError(
        "The indenter has left the contact boundary: there is nothing below it "
        "that it could touch. Check 'Loading/Path', or model more of the body.");
    body.contact.activate_touching(body.displacement);
    const auto minimise = [&]() {
      ContactProblem<dim> problem =
        body.problem_with(body.contact, last_step.largest_forces);
      const NewtonReport report = newton.solve(problem, body.displacement);
      body.residual             = report.residual;
      body.contact.settle(body.displacement);

      result.newton_iterations += report.n_iterations();
      result.linear_iterations += report.n_linear_iterations();
      result.residual = report.steps.back().residual;
      result.energy   = report.steps.back().energy;
    };
    minimise();
    if (body.contact.find_sticking(body.displacement, body.residual))
      minimise();
    if (result.residual > parameters.newton.tolerance)
      log.warn(
        "The forces on the free unknowns are " +
        Patterns::Tools::to_string(result.residual) +
        " of all forces, above 'Nonlinear solver/Tolerance': parts of the "
        "body are so stiff, or so nearly incompressible, that the rounding "
        "of the displacements does not allow for less.");
  }



  // What would be if the indenter were at that depth; all stays as it is.
  template <int dim>
  VectorType
  ElastoPlasticContact<dim>::displacement_at(const double depth)
  {
    const SemismoothNewton newton(parameters.newton,
                                  [this](const NewtonStep &) {
                                    stop_if_requested();
                                  });
    ContactSet<dim>        contact_there(body.contact);
    VectorType             result = body.displacement;
    contact_there.set_load({Control::depth, depth});
    contact_there.activate_touching(result);
    ContactProblem<dim> problem =
      body.problem_with(contact_there, last_step.largest_forces);
    newton.solve(problem, result);
    return result;
  }



  // The end of a step: the work that has been done in it, and, in a history,
  // what the next step begins with.
  template <int dim>
  void
  ElastoPlasticContact<dim>::commit_step(SolveResult &result)
  {
    result.external_work =
      last_step.work_to(body.displacement, body.forces_of_stresses());
    last_step.add_to(result);
    last_step.step_error =
      last_step.is_virgin() || load_program.is_segment_end(time_steps.time()) ?
        1. : // (nothing to compare with)
        last_step.deviation_from_rates(result,
                                       body.displacement,
                                       body.gap_function.has_indenter()) /
          parameters.loading.step_tolerance;
    last_step.find_rates(result, body.displacement);
    last_step.mean_force.add(result);
    evaluation.note(result, last_step);
    last_step.result = result;
    last_step.largest_contact_area =
      std::max(last_step.largest_contact_area, result.contact_area);
    load_program.reached(result.time, result.depth, result.force);
    if (!parameters.loading.is_single_step())
      commit_state();
  }



  // From now on, this equilibrium is where the next step begins.
  template <int dim>
  void
  ElastoPlasticContact<dim>::commit_state()
  {
    last_step.slip = body.total_slip(last_step);
    body.solid.commit(body.displacement);
    body.solid.predict_flow(body.displacement, body.displacement);
    last_step.displacement = body.displacement;
    last_step.forces       = body.forces_of_stresses();
  }



  // Back to the end of the last step. (The material points have not forgotten
  // it.)
  template <int dim>
  void
  ElastoPlasticContact<dim>::take_back_step()
  {
    if (last_step.is_virgin())
      body.displacement = 0.;
    else
      body.displacement = last_step.displacement;
    body.solid.begin_step(0.);
    body.solid.predict_flow(body.displacement, body.displacement);
    body.contact.deactivate_all();
    body.move_indenter(last_step.result.time);
    body.contact.begin_step(body.displacement, last_step.result.depth, {});
    body.contact.place(last_step.result.depth);
    body.contact.activate_touching(body.displacement);
  }



  // What to know of it if it fails, however short it is made.
  template <int dim>
  FailedStep<dim>
  ElastoPlasticContact<dim>::step_under_way() const
  {
    return {model,
            parameters.loading.is_single_step(),
            time_steps.number(),
            time_steps.time(),
            time_steps.next_time(),
            body.contact.force(),
            tractions_grow()};
  }



  // Those of the step under way, since the last one: they do not if they only
  // become smaller. The virgin body bears none. Collective.
  template <int dim>
  bool
  ElastoPlasticContact<dim>::tractions_grow() const
  {
    VectorType growth = body.external_forces;
    if (!last_step.is_virgin())
      growth -= body.external_forces_at(time_steps.time());
    return growth * body.external_forces > 0;
  }



  template class ElastoPlasticContact<2>;
  template class ElastoPlasticContact<3>;
} // namespace ElastoPlastic
