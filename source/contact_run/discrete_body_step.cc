// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// What happens to the body in a load step.

#include <cmath>

#include "contact_run/contact_problem.h"
#include "contact_run/discrete_body.h"
#include "mechanics/stretched_field.h"
#include "mesh/body_size.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Beyond that the last step says nothing about the next.
    constexpr double largest_growth = 3.;

    /// By what factor the contact with a convex @p indenter grows from one
    /// @p depth to the @p next if it keeps its shape: by that of the indenter
    /// where the undeformed surface cuts it. 1 if it does not grow, and
    /// largest_growth at most.
    template <int dim>
    double
    growth_of_contact(const PlacedIndenter<dim> &indenter,
                      const double               depth,
                      const double               next)
    {
      const double tip = depth - indenter.initial_gap;
      if (!indenter.shape || !indenter.shape->is_convex() || !(tip > 0.) ||
          !(next > depth))
        return 1.;
      const double area = indenter.shape->section_area(tip);
      return area > 0. ? std::min(largest_growth,
                                  std::sqrt(indenter.shape->section_area(
                                              tip + next - depth) /
                                            area)) :
                         1.;
    }
  } // namespace



  template <int dim>
  void
  DiscreteBody<dim>::begin_step(const double begin,
                                const double end,
                                const Load  &load)
  {
    apply_load(end, load);
    solid_body.begin_step(end - begin);
  }



  template <int dim>
  void
  DiscreteBody<dim>::go_on(const LastStep &last, const double duration)
  {
    solid_body.go_on(duration, last.duration);
  }



  // The rates of a contact that grows are those at the places that have been
  // where things are now, seen from its edge (doc/theory, "Load histories").
  template <int dim>
  void
  DiscreteBody<dim>::extrapolate(const LastStep &last, const double duration)
  {
    TimerOutput::Scope scope(timer, "Prediction");
    if (contact_set.is_force_driven())
      contact_set.place(last.result.depth + duration * last.depth_rate);
    const auto way = sideways_position(last.result.time + duration) -
                     sideways_position(last.result.time);
    const double growth = way.norm() == 0. ?
                            growth_of_contact(model.indenter,
                                              last.result.depth,
                                              contact_set.depth()) :
                            1.;
    if (growth == 1.)
      {
        u.add(duration, last.displacement_rate);
        return;
      }
    Point<dim> centre;
    for (unsigned int d = 0; d < dim - 1; ++d)
      centre[d] = gap.position()[d];
    centre[dim - 1] = gap.value(centre) - model.indenter.initial_gap;
    u.add(duration,
          stretched_field(last.displacement_rate,
                          growth,
                          centre,
                          unknowns,
                          held.constraints()));
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
  DiscreteBody<dim>::return_to(const LastStep &last)
  {
    if (last.is_virgin())
      u = 0.;
    else
      u = last.displacement;
    solid_body.begin_step(0.);
    solid_body.predict_flow(u, u);
    contact_set.deactivate_all();
    place_indenter(last.result.time, last.result.depth);
    contact_set.begin_step(u, last.result.depth, {});
    contact_set.activate_touching(u);
  }



  template <int dim>
  void
  DiscreteBody<dim>::drop_forces_without_support()
  {
    VectorType can_be_held;
    solid_body.initialize_vector(can_be_held);
    held.set_fixed_entries(can_be_held, 1.);
    for (const unsigned int i : contact_set.force_entries())
      can_be_held.local_element(i) = 1.;

    solid_body.internal_forces(residual_forces, u);
    residual_forces.sadd(-1., 1., loads);
    residual_forces.scale(can_be_held);
  }



  template <int dim>
  void
  DiscreteBody<dim>::place_indenter(const double time, const double depth)
  {
    move_indenter(time);
    contact_set.place(depth);
  }
} // namespace ElastoPlastic
