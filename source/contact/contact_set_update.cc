// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>

#include "contact/contact_set.h"

// Which nodes of ContactSet are closed, entering or open.

namespace ElastoPlastic
{
  template <int dim>
  bool
  ContactSet<dim>::find_contact(const Vector &u)
  {
    if (force() == 0. || n_closed() > 0)
      return false;
    present_depth                     = nearest_distance(candidates, u);
    const std::vector<double> heights = this->heights(u);
    return set_statuses(u, [&](const unsigned int k, const Node &) {
      return heights[k] <= present_depth ? ContactStatus::closed :
                                           ContactStatus::open;
    });
  }



  template <int dim>
  template <typename Status>
  bool
  ContactSet<dim>::set_statuses(const Vector &u, const Status &status)
  {
    bool changed = false;
    for (unsigned int k = 0; k < candidates.size(); ++k)
      {
        Node      &node = candidates[k];
        const auto next = presses() ? status(k, node) : ContactStatus::open;
        if (next == node.status)
          continue;
        const bool was_active = node.is_active();
        changed               = true;
        if (node.status == ContactStatus::closed)
          friction.release(node.friction);
        node.status = next;
        if (node.is_active() && !was_active)
          begin_friction(node, u);
      }
    return Utilities::MPI::logical_or(changed, communicator);
  }



  // (What is closed allows nothing to what is inside.)
  template <int dim>
  void
  ContactSet<dim>::activate_touching(const Vector &u)
  {
    const double              tolerance = 1e-8 * std::abs(present_depth);
    const std::vector<double> gaps      = this->gaps(u, present_depth);
    for (bool changed = true; changed;)
      {
        const auto place = law().place(gaps, statuses());
        changed = set_statuses(u, [&](const unsigned int k, const Node &node) {
          const double distance = gaps[k] + place.allowances[k];
          return node.status == ContactStatus::closed || distance <= tolerance ?
                   ContactStatus::closed :
                   law().status_at(k, distance);
        });
      }
    find_contact(u);
    open_without_closed();
  }



  template <int dim>
  void
  ContactSet<dim>::find_entering(const Vector &u)
  {
    if (!law().exists())
      return;
    const std::vector<double> gaps  = this->gaps(u, depth_at(u));
    const auto                place = law().place(gaps, statuses());
    set_statuses(u, [&](const unsigned int k, const Node &node) {
      return node.status == ContactStatus::closed ?
               ContactStatus::closed :
               law().status_at(k, gaps[k] + place.allowances[k]);
    });
    open_without_closed();
  }



  template <int dim>
  void
  ContactSet<dim>::open_without_closed()
  {
    if (n_closed() == 0)
      deactivate_all();
  }



  template <int dim>
  void
  ContactSet<dim>::rest_law()
  {
    law_rests = true;
    set_statuses(Vector(), [](const unsigned int, const Node &node) {
      return node.status == ContactStatus::closed ? ContactStatus::closed :
                                                    ContactStatus::open;
    });
  }



  template <int dim>
  void
  ContactSet<dim>::wake_law()
  {
    law_rests = false;
  }



  template <int dim>
  void
  ContactSet<dim>::deactivate_all()
  {
    set_statuses(Vector(), [](const unsigned int, const Node &) {
      return ContactStatus::open;
    });
  }



  template <int dim>
  ActiveSetChange
  ContactSet<dim>::update(const Vector      &u,
                          const Vector      &residual,
                          const FrictionPace pace)
  {
    const bool      turned = update_friction(u, residual, pace);
    ActiveSetChange change = update_statuses(u, residual);
    change.friction        = turned;
    return change;
  }



  // The edge jumps over a node that has a part in the forces inside if there
  // are none, or if it becomes closed and nothing inside was.
  template <int dim>
  ActiveSetChange
  ContactSet<dim>::update_statuses(const Vector &u, const Vector &residual)
  {
    present_depth                    = depth_at(u);
    const std::vector<double> gaps   = this->gaps(u, present_depth);
    const auto                place  = law().place(gaps, statuses());
    const std::vector<double> inside = forces_inside(residual);
    std::vector<double>       closed;
    for (const Node &node : candidates)
      closed.push_back(node.status == ContactStatus::closed ? 1. : 0.);
    const std::vector<double> closed_inside = law().forces_inside(closed);
    ActiveSetChange           change;
    change.statuses =
      set_statuses(u, [&](const unsigned int k, const Node &node) {
        const double distance = gaps[k] + place.allowances[k];
        if (node.status != ContactStatus::closed)
          {
            if (distance >= 0.)
              return law().status_at(k, distance);
            change.edge_jumps |= law().has_part(k) && closed_inside[k] == 0.;
            return ContactStatus::closed;
          }
        if (stays_closed(k,
                         pressing_force(node, u, residual),
                         residual.local_element(node.index),
                         inside[k]))
          return ContactStatus::closed;
        change.edge_jumps |= law().has_part(k) && inside[k] == 0.;
        return law().has_part(k) ? ContactStatus::entering :
                                   ContactStatus::open;
      });
    change.edge_jumps =
      Utilities::MPI::logical_or(change.edge_jumps, communicator);
    change.statuses |= find_contact(u);
    open_without_closed();
    return change;
  }



  // (Nodes that have moved together differ in the last digits.)
  template <int dim>
  bool
  ContactSet<dim>::update_feasible(const Vector &u, const Vector &residual)
  {
    present_depth                      = depth_at(u);
    const double              rounding = 1e-13 * std::abs(present_depth);
    const std::vector<double> gaps     = this->gaps(u, present_depth);
    const auto                place    = law().largest_openings(gaps);
    const std::vector<double> inside   = forces_inside(residual);
    const bool                changed =
      set_statuses(u, [&](const unsigned int k, const Node &node) {
        const double distance = gaps[k] + place.allowances[k];
        const double force    = residual.local_element(node.index);
        return distance <= rounding &&
                   stays_closed(k, force, force, inside[k]) ?
                 ContactStatus::closed :
                 law().status_at(k, distance);
      });
    const bool found = find_contact(u);
    open_without_closed();
    return found || changed;
  }
} // namespace ElastoPlastic
