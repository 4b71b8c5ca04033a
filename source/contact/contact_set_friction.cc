// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

#include "base/rethrow_collectively.h"
#include "contact/contact_set.h"

// The forces of ContactSet that are not vertical: flanks and friction.

namespace ElastoPlastic
{
  template <int dim>
  void
  ContactSet<dim>::begin_step(const Vector &u, const Tensor<1, dim - 1> &motion)
  {
    wake_law();
    for (Node &node : candidates)
      {
        node.anchor = horizontal_part<dim>(node, u) + motion;
        friction.begin_step(node.friction);
      }
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
    if (!friction.exists())
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



  // (A node that is entering presses with next to nothing at first: without a
  // law that says how much it may stick for that, it does not.)
  template <int dim>
  bool
  ContactSet<dim>::is_held(const Node &node, const unsigned int d) const
  {
    return friction.exists() && node.friction.sticks && node.free[d] &&
           (friction.dissipates() || node.status == ContactStatus::closed);
  }



  template <int dim>
  std::vector<unsigned int>
  ContactSet<dim>::stuck_entries() const
  {
    std::vector<unsigned int> entries;
    for (const Node &node : candidates)
      for (unsigned int d = 0; d < dim - 1; ++d)
        if (node.is_active() && is_held(node, d))
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
    const bool is_plane = dim == 2 && kinematics != Kinematics::axisymmetric;
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



  template class ContactSet<2>;
  template class ContactSet<3>;
} // namespace ElastoPlastic
