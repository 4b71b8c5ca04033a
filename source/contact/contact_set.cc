// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/rethrow_collectively.h"
#include "contact/contact_nodes.h"
#include "contact/contact_set.h"

namespace ElastoPlastic
{
  template <int dim>
  ContactSet<dim>::ContactSet(const ContactBounds<dim>   &bounds,
                              const Kinematics            kinematics,
                              const EdgeRule              rule,
                              const CoulombFriction<dim> &friction)
    : bounds(bounds)
    , kinematics(kinematics)
    , rule(rule)
    , friction(friction)
    , communicator(MPI_COMM_SELF)
  {}



  template <int dim>
  void
  ContactSet<dim>::reinit(
    const DoFHandler<dim>              &dof_handler,
    const AffineConstraints<double>    &constraints,
    const std::set<types::boundary_id> &contact_boundaries,
    const IndexSet                     &supported_dofs,
    const Vector                       &layout)
  {
    communicator    = layout.get_mpi_communicator();
    first_owned_dof = layout.get_partitioner()->local_range().first;
    nodes.clear();
    candidates.clear();
    for (const ContactNode<dim> &found : find_contact_nodes<dim>(
           dof_handler,
           constraints,
           contact_boundaries,
           [this](const Point<dim> &x) { return bounds.undeformed_gap(x); },
           kinematics,
           layout))
      if (!supported_dofs.is_element(first_owned_dof + found.index))
        {
          Node node;
          static_cast<ContactNode<dim> &>(node) = found;
          for (unsigned int d = 0; d < dim - 1; ++d)
            {
              const auto dof = first_owned_dof + found.horizontal[d];
              node.free[d]   = !supported_dofs.is_element(dof) &&
                             !constraints.is_constrained(dof);
            }
          nodes.push_back(node);
        }
    find_candidates();
    unite_edge();
    if (rule == EdgeRule::at_nodes && !bounds.follow_deformation())
      return;
    edge.reinit(
      dof_handler, constraints, contact_boundaries, kinematics, layout);
  }



  template <int dim>
  void
  ContactSet<dim>::find_candidates()
  {
    std::map<unsigned int, Node> before;
    for (const Node &node : candidates)
      before[node.index] = node;
    candidates.clear();
    hanging_nodes.clear();
    for (const Node &node : nodes)
      if (std::isfinite(node.gap.height))
        {
          (node.hanging ? hanging_nodes : candidates).push_back(node);
          if (const auto old = before.find(node.index);
              !node.hanging && old != before.end())
            {
              candidates.back()     = old->second;
              candidates.back().gap = node.gap;
            }
        }
  }



  template <int dim>
  void
  ContactSet<dim>::follow_indenter()
  {
    rethrow_collectively(communicator, [&]() {
      for (Node &node : nodes)
        node.gap = bounds.undeformed_gap(node.position);
    });
    find_candidates();
  }



  template <int dim>
  void
  ContactSet<dim>::set_load(const Load &load)
  {
    given_force.reset();
    if (load.control == Control::force)
      given_force = load.value;
    else
      place(load.value);
  }



  template <int dim>
  void
  ContactSet<dim>::place(const double depth)
  {
    present_depth = depth;
  }



  template <int dim>
  double
  ContactSet<dim>::depth_at(const Vector &u) const
  {
    if (!is_force_driven())
      return present_depth;
    if (n_active() == 0)
      return present_depth;
    // the rows are linear in the depth: so are their sums
    const Vector at_zero = shared_gaps(u, 0.), at_one = shared_gaps(u, 1.);
    double       sum = 0, slope = 0;
    for (const Node &node : candidates)
      if (node.active)
        {
          const unsigned int i = node.index;
          sum +=
            bounds.value(node, u) - u.local_element(i) + shift(at_zero, node);
          slope += 1. + shift(at_zero, node) - shift(at_one, node);
        }
    return Utilities::MPI::sum(sum, communicator) /
           Utilities::MPI::sum(slope, communicator);
  }



  template <int dim>
  double
  ContactSet<dim>::nearest_distance(const std::vector<Node> &some,
                                    const Vector            &u) const
  {
    double distance = std::numeric_limits<double>::infinity();
    for (const Node &node : some)
      if (!node.hanging || node.without_area)
        distance =
          std::min(distance,
                   bounds.value(node, u) - u.local_element(node.index));
    return Utilities::MPI::min(distance, communicator);
  }



  template <int dim>
  void
  ContactSet<dim>::settle(const Vector &u)
  {
    if (is_force_driven())
      present_depth = n_active() > 0 ?
                        depth_at(u) :
                        std::min(nearest_distance(candidates, u),
                                 nearest_distance(hanging_nodes, u));
  }



