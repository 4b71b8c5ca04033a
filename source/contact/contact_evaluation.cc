// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "contact/contact_evaluation.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Sets a vector of the tangent plane of a node with this slope.
    template <int dim>
    void
    set_tangent_vector(LinearAlgebra::distributed::Vector<double> &vector,
                       const ContactNode<dim>                     &node,
                       const TangentVector<dim>                   &value,
                       const TangentVector<dim>                   &slope)
    {
      for (unsigned int d = 0; d < dim - 1; ++d)
        vector.local_element(node.horizontal[d]) = value[d];
      vector.local_element(node.index) = slope * value;
    }
  } // namespace



  template <int dim>
  ContactEvaluation<dim>::ContactEvaluation(const ContactSet<dim> &contact,
                                            const Vector          &u,
                                            const Vector          &residual)
    : contact(contact)
    , u(u)
    , residual(residual)
    , areas(pressed_areas())
  {}



  // A node that shares its row presses on its own part of the touched faces.
  template <int dim>
  typename ContactEvaluation<dim>::Vector
  ContactEvaluation<dim>::pressed_areas() const
  {
    const auto &edge = contact.edge;
    Vector      result(u.get_partitioner()), ones(u.get_partitioner());
    contact.set_candidate_entries(ones, 1.);
    const Vector sums =
      edge.rows() ? edge.rows()->sums(ones) : Vector(u.get_partitioner());
    const bool   moves = contact.bounds.follow_deformation();
    const Vector whole = moves ? edge.faces().areas() : Vector();
    const Vector moved = moves ? edge.faces().moved(u).areas() : Vector();
    for (const Node &node : contact.candidates)
      {
        const unsigned int i    = node.index;
        double            &area = result.local_element(i);
        area = edge.own_area(i, sums.local_element(i) > 0., node.area);
        if (moves)
          area *= moved.local_element(i) / whole.local_element(i);
      }
    return result;
  }



  // (Vertical forces and projected areas have the same quotient as normal
  // forces and inclined areas.)
  template <int dim>
  typename ContactEvaluation<dim>::Vector
  ContactEvaluation<dim>::pressures() const
  {
    Vector result(residual.get_partitioner());
    for (const Node &node : contact.candidates)
      if (node.active)
        result.local_element(node.index) =
          contact.pressing_force(node, u, residual) *
          contact.bounds.inclination(node) / areas.local_element(node.index);
    return result;
  }



  // A node that touches with none of its faces as a whole counts like one of a
  // contact that ends at nodes: there is no edge that could be followed.
  template <int dim>
  typename ContactEvaluation<dim>::Vector
  ContactEvaluation<dim>::touched_areas() const
  {
    if (contact.rule == EdgeRule::at_nodes)
      return areas;

    const auto                     &edge = contact.edge;
    std::optional<ContactEdge<dim>> moved;
    if (contact.bounds.follow_deformation())
      moved = edge.faces().moved(u);
    const auto  &faces = moved ? *moved : edge.faces();
    const Vector kinds = contact.kinds();
    const auto   part  = faces.touched_part(
      kinds, edge.levels(kinds, contact.distances(u, contact.depth())));
    const Vector inside = edge.faces().inside(kinds);
    Vector       ones(u.get_partitioner()), taken_over(u.get_partitioner());
    contact.set_candidate_entries(ones, 1.);
    part.taken_over->vmult(taken_over, ones);
    Vector result = faces.areas();
    for (const unsigned int i : contact.active_entries())
      result.local_element(i) +=
        inside.local_element(i) *
        (taken_over.local_element(i) - part.missing.local_element(i));
    return result;
  }



  template <int dim>
  ContactState
  ContactEvaluation<dim>::state() const
  {
    const MPI_Comm communicator = contact.communicator;
    double         max_pressure = 0;
    double         min_pressure = std::numeric_limits<double>::infinity();
    {
      const Vector pressures = this->pressures();
      for (const unsigned int i : contact.active_entries())
        {
          max_pressure = std::max(max_pressure, pressures.local_element(i));
          min_pressure = std::min(min_pressure, pressures.local_element(i));
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
    const Vector forces = contact.vertical_forces_on_body(residual);
    const Vector places = contact.shared_gaps(u, contact.depth());
    for (const Node &node : contact.candidates)
      {
        const unsigned int i      = node.index;
        const double penetration  = u.local_element(i) - contact.bound(node, u);
        const double beyond_bound = penetration - contact.shift(places, node);
        state.force -= forces.local_element(i);
        if (node.active || forces.local_element(i) == 0.)
          state.complementarity_error +=
            std::abs(residual.local_element(i) * beyond_bound);
        state.max_penetration  = std::max(state.max_penetration, beyond_bound);
        state.edge_penetration = std::max(state.edge_penetration, penetration);
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
        if (!node.active || !contact.friction.exists() || node.friction.sticks)
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
    const Vector touched = touched_areas();
    for (const Node &node : contact.candidates)
      if (node.active)
        {
          const double area = touched.local_element(node.index);
          state.contact_area += area;
          if (contact.friction.exists() && node.friction.sticks)
            state.stick_area += area;
        }
  }



  template <int dim>
  typename ContactEvaluation<dim>::Vector
  ContactEvaluation<dim>::forces_on_body() const
  {
    Vector forces = contact.vertical_forces_on_body(residual);
    for (const SlopedBound &bound : contact.sloped_bounds(u, residual))
      for (unsigned int d = 0; d < bound.n_others; ++d)
        forces.local_element(bound.others[d]) =
          bound.force_slope[d] * bound.force;
    for (const unsigned int i : contact.stuck_entries())
      forces.local_element(i) = -residual.local_element(i);
    return forces;
  }



  template <int dim>
  typename ContactEvaluation<dim>::Vector
  ContactEvaluation<dim>::slip() const
  {
    Vector result(u.get_partitioner());
    for (const Node &node : contact.candidates)
      if (node.active)
        set_tangent_vector<dim>(result,
                                node,
                                contact.slip(node, u),
                                contact.bounds.surface(node, u).slope);
    return result;
  }



  template <int dim>
  void
  ContactEvaluation<dim>::surface_fields(Vector &gap,
                                         Vector &pressure,
                                         Vector &active) const
  {
    for (const auto *const nodes :
         {&contact.candidates, &contact.hanging_nodes})
      for (const Node &node : *nodes)
        gap.local_element(node.index) =
          contact.bound(node, u) - u.local_element(node.index);
    pressure = pressures();
    for (const unsigned int i : contact.active_entries())
      active.local_element(i) = 1.;
  }



  template <int dim>
  void
  ContactEvaluation<dim>::friction_fields(Vector &shear, Vector &stick) const
  {
    for (const Node &node : contact.candidates)
      if (node.active)
        {
          stick.local_element(node.index) = node.friction.sticks ? 1. : 0.;
          const auto   surface            = contact.bounds.surface(node, u);
          const double area               = contact.share(node) *
                              areas.local_element(node.index) *
                              std::sqrt(1. + surface.slope * surface.slope) /
                              contact.bounds.inclination(node);
          set_tangent_vector<dim>(
            shear,
            node,
            contact.contact_force(node, surface, residual).tangential / -area,
            surface.slope);
        }
  }



  template class ContactEvaluation<2>;
  template class ContactEvaluation<3>;
} // namespace ElastoPlastic
