// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// What the iterations of a load step begin with: the last equilibrium, and how
// it changed on the way there.

#include "contact_run/discrete_body.h"
#include "mechanics/stretched_field.h"

namespace ElastoPlastic
{
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
    const double growth =
      way.norm() == 0. ? model.indenter.growth_of_contact(last.result.depth,
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
} // namespace ElastoPlastic
