// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <limits>

#include "contact/contact_set.h"

namespace ElastoPlastic
{
  template <int dim>
  std::uint64_t
  ContactSet<dim>::fingerprint() const
  {
    std::uint64_t sum = 0;
    for (const Node &node : candidates)
      if (node.is_active())
        {
          // the splitmix64 finalizer spreads neighbouring indices
          std::uint64_t x = first_owned_dof + node.index + 1;
          x += node.friction.fingerprint() << 40;
          x += static_cast<std::uint64_t>(node.status) << 60;
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
    return Utilities::MPI::sum(
      static_cast<unsigned int>(active_entries().size()), communicator);
  }



  template <int dim>
  unsigned int
  ContactSet<dim>::n_closed() const
  {
    return Utilities::MPI::sum(
      static_cast<unsigned int>(closed_entries().size()), communicator);
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
  double
  ContactSet<dim>::min_gap_without_area() const
  {
    double smallest = std::numeric_limits<double>::infinity();
    for (const Node &node : hanging_nodes)
      if (node.without_area)
        smallest = std::min(smallest, node.gap.height);
    return Utilities::MPI::min(smallest, communicator);
  }



  template <int dim>
  std::vector<unsigned int>
  ContactSet<dim>::entries_entered(const Vector &u) const
  {
    std::vector<unsigned int> entries;
    if (!presses() || n_active() > 0)
      return entries;
    for (const Node &node : hanging_nodes)
      if (node.without_area && u.local_element(node.index) > bound(node, u))
        entries.push_back(node.index);
    return entries;
  }



  template <int dim>
  typename ContactSet<dim>::Vector
  ContactSet<dim>::vertical_forces_on_body(const Vector &residual) const
  {
    Vector forces(residual.get_partitioner());
    for (const Node &node : candidates)
      if (node.is_active())
        forces.local_element(node.index) = -residual.local_element(node.index);
    return forces;
  }



  template <int dim>
  bool
  ContactSet<dim>::presses() const
  {
    return !is_force_driven() || force() > 0.;
  }



  template <int dim>
  bool
  ContactSet<dim>::is_force_driven() const
  {
    return given_force.has_value();
  }



  template <int dim>
  double
  ContactSet<dim>::force() const
  {
    return given_force.value_or(0.);
  }



  template <int dim>
  bool
  ContactSet<dim>::law_is_resting() const
  {
    return law_rests;
  }



  template <int dim>
  bool
  ContactSet<dim>::ends_within_faces() const
  {
    return law().exists();
  }



  template <int dim>
  bool
  ContactSet<dim>::stays_closed(const unsigned int k,
                                const double       pressing,
                                const double       force,
                                const double       force_inside) const
  {
    return pressing > 0. &&
           (!law().has_part(k) || force > EdgeLaw::full_share() * force_inside);
  }



  template <int dim>
  bool
  ContactSet<dim>::has_sloped_bounds() const
  {
    return bounds.are_sloped() || friction.exists();
  }



  template <int dim>
  bool
  ContactSet<dim>::has_friction() const
  {
    return friction.exists();
  }



  template <int dim>
  bool
  ContactSet<dim>::dissipates() const
  {
    return friction.dissipates();
  }



  template <int dim>
  bool
  ContactSet<dim>::has_curved_bounds() const
  {
    return bounds.follow_deformation();
  }
} // namespace ElastoPlastic
