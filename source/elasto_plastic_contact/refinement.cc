// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/distributed/solution_transfer.h>

#include "elasto_plastic_contact.h"
#include "mechanics/ghosted_copy.h"
#include "mechanics/state_transfer.h"

namespace ElastoPlastic
{
  // The mesh is adapted in the first load step: in cycles, and until its
  // elements are small enough for the contact. (Not with finite strains: a
  // step, however short, would press many virgin elements of such a mesh at
  // once. There, refinement follows from step to step.)
  template <int dim>
  bool
  ElastoPlasticContact<dim>::mark_next_mesh()
  {
    if (time_steps.number() > 1)
      return false;

    clear_flags(triangulation);
    const bool is_next_cycle = cycle + 1 < parameters.refinement.n_cycles;
    if (is_next_cycle)
      flag_cells(parameters.refinement, error_indicators, triangulation);
    const bool follows_contact =
      !model.strain_model.is_finite() && mark_contact_zone();
    if (!follows_contact && !is_next_cycle)
      return false;
    if (next_mesh_is_allowed())
      return true;
    log.remark(
      "The next mesh would have more unknowns than "
      "'Refinement/Maximum number of unknowns' allows.");
    return false;
  }



  // What the next mesh would need is known only when it is there, when there is
  // no way back; but a new cell hardly ever brings fewer unknowns than it has
  // in the interior of a mesh.
  template <int dim>
  bool
  ElastoPlasticContact<dim>::next_mesh_is_allowed() const
  {
    const double n_new_cells =
      n_cells_after_refinement(triangulation) -
      static_cast<double>(triangulation.n_global_active_cells());
    return parameters.refinement.allows(dof_handler.n_dofs() +
                                        estimated_unknowns(n_new_cells, fe));
  }



  // Around the contact, as it is and as it will be soon: when some cells are
  // too large, others are refined at the same time, so that the next steps can
  // do with that mesh. Cells of the first mesh stay. Where the errors of the
  // solution decide, too, they do not coarsen that zone; nor does an indenter
  // that moves sideways coarsen its groove.
  template <int dim>
  bool
  ElastoPlasticContact<dim>::mark_contact_zone()
  {
    const unsigned int n_over_radius =
      parameters.refinement.n_over_contact_radius;
    if (n_over_radius == 0)
      return false;
    const ContactZone<dim> zone        = contact_zone();
    const auto             sizes_after = [&](const double growth) {
      return [&zone, n_over_radius, growth](const Point<dim> &x,
                                            const double      reach) {
        return zone.element_size(x, reach, n_over_radius, growth);
      };
    };
    const bool coarsens =
      parameters.refinement.strategy == RefinementStrategy::none &&
      load_program.path().is_at_rest();
    return (adaptation_is_due() ||
            has_larger_cells<dim>(sizes_after(0.05), triangulation)) &&
           flag_larger_cells<dim>(sizes_after(0.2),
                                  coarsens ?
                                    std::make_optional(finest_first_level) :
                                    std::nullopt,
                                  triangulation);
  }



  // The next mesh, and on it the interpolated solution as the starting guess,
  // and the states of the material points, unless they are virgin. What is no
  // longer needed makes room for what comes: the levels of the old mesh, and
  // the values in transfer as soon as there are unknowns for them.
  template <int dim>
  void
  ElastoPlasticContact<dim>::refine_mesh()
  {
    ++cycle;
    tangent_solver.reset();
    const bool                is_virgin = last_step.is_virgin();
    EdgeMemory                edge      = contact.edge_memory();
    std::vector<VectorType *> fields    = {&displacement};
    if (!is_virgin)
      for (VectorType *field : {&last_step.displacement_rate, &last_step.slip})
        fields.push_back(field);
    if (edge.n_steps > 0)
      for (VectorType &distances : edge.distances)
        {
          supports.hanging_nodes().distribute(distances);
          fields.push_back(&distances);
        }

    const GhostedCopies<dim> old_fields(fields, dof_handler);
    parallel::distributed::SolutionTransfer<dim, VectorType> transfer(
      dof_handler);
    transfer.prepare_for_coarsening_and_refinement(old_fields.pointers());
    const CellStates   states = is_virgin ? CellStates() : solid->states();
    StateTransfer<dim> state_transfer(triangulation,
                                      fe.degree,
                                      model.materials.size());
    if (!is_virgin)
      state_transfer.prepare(states);
    {
      TimerOutput::Scope scope(timer, "Refine mesh");
      triangulation.execute_coarsening_and_refinement();
    }

    setup_body();
    for (VectorType *field : fields)
      solid->initialize_vector(*field);
    transfer.interpolate(fields);
    for (VectorType *field : fields)
      supports.constraints().distribute(*field);
    if (!is_virgin)
      solid->set_states(state_transfer.take());
    setup_contact();
    if (edge.n_steps > 0)
      contact.edge_memory().take_over(edge);
  }



