// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/exceptions.h"
#include "contact/contact_nodes.h"
#include "contact/contact_set.h"

namespace ElastoPlastic
{
  /// Enough for all digits.
  static constexpr unsigned int n_secant_steps = 20;



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
    filter.reinit(
      dof_handler, constraints, contact_boundaries, kinematics, layout);
    neighbors.clear();
    if (rule != EdgeRule::at_nodes || bounds.follow_deformation())
      {
        faces.reinit(
          dof_handler, constraints, contact_boundaries, kinematics, layout);
        if (rule == EdgeRule::within_faces)
          neighbors = faces.neighbors();
      }
    find_candidates();
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
      if (bounds.reach(node))
        {
          (node.hanging ? hanging_nodes : candidates).push_back(node);
          if (const auto old = before.find(node.index);
              !node.hanging && old != before.end())
            {
              candidates.back()     = old->second;
              candidates.back().gap = node.gap;
            }
        }
    if (rule != EdgeRule::within_faces)
      return;
    std::vector<EdgeLaw::Node> of_law;
    for (const Node &node : candidates)
      of_law.push_back(
        {first_owned_dof + node.index, node.index, node.gap.height, node.area});
    edge_law.reinit(of_law, neighbors, communicator);
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
  std::vector<double>
  ContactSet<dim>::heights(const Vector &u) const
  {
    std::vector<double> result;
    for (const Node &node : candidates)
      result.push_back(bounds.value(node, u) - u.local_element(node.index));
    return result;
  }



  template <int dim>
  std::vector<double>
  ContactSet<dim>::gaps(const Vector &u, const double depth) const
  {
    std::vector<double> result = heights(u);
    for (double &gap : result)
      gap -= depth;
    return result;
  }



  template <int dim>
  std::vector<ContactStatus>
  ContactSet<dim>::statuses() const
  {
    std::vector<ContactStatus> result;
    for (const Node &node : candidates)
      result.push_back(node.status);
    return result;
  }



  template <int dim>
  std::vector<double>
  ContactSet<dim>::forces_inside(const Vector &residual) const
  {
    std::vector<double> forces;
    for (const Node &node : candidates)
      forces.push_back(node.is_active() ?
                         std::max(residual.local_element(node.index), 0.) :
                         0.);
    return law().forces_inside(forces);
  }



  // By the secant method: the distance that is left of the bounds of the closed
  // nodes, on average, falls with the depth, nearly as fast.
  template <int dim>
  double
  ContactSet<dim>::depth_at(const Vector &u) const
  {
    const unsigned int n_closed = this->n_closed();
    if (!is_force_driven() || n_closed == 0)
      return present_depth;
    const std::vector<double> heights  = this->heights(u);
    const auto                statuses = this->statuses();
    const auto                distance = [&](const double depth) {
      std::vector<double> gaps = heights;
      for (double &gap : gaps)
        gap -= depth;
      const auto place = law().place(gaps, statuses);
      double     sum   = 0;
      for (unsigned int k = 0; k < gaps.size(); ++k)
        if (statuses[k] == ContactStatus::closed)
          sum += gaps[k] + place.allowances[k];
      return Utilities::MPI::sum(sum, communicator) / n_closed;
    };
    double largest = 0;
    for (unsigned int k = 0; k < heights.size(); ++k)
      if (statuses[k] == ContactStatus::closed)
        largest = std::max(largest, std::abs(heights[k]));
    largest      = Utilities::MPI::max(largest, communicator);
    double depth = present_depth, left = distance(depth), slope = -1.;
    for (unsigned int i = 0; i < n_secant_steps; ++i)
      {
        const double step = -left / slope;
        const double next = depth + step;
        if (std::abs(step) <= std::numeric_limits<double>::epsilon() *
                                std::max(std::abs(next), largest))
          break;
        const double left_there = distance(next);
        slope = std::clamp((left_there - left) / step, -2., -1.);
        depth = next;
        left  = left_there;
      }
    return depth;
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
      present_depth = n_closed() > 0 ?
                        depth_at(u) :
                        std::min(nearest_distance(candidates, u),
                                 nearest_distance(hanging_nodes, u));
  }



  template <int dim>
  void
  ContactSet<dim>::move_active(Vector &u) const
  {
    move_closed_to(u, present_depth);
  }



  template <int dim>
  void
  ContactSet<dim>::return_to_bounds(Vector &u) const
  {
    move_closed_to(u, depth_at(u));
  }



  // (A node that is as near as the rounding of gap and depth, which may be far
  // larger than u, is at its place.)
  template <int dim>
  void
  ContactSet<dim>::move_closed_to(Vector &u, const double depth) const
  {
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    for (const Node &node : candidates)
      for (unsigned int d = 0; d < dim - 1; ++d)
        if (is_held(node, d))
          u.local_element(node.horizontal[d]) = node.anchor[d];
    const auto place = law().place(gaps(u, depth), statuses());
    for (unsigned int k = 0; k < candidates.size(); ++k)
      if (const Node &node = candidates[k];
          node.status == ContactStatus::closed)
        {
          const double gap = bounds.value(node, u);
          const double rounding =
            4. * epsilon * std::max(std::abs(gap), std::abs(depth));
          const double bound        = gap - depth + place.allowances[k];
          double      &displacement = u.local_element(node.index);
          if (std::abs(displacement - bound) > rounding)
            displacement = bound;
        }
  }



  template <int dim>
  void
  ContactSet<dim>::project(Vector &u) const
  {
    const std::vector<double> gaps  = this->gaps(u, depth_at(u));
    const auto                place = law().largest_openings(gaps);
    for (unsigned int k = 0; k < candidates.size(); ++k)
      u.local_element(candidates[k].index) +=
        std::min(gaps[k] + place.allowances[k], 0.);
  }



  template <int dim>
  SharedForces
  ContactSet<dim>::shared_forces(const Vector &u, const Vector &residual) const
  {
    if (!law().exists())
      return {};
    const auto   statuses = this->statuses();
    const auto   place    = law().place(gaps(u, depth_at(u)), statuses);
    const auto   inside   = forces_inside(residual);
    SharedForces result{law().rows(place, statuses), {}};
    for (unsigned int k = 0; k < candidates.size(); ++k)
      if (statuses[k] == ContactStatus::entering)
        result.entering.push_back(
          {candidates[k].index,
           law().stiffness(k, place.openings.local_element(k)) * inside[k]});
    return result;
  }



  template <int dim>
  std::vector<unsigned int>
  ContactSet<dim>::active_entries() const
  {
    std::vector<unsigned int> entries;
    for (const Node &node : candidates)
      if (node.is_active())
        entries.push_back(node.index);
    return entries;
  }



  template <int dim>
  std::vector<unsigned int>
  ContactSet<dim>::closed_entries() const
  {
    std::vector<unsigned int> entries;
    for (const Node &node : candidates)
      if (node.status == ContactStatus::closed)
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
} // namespace ElastoPlastic

// The rest of the class, which is compiled and instantiated as a whole:
#include "contact_set_friction.cc"
#include "contact_set_state.cc"
#include "contact_set_update.cc"

namespace ElastoPlastic
{
  template class ContactSet<2>;
  template class ContactSet<3>;
} // namespace ElastoPlastic
