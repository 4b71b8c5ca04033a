// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/rethrow_collectively.h"
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



  template <int dim>
  typename ContactEvaluation<dim>::Vector
  ContactEvaluation<dim>::pressed_areas() const
  {
    Vector       result(u.get_partitioner());
    const bool   moves = contact.bounds.follow_deformation();
    const Vector whole = moves ? contact.faces.areas() : Vector();
    const Vector moved = moves ? contact.faces.moved(u).areas() : Vector();
    for (const Node &node : contact.candidates)
      {
        const unsigned int i = node.index;
        result.local_element(i) =
          moves ? node.area * moved.local_element(i) / whole.local_element(i) :
                  node.area;
      }
    return result;
  }



  template <int dim>
  typename ContactEvaluation<dim>::Vector
  ContactEvaluation<dim>::kinds() const
  {
    Vector result(u.get_partitioner());
    for (const Node &node : contact.candidates)
      result.local_element(node.index) = node.status == ContactStatus::closed ?
                                           ContactFaces<dim>::closed :
                                           ContactFaces<dim>::not_closed;
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
      if (node.is_active())
        result.local_element(node.index) =
          contact.pressing_force(node, u, residual) *
          contact.bounds.inclination(node) / areas.local_element(node.index);
    return result;
  }



  template <int dim>
  typename ContactEvaluation<dim>::Vector
  ContactEvaluation<dim>::touched_areas() const
  {
    if (contact.rule == EdgeRule::at_nodes)
      return areas;
    const std::vector<double> of_candidates = contact.gaps(u, contact.depth());
    Vector                    gaps(u.get_partitioner());
    for (unsigned int k = 0; k < of_candidates.size(); ++k)
      gaps.local_element(contact.candidates[k].index) = of_candidates[k];
    const Vector kinds  = this->kinds();
    const Vector levels = contact.faces.levels(kinds, gaps);
    return contact.bounds.follow_deformation() ?
             contact.faces.moved(u).touched_areas(kinds, levels) :
             contact.faces.touched_areas(kinds, levels);
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
    const std::vector<double> gaps = contact.gaps(u, contact.depth());
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
        if (!node.is_active() || !contact.friction.exists() ||
            node.friction.sticks)
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
      if (node.is_active())
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
    if (contact.has_sloped_bounds())
      rethrow_collectively(contact.communicator, [&]() {
        for (const Node &node : contact.candidates)
          if (node.is_active())
            {
              const auto slope =
                contact.force_law(node, contact.bounds.surface(node, u), u)
                  .value;
              for (unsigned int d = 0; d < dim - 1; ++d)
                forces.local_element(node.horizontal[d]) =
                  slope[d] * residual.local_element(node.index);
            }
      });
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
      if (node.is_active())
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
      if (node.is_active())
        {
          stick.local_element(node.index) = node.friction.sticks ? 1. : 0.;
          const auto   surface            = contact.bounds.surface(node, u);
          const double area               = areas.local_element(node.index) *
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
