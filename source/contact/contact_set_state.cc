// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/contact_set.h"

namespace ElastoPlastic
{
  template <int dim>
  ContactEdge<dim>
  ContactSet<dim>::pressed_faces(const Vector &u) const
  {
    return bounds.follow_deformation() ? edge.faces().moved(u) : edge.faces();
  }



  // A node that shares its row presses on its own part of the touched faces.
  template <int dim>
  typename ContactSet<dim>::Vector
  ContactSet<dim>::pressed_areas(const Vector &u) const
  {
    Vector areas(u.get_partitioner()), ones(u.get_partitioner());
    set_candidate_entries(ones, 1.);
    const Vector sums =
      edge.rows() ? edge.rows()->sums(ones) : Vector(u.get_partitioner());
    const Vector moved =
      bounds.follow_deformation() ? edge.faces().moved(u).areas() : Vector();
    for (const Node &node : candidates)
      {
        const unsigned int i    = node.index;
        double            &area = areas.local_element(i);
        area = edge.own_area(i, sums.local_element(i) > 0., node.area);
        if (bounds.follow_deformation())
          area *=
            moved.local_element(i) / edge.faces().areas().local_element(i);
      }
    return areas;
  }



  // (Vertical forces and projected areas have the same quotient as normal
  // forces and inclined areas.)
  template <int dim>
  typename ContactSet<dim>::Vector
  ContactSet<dim>::pressures(const Vector &u, const Vector &residual) const
  {
    Vector       result(residual.get_partitioner());
    const Vector areas = pressed_areas(u);
    for (const Node &node : candidates)
      if (node.active)
        {
          const unsigned int i    = node.index;
          result.local_element(i) = pressing_force(node, u, residual) *
                                    bounds.inclination(node) /
                                    areas.local_element(i);
        }
    return result;
  }



  // A node that touches with none of its faces as a whole counts like one of a
  // contact that ends at nodes: there is no edge that could be followed.
  template <int dim>
  double
  ContactSet<dim>::touched_area(const Vector &u) const
  {
    double area = 0;
    if (rule == EdgeRule::at_nodes)
      {
        const Vector areas = pressed_areas(u);
        for (const unsigned int i : active_entries())
          area += areas.local_element(i);
        return Utilities::MPI::sum(area, communicator);
      }

    const auto   faces  = pressed_faces(u);
    const Vector kinds  = this->kinds();
    const Vector inside = edge.faces().inside(kinds);
    const auto   part =
      faces.touched_part(kinds,
                         edge.levels(kinds, distances(u, present_depth)));
    Vector ones(u.get_partitioner()), taken_over(u.get_partitioner());
    set_candidate_entries(ones, 1.);
    part.taken_over->vmult(taken_over, ones);
    for (const Node &node : candidates)
      if (node.active)
        {
          const unsigned int i = node.index;
          area += faces.areas().local_element(i) +
                  inside.local_element(i) * (taken_over.local_element(i) -
                                             part.missing.local_element(i));
        }
    return Utilities::MPI::sum(area, communicator);
  }



  template <int dim>
  std::uint64_t
  ContactSet<dim>::fingerprint() const
  {
    std::uint64_t sum = 0;
    for (const Node &node : candidates)
      if (node.active)
        {
          // the splitmix64 finalizer spreads neighbouring indices
          std::uint64_t x = first_owned_dof + node.index + 1;
          x += node.friction.fingerprint() << 40;
          x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
          x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
          sum += x ^ (x >> 31);
        }
    return Utilities::MPI::sum(sum, communicator);
  }



  template <int dim>
  unsigned int
  ContactSet<dim>::n_candidates() const
  {
    return Utilities::MPI::sum(static_cast<unsigned int>(candidates.size()),
                               communicator);
  }



  template <int dim>
  unsigned int
  ContactSet<dim>::n_active() const
  {
    return Utilities::MPI::sum(static_cast<unsigned int>(std::count_if(
                                 candidates.begin(),
                                 candidates.end(),
                                 [](const Node &node) { return node.active; })),
                               communicator);
  }



