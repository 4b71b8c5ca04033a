// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "contact_problem.h"

namespace ElastoPlastic
{
  template <int dim>
  ContactProblem<dim>::ContactProblem(SolidOperator<dim>  &solid,
                                      const Supports<dim> &supports,
                                      const Vector        &external_forces,
                                      ContactSet<dim>     &contact,
                                      TangentSolver<dim>  &tangent_solver,
                                      TimerOutput         &timer)
    : solid(solid)
    , supports(supports)
    , external_forces(external_forces)
    , contact(contact)
    , tangent_solver(tangent_solver)
    , timer(timer)
  {}



  template <int dim>
  void
  ContactProblem<dim>::initialize_vector(Vector &vector) const
  {
    solid.initialize_vector(vector);
  }



  template <int dim>
  double
  ContactProblem<dim>::energy(const Vector &u) const
  {
    TimerOutput::Scope scope(timer, "Newton: energy");
    return solid.energy(u) - external_forces * u;
  }



  template <int dim>
  void
  ContactProblem<dim>::compute_residual(Vector &residual, const Vector &u) const
  {
    TimerOutput::Scope scope(timer, "Newton: residual");
    solid.internal_forces(residual, u);
    residual.sadd(-1., 1., external_forces);
  }



  template <int dim>
  void
  ContactProblem<dim>::linearize(const Vector &u)
  {
    TimerOutput::Scope scope(timer, "Newton: linearize");
    solid.linearize(u);
  }



  template <int dim>
  void
  ContactProblem<dim>::step_taken(const Vector &from, const Vector &to)
  {
    TimerOutput::Scope scope(timer, "Newton: linearize");
    solid.predict_flow(from, to);
  }



  template <int dim>
  void
  ContactProblem<dim>::apply_tangent(Vector       &result,
                                     const Vector &increment) const
  {
    solid.vmult(result, increment);
  }



  template <int dim>
  unsigned int
  ContactProblem<dim>::solve_tangent(Vector       &increment,
                                     const Vector &rhs,
                                     const double  reduction)
  {
    increment = 0;
    if (rhs.l2_norm() == 0.)
      return 0;

    Vector held;
    initialize_vector(held);
    supports.set_fixed_entries(held, 1.);
    contact.set_active_entries(held, 1.);
    {
      TimerOutput::Scope scope(timer, "Newton: prepare linear solver");
      tangent_solver.prepare(solid, held);
    }
    TimerOutput::Scope scope(timer, "Newton: solve linear system");
    const unsigned int n_iterations =
      tangent_solver.solve(increment, rhs, reduction);
    zero_held(increment);
    distribute(increment);
    return n_iterations;
  }



  template <int dim>
  void
  ContactProblem<dim>::tangent_diagonal(Vector &diagonal) const
  {
    solid.diagonal(diagonal);
  }



  template <int dim>
  bool
  ContactProblem<dim>::update_active_set(const Vector &u,
                                         const Vector &residual)
  {
    return contact.update(u, residual);
  }



  template <int dim>
  bool
  ContactProblem<dim>::update_feasible_active_set(const Vector &u,
                                                  const Vector &residual)
  {
    return contact.update_feasible(u, residual);
  }



  template <int dim>
  std::uint64_t
  ContactProblem<dim>::active_set_fingerprint() const
  {
    return contact.fingerprint();
  }



  template <int dim>
  unsigned int
  ContactProblem<dim>::n_active() const
  {
    return contact.n_active();
  }



  template <int dim>
  void
  ContactProblem<dim>::move_held(Vector &u) const
  {
    supports.move_fixed(u);
    contact.move_active(u);
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
  ContactProblem<dim>::zero_held(Vector &vector) const
  {
    supports.set_fixed_entries(vector, 0.);
    contact.set_active_entries(vector, 0.);
  }



  template <int dim>
  void
  ContactProblem<dim>::distribute(Vector &u) const
  {
    supports.constraints().distribute(u);
  }



  template class ContactProblem<2>;
  template class ContactProblem<3>;
} // namespace ElastoPlastic
