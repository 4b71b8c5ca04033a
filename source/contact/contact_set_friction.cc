// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/exceptions.h"
#include "contact/contact_set.h"

// The forces of ContactSet that are not vertical: flanks and friction.

namespace ElastoPlastic
{
  // (With finite coefficients, it is the law that says what sticks. An indenter
  // that moves to the side has done so already: a node was farther from it, by
  // its slope times that way, and has touched it only if it was closed.)
  template <int dim>
  void
  ContactSet<dim>::begin_step(const Vector             &u,
                              const double              depth,
                              const Tensor<1, dim - 1> &motion)
  {
    constexpr double rounding = 1e-8; // of the distance between nodes
    const bool       is_plane = is_plane_problem<dim>(kinematics);

    wake_law();
    const std::vector<double> gaps = this->gaps(u, depth);
    for (unsigned int k = 0; k < candidates.size(); ++k)
      {
        Node        &node    = candidates[k];
        const double spacing = is_plane ? node.area : std::sqrt(node.area);
        const double distance =
          std::max(gaps[k] + bounds.surface(node, u).slope * motion, 0.);
        const bool touches =
          node.status == ContactStatus::closed ||
          (motion.norm() == 0. && distance <= rounding * spacing);
        node.anchor         = horizontal_part<dim>(node, u) + motion;
        node.first_distance = touches ? 0. : distance;
        friction.begin_step(node.friction, touches);
      }
  }



  // While the indenter comes nearer, what it touches when a share of its way is
  // behind it has moved freely by that share of its motion in the step. The
  // farthest of the nodes that it touches is touched last.
  template <int dim>
  bool
  ContactSet<dim>::find_sticking(const Vector &u, const Vector &residual)
  {
    constexpr double rounding = 1e-8;

    if (!friction.exists() || friction.dissipates())
      return false;
    double nearest = std::numeric_limits<double>::infinity(), farthest = 0.;
    for (const Node &node : candidates)
      if (node.status == ContactStatus::closed)
        {
          nearest  = std::min(nearest, node.first_distance);
          farthest = std::max(farthest, node.first_distance);
        }
    nearest          = Utilities::MPI::min(nearest, communicator);
    farthest         = Utilities::MPI::max(farthest, communicator);
    const double way = std::max(farthest - nearest, rounding * farthest);

    bool changed = false;
    for (Node &node : candidates)
      {
        const bool sticks =
          node.status == ContactStatus::closed &&
          contact_force(node, bounds.surface(node, u), residual).normal > 0.;
        if (sticks == node.friction.sticks)
          continue;
        changed              = true;
        node.friction.sticks = sticks;
        if (sticks && way > 0.)
          node.anchor += (node.first_distance - nearest) / way *
                         (horizontal_part<dim>(node, u) - node.anchor);
      }
    return Utilities::MPI::logical_or(changed, communicator);
  }



  template <int dim>
  TangentVector<dim>
  ContactSet<dim>::slip(const Node &node, const Vector &u) const
  {
    TangentVector<dim> of_free = horizontal_part<dim>(node, u) - node.anchor;
    for (unsigned int d = 0; d < dim - 1; ++d)
      if (!node.free[d])
        of_free[d] = 0.;
    return node.ties * of_free;
  }



  // What a support takes is not known to be friction. Along a skew plane of
  // symmetry, the force is that of the free displacement, condensed.
  template <int dim>
  ContactForce<dim>
  ContactSet<dim>::contact_force(const Node                 &node,
                                 const IndenterSurface<dim> &surface,
                                 const Vector               &residual) const
  {
    const double       vertical   = residual.local_element(node.index);
    const auto         condensed  = horizontal_part<dim>(node, residual);
    TangentVector<dim> horizontal = -vertical * surface.slope;
    for (unsigned int e = 0; e < dim - 1; ++e)
      if (node.free[e])
        {
          TangentVector<dim> way;
          for (unsigned int d = 0; d < dim - 1; ++d)
            way[d] = node.ties[d][e];
          horizontal += (condensed[e] + vertical * (way * surface.slope)) /
                        (way * way) * way;
        }
    return {vertical, horizontal, surface.slope};
  }



  template <int dim>
  double
  ContactSet<dim>::pressing_force(const Node   &node,
                                  const Vector &u,
                                  const Vector &residual) const
  {
    if (!friction.dissipates())
      return residual.local_element(node.index);
    const auto surface = bounds.surface(node, u);
    return contact_force(node, surface, residual).normal /
           std::sqrt(1. + surface.slope * surface.slope);
  }



  template <int dim>
  std::vector<unsigned int>
  ContactSet<dim>::force_entries() const
  {
    std::vector<unsigned int> entries = active_entries();
    if (has_sloped_bounds())
      for (const Node &node : candidates)
        if (node.is_active())
          entries.insert(entries.end(),
                         node.horizontal.begin(),
                         node.horizontal.end());
    return entries;
  }