  template <int dim>
  double
  ContactSet<dim>::min_gap() const
  {
    double smallest = std::numeric_limits<double>::infinity();
    for (const Node &node : candidates)
      smallest = std::min(smallest, node.gap.height);
    return Utilities::MPI::min(smallest, communicator);
  }



  template <int dim>
  ContactState
  ContactSet<dim>::state(const Vector &u, const Vector &residual) const
  {
    const Vector forces    = vertical_forces_on_body(residual);
    const Vector places    = shared_gaps(u, present_depth);
    const Vector pressures = this->pressures(u, residual);

    double force = 0, work = 0, max_penetration = 0, edge_penetration = 0;
    double max_hanging_penetration = 0, max_pressure = 0;
    double min_pressure = std::numeric_limits<double>::infinity();
    for (const Node &node : candidates)
      {
        const unsigned int i           = node.index;
        const double       penetration = u.local_element(i) - bound(node, u);
        force -= forces.local_element(i);
        if (node.active)
          {
            max_pressure = std::max(max_pressure, pressures.local_element(i));
            min_pressure = std::min(min_pressure, pressures.local_element(i));
          }
        work += std::abs(residual.local_element(i) *
                         (shift(places, node) - penetration)) *
                (node.active || forces.local_element(i) == 0. ? 1. : 0.);
        max_penetration =
          std::max(max_penetration, penetration - shift(places, node));
        edge_penetration = std::max(edge_penetration, penetration);
      }
    for (const Node &node : hanging_nodes)
      max_hanging_penetration =
        std::max(max_hanging_penetration,
                 u.local_element(node.index) - bound(node, u));

    ContactState state;
    add_friction(state, u, residual);
    state.force           = Utilities::MPI::sum(force, communicator);
    state.contact_area    = touched_area(u);
    state.active_nodes    = n_active();
    state.max_pressure    = Utilities::MPI::max(max_pressure, communicator);
    state.max_penetration = Utilities::MPI::max(max_penetration, communicator);
    state.edge_penetration =
      Utilities::MPI::max(edge_penetration, communicator);
    state.max_hanging_penetration =
      Utilities::MPI::max(max_hanging_penetration, communicator);
    if (state.active_nodes > 0)
      {
        state.min_pressure = Utilities::MPI::min(min_pressure, communicator);
        const double scale = std::abs(state.force * present_depth);
        if (scale > 0)
          state.complementarity_error =
            Utilities::MPI::sum(work, communicator) / scale;
      }
    return state;
  }



  template <int dim>
  typename ContactSet<dim>::Vector
  ContactSet<dim>::vertical_forces_on_body(const Vector &residual) const
  {
    Vector forces(residual.get_partitioner());
    for (const Node &node : candidates)
      if (node.active)
        forces.local_element(node.index) = -residual.local_element(node.index);
    if (edge.rows())
      forces -= edge.rows()->shares(residual);
    return forces;
  }



  template <int dim>
  typename ContactSet<dim>::Vector
  ContactSet<dim>::forces_on_body(const Vector &u, const Vector &residual) const
  {
    Vector forces = vertical_forces_on_body(residual);
    for (const SlopedBound &bound : sloped_bounds(u, residual))
      for (unsigned int d = 0; d < bound.n_others; ++d)
        forces.local_element(bound.others[d]) =
          bound.force_slope[d] * bound.force;
    for (const unsigned int i : stuck_entries())
      forces.local_element(i) = -residual.local_element(i);
    return forces;
  }



  template <int dim>
  void
  ContactSet<dim>::surface_fields(Vector       &gap,
                                  Vector       &pressure,
                                  Vector       &active,
                                  const Vector &u,
                                  const Vector &residual) const
  {
    for (const auto *const nodes : {&candidates, &hanging_nodes})
      for (const Node &node : *nodes)
        gap.local_element(node.index) =
          bound(node, u) - u.local_element(node.index);
    pressure = pressures(u, residual);
    for (const unsigned int i : active_entries())
      active.local_element(i) = 1.;
  }



  template class ContactSet<2>;
  template class ContactSet<3>;
} // namespace ElastoPlastic
