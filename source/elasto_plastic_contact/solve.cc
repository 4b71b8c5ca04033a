// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/utilities.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/numerics/error_estimator.h>

#include <algorithm>

#include "elasto_plastic_contact.h"
#include "evaluation/element_quality.h"
#include "make_tangent_solver.h"
#include "mechanics/external_forces.h"
#include "mechanics/ghosted_copy.h"
#include "mechanics/rigid_body_modes.h"
#include "mesh/body_size.h"

namespace ElastoPlastic
{
  // Everything that depends on the mesh is prepared in the next two functions
  // and nowhere else. First unknowns, supports and the body; the displacement
  // is zero afterwards, unless refine_mesh() puts a better guess there.
  template <int dim>
  void
  ElastoPlasticContact<dim>::setup_body()
  {
    TimerOutput::Scope scope(timer, "Setup");

    dof_handler.distribute_dofs(fe);
    supports.reinit(dof_handler, time_steps.next_time());
    solid->reinit(dof_handler, supports.constraints());
    solid->initialize_vector(displacement);
  }



  // Then external forces, contact candidates and the linear solver.
  template <int dim>
  void
  ElastoPlasticContact<dim>::setup_contact()
  {
    TimerOutput::Scope scope(timer, "Setup");

    solid->initialize_vector(residual);
    contact.reinit(dof_handler,
                   supports.constraints(),
                   model.boundary_conditions.ids(
                     BoundaryConditionType::contact),
                   supports.fixed_dofs(),
                   residual);
    apply_load();

    tangent_solver = make_tangent_solver(parameters.linear_solver,
                                         model,
                                         *solid,
                                         dof_handler,
                                         supports.constraints(),
                                         residual,
                                         [this](const std::string &warning) {
                                           log.warn(warning);
                                         });
    error_indicators.reinit(triangulation.n_active_cells());
  }



  // What the load step under way asks for at its end.
  template <int dim>
  void
  ElastoPlasticContact<dim>::apply_load()
  {
    const double time = time_steps.next_time();
    supports.set_time(time);
    external_forces = external_forces_at(time);
    move_indenter(time);
    contact.set_load(load_program.load(time).value());
  }



  template <int dim>
  Tensor<1, dim - 1>
  ElastoPlasticContact<dim>::sideways_position(const double time) const
  {
    const Tensor<1, 2> displacement = load_program.path().displacement(time);
    Tensor<1, dim - 1> result;
    for (unsigned int d = 0; d < dim - 1; ++d)
      result[d] = displacement[d];
    return result;
  }



  // To where it is at that time; sideways only.
  template <int dim>
  void
  ElastoPlasticContact<dim>::move_indenter(const double time)
  {
    if (load_program.path().is_at_rest())
      return;
    gap_function.move_to(sideways_position(time));
    contact.follow_indenter();
  }



  template <int dim>
  VectorType
  ElastoPlasticContact<dim>::external_forces_at(const double time) const
  {
    VectorType forces;
    solid->initialize_vector(forces);
    compute_external_forces(
      forces, dof_handler, supports.constraints(), model, time);
    return forces;
  }



  template <int dim>
  SolveResult
  ElastoPlasticContact<dim>::solve()
  {
    Timer       wall_clock(communicator, /* sync_lap_times = */ true);
    SolveResult result;
    result.step  = time_steps.number();
    result.time  = time_steps.next_time();
    result.cycle = cycle;
    result.cells = triangulation.n_global_active_cells();
    result.dofs  = dof_handler.n_dofs();
    log.begin_solve(result);

    find_equilibrium(result);
    static_cast<ContactState &>(result) = contact.state(displacement, residual);
    static_cast<BodyState &>(result)    = body_state(*solid, displacement);
    result.depth = gap_function.has_indenter() ? contact.depth() : 0.;
    measure_imprint(result);
    if (model.strain_model.is_finite())
      measure_elements(result);
    check_force_balance(result);
    // in a history, only where the user sees it or the mesh depends on it
    if (time_steps.number() == 1 || adaptation_is_due() || fields_are_due())
      estimate_error(result);

    Utilities::System::MemoryStats memory;
    Utilities::System::get_memory_stats(memory);
    result.memory_mb = Utilities::MPI::sum(memory.VmHWM / 1024., communicator);
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

    contact.begin_step(last_step.is_virgin() ?
                         VectorType(displacement.get_partitioner()) :
                         last_step.displacement,
                       sideways_position(time_steps.next_time()) -
                         sideways_position(last_step.result.time));
    if (contact.force() > 0. && contact.n_candidates() == 0)
      throw ConvergenceError(
        "The indenter has left the contact boundary: there is nothing below it "
        "that could bear 'Loading/Force'. Check 'Loading/Path', or model more of "
        "the body.");
    contact.activate_touching(displacement);
    ContactProblem<dim> problem = problem_with(contact);
    const NewtonReport  report  = newton.solve(problem, displacement);
    problem.compute_residual(residual, displacement);
    contact.settle(displacement);

    result.newton_iterations = report.n_iterations();
    result.linear_iterations = report.n_linear_iterations();
    result.residual          = report.steps.back().residual;
    result.energy            = report.steps.back().energy;
    if (result.residual > parameters.newton.tolerance)
      log.warn(
        "The forces on the free unknowns are " +
        Patterns::Tools::to_string(result.residual) +
        " of all forces, above 'Nonlinear solver/Tolerance': parts of the "
        "body are so stiff, or so nearly incompressible, that the rounding "
        "of the displacements does not allow for less.");
  }



