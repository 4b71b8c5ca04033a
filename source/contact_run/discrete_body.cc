// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/fe/fe_q.h>

#include <algorithm>

#include "base/compatibility.h"
#include "base/ghost_values.h"
#include "contact_run/discrete_body.h"
#include "loads/loaded_body.h"
#include "mechanics/state_transfer.h"
#include "multigrid/make_tangent_solver.h"

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
  } // namespace



  // In the order in which the problem is described: first the body, then what
  // holds it, then what presses on it.
  template <int dim>
  DiscreteBody<dim>::DiscreteBody(const Model<dim>             &model,
                                  const LinearSolverParameters &linear_solver,
                                  const MPI_Comm                communicator,
                                  Log                          &log,
                                  TimerOutput                  &timer)
    : model(model)
    , fe(FE_Q<dim>(model.degree), dim)
    , mesh(communicator)
    , gap(make_mesh_and_place_indenter(model, mesh))
    , unknowns(mesh)
    , held(model)
    , solid_body(model.degree, model.strain_model, model.materials)
    , contact_set(make_contact_bounds(model, gap, mesh),
                  model.strain_model.kinematics,
                  model.contact.edge,
                  CoulombFriction<dim>(model.contact.friction_coefficient(),
                                       largest_shear_modulus(model.materials)))
    , linear_solver(linear_solver)
    , log(log)
    , timer(timer)
  {}



  template <int dim>
  void
  DiscreteBody<dim>::reinit(const double time, const Load &load)
  {
    tangent_solver.reset();
    reinit_unknowns(time);
    reinit_contact(time, load);
  }



  // First unknowns, supports and the body.
  template <int dim>
  void
  DiscreteBody<dim>::reinit_unknowns(const double time)
  {
    TimerOutput::Scope scope(timer, "Setup");

    unknowns.distribute_dofs(fe);
    held.reinit(unknowns, time);
    solid_body.reinit(unknowns, held.constraints());
    solid_body.initialize_vector(u);
  }



  // Then external forces, contact candidates and the linear solver.
  template <int dim>
  void
  DiscreteBody<dim>::reinit_contact(const double time, const Load &load)
  {
    TimerOutput::Scope scope(timer, "Setup");

    solid_body.initialize_vector(residual_forces);
    contact_set.reinit(unknowns,
                       held.constraints(),
                       contact_boundaries(),
                       held.fixed_dofs(),
                       residual_forces);
    apply_load(time, load);

    tangent_solver = make_tangent_solver(linear_solver,
                                         model,
                                         solid_body,
                                         unknowns,
                                         held.constraints(),
                                         [this](const std::string &warning) {
                                           log.warn(warning);
                                         });
    indicators.reinit(mesh.n_active_cells());
    set_initial_stress();
  }



  // What is no longer needed makes room for what comes: the levels of the old
  // mesh, and the values in transfer as soon as there are unknowns for them.
  // Virgin material has no states to transfer; the initial stress is found
  // anew, for a body that has no past.
  template <int dim>
  void
  DiscreteBody<dim>::refine(const double time, const Load &load, LastStep &last)
  {
    tangent_solver.reset();
    const bool                is_virgin = last.is_virgin();
    std::vector<VectorType *> fields    = {&u};
    if (!is_virgin)
      for (VectorType *field : {&last.displacement_rate, &last.slip})
        fields.push_back(field);

    const GhostedCopies<dim>                     old_fields(fields, unknowns);
    DistributedSolutionTransfer<dim, VectorType> transfer(unknowns);
    transfer.prepare_for_coarsening_and_refinement(old_fields.pointers());
    const CellStates   states = is_virgin ? CellStates() : solid_body.states();
    StateTransfer<dim> state_transfer(mesh, fe.degree, model.materials.size());
    if (!is_virgin)
      state_transfer.prepare(states);
    {
      TimerOutput::Scope scope(timer, "Refine mesh");
      mesh.execute_coarsening_and_refinement();
    }

    reinit_unknowns(time);
    for (VectorType *field : fields)
      solid_body.initialize_vector(*field);
    transfer.interpolate(fields);
    for (VectorType *field : fields)
      held.constraints().distribute(*field);
    reinit_contact(time, load);
    if (!is_virgin)
      solid_body.set_states(state_transfer.take());
  }



  template <int dim>
  void
  DiscreteBody<dim>::apply_load(const double time, const Load &load)
  {
    held.set_time(time);
    loads = external_forces_at(time);
    move_indenter(time);
    contact_set.set_load(load);
  }



  template <int dim>
  void
  DiscreteBody<dim>::move_indenter(const double time)
  {
    if (model.load_program.path().is_at_rest())
      return;
    gap.move_to(sideways_position(time));
    contact_set.follow_indenter();
  }



  template <int dim>
  Tensor<1, dim - 1>
  DiscreteBody<dim>::sideways_position(const double time) const
  {
    const Tensor<1, 2> motion = model.load_program.path().displacement(time);
    Tensor<1, dim - 1> result;
    for (unsigned int d = 0; d < dim - 1; ++d)
      result[d] = motion[d];
    return result;
  }



  template <int dim>
  VectorType
  DiscreteBody<dim>::external_forces_at(const double time) const
  {
    VectorType forces;
    solid_body.initialize_vector(forces);
    compute_external_forces(forces, unknowns, held.constraints(), model, time);
    return forces;
  }



  template <int dim>
  VectorType
  DiscreteBody<dim>::forces_of_stresses() const
  {
    VectorType forces = loads;
    forces -= residual_forces;
    return forces;
  }



  template <int dim>
  VectorType
  DiscreteBody<dim>::total_slip(const LastStep &last) const
  {
    VectorType slip = contact_evaluation().slip();
    if (!last.is_virgin())
      slip += last.slip;
    return slip;
  }



  template <int dim>
  ContactSurface<dim>
  DiscreteBody<dim>::contact_surface() const
  {
    return ContactSurface<dim>(unknowns,
                               contact_boundaries(),
                               surface_fields(unknowns,
                                              held.constraints(),
                                              contact_set,
                                              u,
                                              residual_forces));
  }



  template <int dim>
  ContactZone<dim>
  DiscreteBody<dim>::contact_zone() const
  {
    return ContactZone<dim>(unknowns,
                            held.hanging_nodes(),
                            held.fixed_dofs(),
                            contact_boundaries(),
                            contact_set,
                            u,
                            residual_forces);
  }
} // namespace ElastoPlastic

// The rest of the class, which is compiled and instantiated as a whole:
#include "discrete_body_checkpoint.cc"
#include "discrete_body_initial_stress.cc"
#include "discrete_body_start.cc"
#include "discrete_body_step.cc"

namespace ElastoPlastic
{
  template class DiscreteBody<2>;
  template class DiscreteBody<3>;
} // namespace ElastoPlastic
