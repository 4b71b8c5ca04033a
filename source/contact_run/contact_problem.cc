// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include "base/exceptions.h"
#include "contact_run/contact_problem.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Forces that change the volume are so large in nearly incompressible
    /// bodies that what has been left of them by a mere hundredth would exceed
    /// those that change the shape, and the contact would follow them.
    constexpr double loosest_reduction_if_incompressible = 1e-4;

    /// Where the forces on the free unknowns have fallen to this fraction in
    /// one step, Newton's method converges fast: the tangent is nearly that of
    /// the step before (doc/theory, "Multigrid").
    constexpr double fall_that_keeps_tangents = 0.1;

    /// So many iterations in which nodes have opened or closed are many.
    constexpr unsigned int patience = 5;
  } // namespace



  template <int dim>
  ContactProblem<dim>::ContactProblem(SolidOperator<dim>  &solid,
                                      const Supports<dim> &supports,
                                      const Vector        &external_forces,
                                      ContactSet<dim>     &contact,
                                      TangentSolver       &tangent_solver,
                                      const double         largest_displacement,
                                      const double         largest_forces,
                                      TimerOutput         &timer)
    : solid(solid)
    , supports(supports)
    , external_forces(external_forces)
    , contact(contact)
    , tangent_solver(tangent_solver)
    , largest_displacement(largest_displacement)
    , scale_of_forces(
        std::max(external_forces.l2_norm(),
                 largest_forces / std::sqrt(external_forces.size())))
    , timer(timer)
  {}



  template <int dim>
  void
  ContactProblem<dim>::collect_unknowns(const Vector &u, const Vector &residual)
  {
    std::vector<unsigned int> constrained =
      supports.fixed_entries(external_forces);
    std::vector<unsigned int> coupled;
    if (contact.is_force_driven())
      coupled = contact.closed_entries();
    else
      for (const unsigned int i : contact.closed_entries())
        constrained.push_back(i);
    for (const unsigned int i : contact.stuck_entries())
      constrained.push_back(i);
    unknowns = ReducedUnknowns(constrained,
                               coupled,
                               external_forces.get_mpi_communicator(),
                               contact.shared_forces(u, residual));
    if (contact.has_sloped_bounds())
      unknowns.set_sloped_bounds(contact.sloped_bounds(u, residual));
  }



  template <int dim>
  std::string
  ContactProblem<dim>::obstacle_to_convexity() const
  {
    return contact.has_friction()      ? "friction" :
           contact.has_curved_bounds() ? "finite strains" :
           !solid.is_symmetric() ? "a material with recovering back stresses" :
           !solid.has_energy()   ? "a rate law without a potential" :
                                   "";
  }



  template <int dim>
  Energy
  ContactProblem<dim>::energy(const Vector &u) const
  {
    TimerOutput::Scope scope(timer, "Newton: energy");
    return total_energy(solid.energy(u), u);
  }



  template <int dim>
  Energy
  ContactProblem<dim>::total_energy(const double stored, const Vector &u) const
  {
    const double external_work  = external_forces * u;
    const double indenters_work = contact.force() * contact.depth_at(u);
    return {stored - external_work - indenters_work,
            std::abs(stored) + std::abs(external_work) +
              std::abs(indenters_work)};
  }



  template <int dim>
  Energy
  ContactProblem<dim>::compute_residual(Vector &residual, const Vector &u) const
  {
    TimerOutput::Scope scope(timer, "Newton: residual");
    const double       stored = solid.internal_forces(residual, u);
    residual.sadd(-1., 1., external_forces);
    return total_energy(stored, u);
  }



  // (Which nodes are entering comes first: the energy depends on them where a
  // force drives the indenter.)
  template <int dim>
  Energy
  ContactProblem<dim>::move_to(const Vector &u, Vector &residual)
  {
    contact.find_entering(u);
    const Energy energy = compute_residual(residual, u);
    collect_unknowns(u, residual);
    return energy;
  }



  template <int dim>
  void
  ContactProblem<dim>::linearize(const Vector &u)
  {
    TimerOutput::Scope scope(timer, "Newton: linearize");
    if (start_of_step.size() > 0)
      solid.predict_flow(start_of_step, u);
    start_of_step.reinit(0);
    solid.linearize(u);
  }



  template <int dim>
  void
  ContactProblem<dim>::step_taken(const Vector &from, const Vector &to)
  {
    start_of_step = from;
    if (contact.is_force_driven() &&
        contact.depth_at(to) > largest_displacement)
      throw ConvergenceError(
        "The indenter sinks without end: its depth exceeds the size of the "
        "body by far. Is 'Loading/Force' in the same system of units as the moduli in "
        "'Material', and below the limit load?");
    if (to.linfty_norm() > largest_displacement)
      throw ConvergenceError(
        "The body gives way without end. Are the loads in the same system of "
        "units as the moduli in 'Material', and below what the body can bear?");
  }



  template <int dim>
  unsigned int
  ContactProblem<dim>::solve_tangent(Vector       &increment,
                                     const Vector &rhs,
                                     const double  reduction)
  {
    increment         = 0;
    downward_motion   = 0;
    const double norm = rhs.l2_norm();
    if (norm == 0.)
      return 0;

    {
      TimerOutput::Scope scope(timer, "Newton: prepare linear solver");
      if (norm <= fall_that_keeps_tangents * previous_norm)
        tangent_solver.prepare_for_similar(unknowns);
      else
        tangent_solver.prepare(unknowns);
      previous_norm = norm;
    }
    TimerOutput::Scope scope(timer, "Newton: solve linear system");
    const unsigned int n_iterations =
      tangent_solver.solve(increment,
                           rhs,
                           solid.is_nearly_incompressible() ?
                             std::min(reduction,
                                      loosest_reduction_if_incompressible) :
                             reduction);
    downward_motion =
      unknowns.has_coupling() ? -unknowns.leading_value(increment) : 0.;
    unknowns.expand(increment);
    distribute(increment);
    return n_iterations;
  }



  template <int dim>
  void
  ContactProblem<dim>::apply_inverse_diagonal(Vector &forces) const
  {
    Vector diagonal;
    initialize_vector(diagonal);
    solid.diagonal(diagonal);
    unknowns.contract_diagonal(diagonal);
    for (unsigned int i = 0; i < forces.locally_owned_size(); ++i)
      if (diagonal.local_element(i) > 0)
        forces.local_element(i) /= diagonal.local_element(i);
    unknowns.expand(forces);
  }



  template <int dim>
  bool
  ContactProblem<dim>::update_active_set(const Vector &u,
                                         const Vector &residual)
  {
    ActiveSetChange change = contact.update(u, residual, friction_pace);
    change.statuses |= change_law(u, residual, change);
    collect_unknowns(u, residual);
    return bool(change);
  }



  // The set of a contact that ends at nodes settles in fewer steps where its
  // edge jumps, and is near that of the solution.
  template <int dim>
  bool
  ContactProblem<dim>::change_law(const Vector          &u,
                                  const Vector          &residual,
                                  const ActiveSetChange &change)
  {
    n_changes = change.statuses ? n_changes + 1 : 0;
    if (!law_has_rested)
      {
        law_has_rested = contact.ends_within_faces() &&
                         (change.edge_jumps || n_changes == patience);
        if (!law_has_rested)
          return false;
        n_changes = 0;
        contact.rest_law();
        return true;
      }
    if (!contact.law_is_resting() || (0 < n_changes && n_changes < patience))
      return false;
    contact.wake_law();
    if (n_changes == 0)
      contact.update_statuses(u, residual);
    else
      contact.find_entering(u);
    return true;
  }



  template <int dim>
  bool
  ContactProblem<dim>::update_feasible_active_set(const Vector &u,
                                                  const Vector &residual)
  {
    contact.wake_law();
    const bool changed = contact.update_feasible(u, residual);
    collect_unknowns(u, residual);
    return changed;
  }



  template <int dim>
  void
  ContactProblem<dim>::move_constrained(Vector &u) const
  {
    supports.move_fixed(u);
    contact.move_active(u);
    distribute(u);
  }



  template <int dim>
  void
  ContactProblem<dim>::return_to_bounds(Vector &u) const
  {
    if (!contact.has_curved_bounds() && !contact.ends_within_faces())
      return;
    contact.return_to_bounds(u);
    distribute(u);
  }



  template <int dim>
  void
  ContactProblem<dim>::project(Vector &u) const
  {
    contact.project(u);
    distribute(u);
  }



  template <int dim>
  void
  ContactProblem<dim>::reduce(Vector &residual) const
  {
    unknowns.contract(residual);
    if (unknowns.has_coupling())
      unknowns.set_leading_value(residual,
                                 unknowns.leading_value(residual) -
                                   contact.force());
  }



  template class ContactProblem<2>;
  template class ContactProblem<3>;
} // namespace ElastoPlastic