  // As it unloads, the contact stays on the mesh that its largest area has
  // asked for; the stiffness of an unloading is that of one mesh. It moves
  // sideways over a mesh that keeps what it has left behind.
  template <int dim>
  bool
  ElastoPlasticContact<dim>::mark_adapted_mesh()
  {
    const bool is_due =
      adaptation_is_due() &&
      flag_cells_within(static_cast<double>(dof_handler.n_dofs()) /
                          triangulation.n_global_active_cells(),
                        parameters.refinement,
                        error_indicators,
                        triangulation);
    if (!is_due)
      clear_flags(triangulation);
    const bool outgrows_mesh =
      !load_program.is_segment_end(last_step.result.time) &&
      (last_step.result.contact_area >= largest_contact_area ||
       !load_program.path().is_at_rest()) &&
      mark_contact_zone();
    return outgrows_mesh ? next_mesh_is_allowed() : is_due;
  }



  template <int dim>
  bool
  ElastoPlasticContact<dim>::adaptation_is_due() const
  {
    const unsigned int interval = parameters.refinement.adaptation_interval;
    return interval > 0 && time_steps.number() % interval == 0;
  }



  // In a history, the mesh may follow the contact. On the new one, the
  // interpolated state is not in equilibrium, nor are all its stresses
  // admissible: the solution under the same load is both, and the difference
  // is what the change of the mesh has cost. A finer mesh may not bear the
  // load, though; then the next step, which can be cut, has to find the next
  // equilibrium.
  template <int dim>
  void
  ElastoPlasticContact<dim>::adapt_mesh(Statistics &statistics)
  {
    if (!mark_adapted_mesh())
      return;

    refine_mesh();
    contact.place(last_step.result.depth);
    contact.begin_step(displacement, {});
    contact.activate_touching(displacement);
    contact.divide_edge(last_step.result.depth);
    solid->predict_flow(displacement, displacement);
    last_step.displacement = displacement;
    try
      {
        equilibrate_adapted_mesh(statistics);
      }
    catch (const ConvergenceError &error)
      {
        log.warn(
          "No equilibrium has been found on the adapted mesh under "
          "the load of step " +
          std::to_string(last_step.result.step) +
          "; the next step begins with the interpolated state. " +
          error.what());
        commit_interpolated_state();
      }
  }



  // Of its nodal forces, only those count that hold the body; the others are
  // what it lacks for an equilibrium, and do no work.
  template <int dim>
  void
  ElastoPlasticContact<dim>::commit_interpolated_state()
  {
    take_back_step();
    VectorType held;
    solid->initialize_vector(held);
    supports.set_fixed_entries(held, 1.);
    for (const unsigned int i : contact.force_entries())
      held.local_element(i) = 1.;

    solid->internal_forces(residual, displacement);
    residual.sadd(-1., 1., external_forces);
    residual.scale(held);
    last_step.forces = forces_of_stresses();
  }



  template <int dim>
  void
  ElastoPlasticContact<dim>::equilibrate_adapted_mesh(Statistics &statistics)
  {
    SolveResult result = solve();
    statistics.add_solve(result);
    statistics.add_mesh_change(last_step.result, result);
    if (last_step.result.contact_area >= largest_contact_area)
      largest_contact_area = result.contact_area;

    result.plastic_work           = 0;
    result.dissipation            = 0;
    result.frictional_dissipation = 0;
    last_step.add_to(result);
    last_step.result = result;
    load_program.reached(result.time, result.depth, result.force);
    commit_state();
  }



  template class ElastoPlasticContact<2>;
  template class ElastoPlasticContact<3>;
} // namespace ElastoPlastic
