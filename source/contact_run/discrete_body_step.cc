// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// What happens to the body in a load step.

#include "contact_run/contact_problem.h"
#include "contact_run/discrete_body.h"
#include "mesh/body_size.h"

namespace ElastoPlastic
{
  template <int dim>
  void
  DiscreteBody<dim>::begin_step(const double begin,
                                const double end,
                                const Load  &load)
  {
    apply_load(end, load);
    solid_body.begin_step(end - begin);
  }



  // The heart of the program is the primal-dual active set loop. It lives in
  // SemismoothNewton, which treats contact and plasticity as one nonlinear
  // problem; ContactProblem tells it about energy, forces, tangent and active
  // set. What remains to be done here is a good first guess of the active set:
  // all nodes that the starting displacement brings to the indenter.
  template <int dim>
  void
  DiscreteBody<dim>::find_equilibrium(const SemismoothNewton &newton,
                                      const LastStep         &last,
                                      SolveResult            &result)
  {
    TimerOutput::Scope scope(timer, "Nonlinear solver");
    contact_set.begin_step(last.is_virgin() ? VectorType(u.get_partitioner()) :
                                              last.displacement,
                           last.is_virgin() ? 0. : last.result.depth,
                           sideways_position(result.time) -
                             sideways_position(last.result.time));
    contact_set.activate_touching(u);
    const auto minimise = [&]() {
      const NewtonReport report = solve(newton, last, contact_set, u);
      residual_forces           = report.residual;
      contact_set.settle(u);

      result.newton_iterations += report.n_iterations();
      result.linear_iterations += report.n_linear_iterations();
      result.residual = report.steps.back().residual;
      result.energy   = report.steps.back().energy;
    };
    minimise();
    if (contact_set.find_sticking(u, residual_forces))
      minimise();
  }



  template <int dim>
  VectorType
  DiscreteBody<dim>::displacement_at(const double            depth,
                                     const SemismoothNewton &newton,
                                     const LastStep         &last)
  {
    ContactSet<dim> contact_there(contact_set);
    VectorType      result = u;
    contact_there.set_load({Control::depth, depth});
    contact_there.activate_touching(result);
    solve(newton, last, contact_there, result);
    return result;
  }



  template <int dim>
  NewtonReport
  DiscreteBody<dim>::solve(const SemismoothNewton &newton,
                           const LastStep         &last,
                           ContactSet<dim>        &contact,
                           VectorType             &displacement)
  {
    ContactProblem<dim> problem(solid_body,
                                held,
                                loads,
                                contact,
                                *tangent_solver,
                                1e4 * body_size(mesh),
                                last.largest_forces,
                                timer);
    return newton.solve(problem, displacement);
  }



  template <int dim>
  void
  DiscreteBody<dim>::commit(LastStep &last)
  {
    last.slip = total_slip(last);
    solid_body.commit(u);
    solid_body.predict_flow(u, u);
    last.displacement = u;
    last.forces       = forces_of_stresses();
  }



  template <int dim>
  void
  DiscreteBody<dim>::place_indenter(const double time, const double depth)
  {
    move_indenter(time);
    contact_set.place(depth);
  }
} // namespace ElastoPlastic