  template <int dim>
  ContactProblem<dim>
  ElastoPlasticContact<dim>::problem_with(ContactSet<dim> &contact)
  {
    return {*solid,
            supports,
            external_forces,
            contact,
            *tangent_solver,
            1e4 * body_size(triangulation),
            largest_forces,
            timer};
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
    ContactSet<dim>        contact_there(contact);
    VectorType             result = displacement;
    contact_there.set_load({Control::depth, depth});
    contact_there.activate_touching(result);
    ContactProblem<dim> problem = problem_with(contact_there);
    newton.solve(problem, result);
    return result;
  }



  template <int dim>
  void
  ElastoPlasticContact<dim>::measure_imprint(SolveResult &result)
  {
    TimerOutput::Scope scope(timer, "Evaluation");
    imprint.measure(result, contact_surface());
  }



  // Force and contact hardly depend on such elements (doc/user_guide.md,
  // "Finite strains"), so that the run goes on.
  template <int dim>
  void
  ElastoPlasticContact<dim>::measure_elements(SolveResult &result)
  {
    TimerOutput::Scope        scope(timer, "Evaluation");
    const ElementQuality<dim> worst = worst_element(dof_handler, displacement);
    result.min_scaled_jacobian      = worst.scaled_jacobian;
    if (worst.scaled_jacobian > 0. ||
        last_step.result.min_scaled_jacobian <= 0.)
      return;
    log.warn("In step " + std::to_string(result.step) +
             " (t = " + Patterns::Tools::to_string(result.time) + ", depth " +
             Patterns::Tools::to_string(result.depth) +
             ") an element has a corner that is turned inside out, at (" +
             Patterns::Tools::to_string(worst.place) +
             ") of the deformed body; its scaled Jacobian is " +
             Patterns::Tools::to_string(worst.scaled_jacobian) +
             ". From here on, stresses and strains of the elements around are "
             "meaningless; force and contact area hardly depend on them. See "
             "'Finite strains' in doc/user_guide.md.");
  }



  template <int dim>
  ContactSurface<dim>
  ElastoPlasticContact<dim>::contact_surface() const
  {
    return ContactSurface<dim>(
      dof_handler,
      model.boundary_conditions.ids(BoundaryConditionType::contact),
      surface_fields(
        dof_handler, supports.constraints(), contact, displacement, residual));
  }



  // The contact force, the sum of the residual over the active nodes, is
  // compared with what the supports feel, which is computed in an independent
  // way (Reactions); the difference is relative to the sum of all nodal forces,
  // because those of the supports may cancel, and to its largest value so far,
  // because after unloading there may be none.
  template <int dim>
  void
  ElastoPlasticContact<dim>::check_force_balance(SolveResult &result)
  {
    const double reaction =
      reactions.vertical_force(*solid,
                               displacement,
                               contact.forces_on_body(displacement, residual),
                               result.time);
    double load = 0;
    if (external_forces.l1_norm() > 0)
      load = external_forces * rigid_body_modes(dof_handler, residual)[dim - 1];
    largest_forces =
      std::max(largest_forces, residual.l1_norm() + external_forces.l1_norm());
    if (largest_forces > 0)
      result.force_balance_error =
        std::abs(result.force - reaction - load) / largest_forces;
  }



  template <int dim>
  void
  ElastoPlasticContact<dim>::estimate_error(SolveResult &result)
  {
    find_error_indicators();
    result.estimated_error =
      std::sqrt(Utilities::MPI::sum(error_indicators.norm_sqr(), communicator));
    if (error_bound)
      bound_error(result);
  }



  // The estimator of Kelly, de Gago, Zienkiewicz and Babuska: jumps of the
  // displacement gradient across faces. Not made for plasticity or contact, but
  // it finds the edge of the contact zone and of the plastic zone.
  template <int dim>
  void
  ElastoPlasticContact<dim>::find_error_indicators()
  {
    TimerOutput::Scope scope(timer, "Error estimator");
    KellyErrorEstimator<dim>::estimate(MappingQ1<dim>(),
                                       dof_handler,
                                       QGauss<dim - 1>(fe.degree + 1),
                                       {},
                                       ghosted_copy(displacement, dof_handler),
                                       error_indicators);
  }



  // The bound is a number that one can rely on. Cell by cell, it also tells
  // where to refine, unless the user prefers Kelly.
  template <int dim>
  void
  ElastoPlasticContact<dim>::bound_error(SolveResult &result)
  {
    TimerOutput::Scope scope(timer, "Error bound");
    result.estimated_error =
      error_bound->evaluate({dof_handler,
                             displacement,
                             load_program.load(result.time).value(),
                             result.depth,
                             result.force,
                             result.time,
                             cycle},
                            [this](const double depth) {
                              return displacement_at(depth);
                            });
    if (!error_bound->why_missing().empty())
      return;
    if (parameters.refinement.strategy != RefinementStrategy::kelly)
      error_indicators = error_bound->indicators();
    log.remark("The error of the stresses in equilibrium is at most " +
               Patterns::Tools::to_string(result.estimated_error) +
               (!model.indenter.shape || model.indenter.shape->is_convex() ?
                  "" :
                  ", provided that the sides of the mesh resolve the indenter, "
                  "which is not known to be convex"));
  }



  template class ElastoPlasticContact<2>;
  template class ElastoPlasticContact<3>;
} // namespace ElastoPlastic
