// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/contact_evaluation.h"

namespace ElastoPlastic
{
  template <int dim>
  ContactState
  ContactEvaluation<dim>::state() const
  {
    const MPI_Comm communicator = contact.communicator;
    double         max_pressure = 0;
    double         min_pressure = std::numeric_limits<double>::infinity();
    {
      const Vector pressures = this->pressures();
      for (unsigned int k = 0; k < passed.size(); ++k)
        if (passed[k])
          {
            const double p =
              pressures.local_element(contact.candidates[k].index);
            max_pressure = std::max(max_pressure, p);
            min_pressure = std::min(min_pressure, p);
          }
    }

    ContactState state;
    add_distances(state);
    add_friction(state);
    add_areas(state);
    for (double *const sum : {&state.force,
                              &state.contact_area,
                              &state.complementarity_error,
                              &state.tangential_force[0],
                              &state.tangential_force[1],
                              &state.stick_area,
                              &state.frictional_dissipation})
      *sum = Utilities::MPI::sum(*sum, communicator);
    for (double *const largest : {&state.max_penetration,
                                  &state.edge_penetration,
                                  &state.max_hanging_penetration})
      *largest = Utilities::MPI::max(*largest, communicator);
    state.active_nodes = contact.n_active();
    state.max_pressure = Utilities::MPI::max(max_pressure, communicator);
    if (state.active_nodes > 0)
      state.min_pressure = Utilities::MPI::min(min_pressure, communicator);
    const double scale          = std::abs(state.force * contact.depth());
    state.complementarity_error = state.active_nodes > 0 && scale > 0. ?
                                    state.complementarity_error / scale :
                                    0.;
    return state;
  }



  template <int dim>
  void
  ContactEvaluation<dim>::add_distances(ContactState &state) const
  {
    const auto place = contact.law().place(gaps, contact.statuses());
    for (unsigned int k = 0; k < gaps.size(); ++k)
      {
        const Node  &node     = contact.candidates[k];
        const double force    = residual.local_element(node.index);
        const double distance = gaps[k] + place.allowances[k];
        if (node.is_active())
          state.force += force;
        if (node.status != ContactStatus::entering)
          state.complementarity_error += std::abs(force * distance);
        state.max_penetration  = std::max(state.max_penetration, -distance);
        state.edge_penetration = std::max(state.edge_penetration, -gaps[k]);
      }
    for (const Node &node : contact.hanging_nodes)
      state.max_hanging_penetration =
        std::max(state.max_hanging_penetration,
                 u.local_element(node.index) - contact.bound(node, u));
  }



  template <int dim>
  void
  ContactEvaluation<dim>::add_friction(ContactState &state) const
  {
    const Vector forces = forces_on_body();
    for (const Node &node : contact.candidates)
      {
        const auto force = horizontal_part<dim>(node, forces);
        for (unsigned int d = 0; d < dim - 1; ++d)
          state.tangential_force[d] += force[d];
        if (!node.is_active() || !contact.dissipates() ||
            contact.friction.sticks(node.friction))
          continue;
        const auto surface = contact.bounds.surface(node, u);
        state.frictional_dissipation += tangent_product(
          contact.contact_force(node, surface, residual).tangential,
          contact.slip(node, u),
          surface.slope);
      }
  }



  template <int dim>
  void
  ContactEvaluation<dim>::add_areas(ContactState &state) const
  {
    for (const Node &node : contact.candidates)
      if (node.is_active())
        {
          const double area = touched_areas.local_element(node.index);
          state.contact_area += area;
          if (contact.friction.sticks(node.friction))
            state.stick_area += area;
        }
  }



  template <int dim>
  Point<dim>
  ContactEvaluation<dim>::place_of_largest_pressure() const
  {
    const Vector                  pressures = this->pressures();
    std::pair<double, Point<dim>> largest(0., Point<dim>());
    for (const Node &node : contact.candidates)
      if (const double p = pressures.local_element(node.index);
          p > largest.first)
        largest = {p, node.position};
    for (const auto &of_rank :
         Utilities::MPI::all_gather(contact.communicator, largest))
      if (of_rank.first > largest.first)
        largest = of_rank;
    return largest.second;
  }



  template ContactState
  ContactEvaluation<2>::state() const;
  template ContactState
  ContactEvaluation<3>::state() const;
  template Point<2>
  ContactEvaluation<2>::place_of_largest_pressure() const;
  template Point<3>
  ContactEvaluation<3>::place_of_largest_pressure() const;
} // namespace ElastoPlastic