  // (Without a law that says how much friction a node can bear, it is decided
  // before the solution whether it sticks, not by it: then there is only one.)
  template <int dim>
  bool
  ContactSet<dim>::is_held(const Node &node, const unsigned int d) const
  {
    return friction.exists() && node.friction.sticks && node.free[d] &&
           (node.is_active() || !friction.dissipates());
  }



  template <int dim>
  std::vector<unsigned int>
  ContactSet<dim>::stuck_entries() const
  {
    std::vector<unsigned int> entries;
    for (const Node &node : candidates)
      for (unsigned int d = 0; d < dim - 1; ++d)
        if (is_held(node, d))
          entries.push_back(node.horizontal[d]);
    return entries;
  }



  template <int dim>
  void
  ContactSet<dim>::begin_friction(Node &node, const Vector &u) const
  {
    if (!friction.dissipates())
      return;
    const auto surface = bounds.surface(node, u);
    friction.touch(node.friction,
                   slip(node, u),
                   surface.slope,
                   u.local_element(node.index) - surface.height +
                     present_depth);
  }



  // (A node that a support holds altogether has nothing to decide. Nodes that
  // mirror each other violate the law by as much but for rounding.)
  template <int dim>
  bool
  ContactSet<dim>::update_friction(const Vector      &u,
                                   const Vector      &residual,
                                   const FrictionPace pace)
  {
    if (!friction.dissipates())
      return false;
    constexpr double rounding = 1e-6;
    const bool       is_plane = is_plane_problem<dim>(kinematics);
    std::vector<FrictionState<dim>> next;
    std::vector<double>             violations;
    for (const Node &node : candidates)
      {
        next.push_back(node.friction);
        violations.push_back(0.);
        if (node.is_active() &&
            std::find(node.free.begin(), node.free.end(), true) !=
              node.free.end())
          {
            const auto surface = bounds.surface(node, u);
            violations.back() =
              friction.update(next.back(),
                              contact_force(node, surface, residual),
                              slip(node, u),
                              surface.slope,
                              is_plane ? 1. : std::sqrt(node.area));
          }
      }
    const double largest =
      Utilities::MPI::max(violations.empty() ?
                            0. :
                            *std::max_element(violations.begin(),
                                              violations.end()),
                          communicator);
    const double smallest =
      pace == FrictionPace::worst_first ? (1. - rounding) * largest : 0.;
    for (unsigned int k = 0; k < candidates.size(); ++k)
      if (violations[k] == 0. || violations[k] >= smallest)
        candidates[k].friction = next[k];
    return largest > 0.;
  }



  template <int dim>
  std::vector<SlopedBound>
  ContactSet<dim>::sloped_bounds(const Vector &u, const Vector &residual) const
  {
    std::vector<SlopedBound> result;
    if (!has_sloped_bounds())
      return result;
    const auto collect = [&]() {
      for (const Node &node : candidates)
        if (node.is_active())
          {
            result.push_back(sloped_bound(node, u));
            result.back().force = residual.local_element(node.index);
          }
    };
    // (Without friction, no bound can fail.)
    if (friction.dissipates())
      rethrow_collectively(communicator, collect);
    else
      collect();
    return result;
  }



  template <int dim>
  ForceSlope<dim>
  ContactSet<dim>::force_law(const Node                 &node,
                             const IndenterSurface<dim> &surface,
                             const Vector               &u) const
  {
    if (friction.dissipates() && !node.friction.sticks)
      return friction.force_slope(surface, node.friction, slip(node, u));
    return {surface.slope, surface.curvature};
  }



  template <int dim>
  SlopedBound
  ContactSet<dim>::sloped_bound(const Node &node, const Vector &u) const
  {
    SlopedBound bound;
    bound.index    = node.index;
    bound.entering = node.status == ContactStatus::entering;

    const IndenterSurface<dim> surface     = bounds.surface(node, u);
    const ForceSlope<dim>      law         = force_law(node, surface, u);
    const auto                 tied        = transpose(node.ties);
    const auto                 slope       = tied * surface.slope;
    const auto                 force_slope = tied * law.value;
    const auto                 curvature   = tied * law.derivative * node.ties;
    bound.n_others                         = dim - 1;
    for (unsigned int d = 0; d < dim - 1; ++d)
      {
        bound.others[d] = node.horizontal[d];
        if (is_held(node, d))
          continue;
        bound.slope[d]       = slope[d];
        bound.force_slope[d] = force_slope[d];
        for (unsigned int e = 0; e < dim - 1; ++e)
          bound.curvature[d][e] = curvature[d][e];
      }
    return bound;
  }
} // namespace ElastoPlastic