  template <int dim>
  bool
  ContactSet<dim>::find_contact(const Vector &u)
  {
    if (force() == 0. || n_active() > 0)
      return false;
    present_depth = nearest_distance(candidates, u);
    return set_active(u, [&](const Node &node) {
      return bounds.value(node, u) - u.local_element(node.index) <=
             present_depth;
    });
  }



  template <int dim>
  template <typename Predicate>
  bool
  ContactSet<dim>::set_active(const Vector &u, const Predicate &is_active)
  {
    bool changed = false;
    for (Node &node : candidates)
      {
        const bool active = presses() && is_active(node);
        if (active == node.active)
          continue;
        changed     = true;
        node.active = active;
        if (active)
          begin_friction(node, u);
      }
    changed = Utilities::MPI::logical_or(changed, communicator);
    if (changed)
      share_rows();
    return changed;
  }



  template <int dim>
  double
  ContactSet<dim>::bound(const Node &node, const Vector &u) const
  {
    return bounds.value(node, u) - present_depth;
  }



  template <int dim>
  void
  ContactSet<dim>::activate_touching(const Vector &u)
  {
    const double contact_tolerance = 1e-8 * std::abs(present_depth);
    const Vector shared            = shared_gaps(u, present_depth);
    set_active(u, [&](const Node &node) {
      return node.active ||
             u.local_element(node.index) >=
               bound(node, u) + shift(shared, node) - contact_tolerance;
    });
    find_contact(u);
  }



  template <int dim>
  void
  ContactSet<dim>::deactivate_all()
  {
    set_active(Vector(), [](const Node &) { return false; });
  }



  template <int dim>
  bool
  ContactSet<dim>::update(const Vector &u, const Vector &residual)
  {
    present_depth        = depth_at(u);
    const Vector shared  = shared_gaps(u, present_depth);
    const bool   turned  = update_friction(u, residual);
    const bool   changed = set_active(u, [&](const Node &node) {
      return node.active ? pressing_force(node, u, residual) > 0 :
                             u.local_element(node.index) >
                             bound(node, u) + shift(shared, node);
    });
    return find_contact(u) || changed || turned;
  }



  // (Nodes that have moved together differ in the last digits.)
  template <int dim>
  bool
  ContactSet<dim>::update_feasible(const Vector &u, const Vector &residual)
  {
    present_depth         = depth_at(u);
    const double rounding = 1e-13 * std::abs(present_depth);
    const bool   changed  = set_active(u, [&](const Node &node) {
      return u.local_element(node.index) >= bound(node, u) - rounding &&
             residual.local_element(node.index) > 0;
    });
    return find_contact(u) || changed;
  }



  template <int dim>
  void
  ContactSet<dim>::move_active(Vector &u) const
  {
    move_active_to(u, present_depth);
  }



  template <int dim>
  void
  ContactSet<dim>::return_to_bounds(Vector &u) const
  {
    move_active_to(u, depth_at(u));
  }



  // (A node that is as near as the rounding of gap and depth, which may be far
  // larger than u, is at its place.)
  template <int dim>
  void
  ContactSet<dim>::move_active_to(Vector &u, const double depth) const
  {
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    const Vector     shared  = shared_gaps(u, depth);
    for (const Node &node : candidates)
      if (node.active)
        {
          for (unsigned int d = 0; d < dim - 1; ++d)
            if (is_held(node, d))
              u.local_element(node.horizontal[d]) = node.anchor[d];
          const double gap = bounds.value(node, u);
          const double rounding =
            4. * epsilon * std::max(std::abs(gap), std::abs(depth));
          const double place        = gap - depth + shift(shared, node);
          double      &displacement = u.local_element(node.index);
          if (std::abs(displacement - place) > rounding)
            displacement = place;
        }
  }



  template <int dim>
  void
  ContactSet<dim>::project(Vector &u) const
  {
    const double depth = depth_at(u);
    for (const Node &node : candidates)
      u.local_element(node.index) =
        std::min(u.local_element(node.index), bounds.value(node, u) - depth);
  }



  template <int dim>
  std::vector<unsigned int>
  ContactSet<dim>::active_entries() const
  {
    std::vector<unsigned int> entries;
    for (const Node &node : candidates)
      if (node.active)
        entries.push_back(node.index);
    return entries;
  }



  template <int dim>
  void
  ContactSet<dim>::set_candidate_entries(Vector      &vector,
                                         const double value) const
  {
    for (const Node &node : candidates)
      vector.local_element(node.index) = value;
  }



  template class ContactSet<2>;
  template class ContactSet<3>;
} // namespace ElastoPlastic
