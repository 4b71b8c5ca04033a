// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/contact_set.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Across the contact, at least: the edge of fewer is no smooth line.
    constexpr unsigned int n_elements_across = 4;



    /// How far from the edge, up to one element, a node is whose @p distance
    /// from the indenter grows to @p next_distance at the next node, if
    /// distances grow like Hertz' with the power 3/2 of the way from the edge.
    double
    elements_from_edge(const double distance, const double next_distance)
    {
      const double ratio = std::pow(distance / next_distance, 2. / 3.);
      return ratio < 0.5 ? ratio / (1. - ratio) : 1.;
    }
  } // namespace



  template <int dim>
  typename ContactSet<dim>::Vector
  ContactSet<dim>::kinds() const
  {
    Vector result(memory.gaps_at_edge.get_partitioner());
    for (const Node &node : candidates)
      result.local_element(node.index) =
        node.active ? ContactEdge<dim>::touching : ContactEdge<dim>::open;
    return result;
  }



  template <int dim>
  typename ContactSet<dim>::Vector
  ContactSet<dim>::distances(const Vector &u, const double depth) const
  {
    Vector result(memory.gaps_at_edge.get_partitioner());
    for (const Node &node : candidates)
      result.local_element(node.index) =
        bounds.value(node, u) - depth - u.local_element(node.index);
    return result;
  }



  // The level of a neighbour falls from one, when the edge is at the last node
  // in contact, to zero.
  template <int dim>
  typename ContactSet<dim>::Vector
  ContactSet<dim>::levels(const Vector &distances) const
  {
    const Vector kinds     = this->kinds();
    const Vector neighbors = edge.neighbors(kinds);
    const Vector growth    = edge.growth_beyond(kinds, neighbors, distances);
    Vector       levels(distances.get_partitioner());
    for (const Node &node : candidates)
      if (const unsigned int i = node.index; neighbors.local_element(i) == 1.)
        {
          const double distance = distances.local_element(i);
          const double noted    = memory.gaps_at_edge.local_element(i);
          levels.local_element(i) =
            distance <= 0. ?
              0. :
            noted > 0. ?
              std::min(distance / noted, 1.) :
              elements_from_edge(distance, distance + growth.local_element(i));
        }
    return levels;
  }



  // The distances of the last three steps, if there are as many: differences
  // from one step to the next would answer an edge that has gone a little too
  // far by one that does not go far enough, and so on.
  template <int dim>
  typename ContactSet<dim>::Vector
  ContactSet<dim>::expected_distances(const double depth) const
  {
    Vector result = memory.distances[0];
    if (memory.n_steps < 3 || depth == memory.depths[0] ||
        memory.depths[0] == memory.depths[2])
      return result;
    const double way = depth - 0.5 * (memory.depths[0] + memory.depths[1]);
    const double per_depth = 1. / (memory.depths[0] - memory.depths[2]);
    result.sadd(0.5 + way * per_depth, 0.5, memory.distances[1]);
    result.add(-way * per_depth, memory.distances[2]);
    return result;
  }



  template <int dim>
  void
  ContactSet<dim>::divide_edge(const double expected_depth)
  {
    if (memory.is_divided && expected_depth <= memory.divided_at)
      return;
    unite_edge();
    if (rule == EdgeRule::at_nodes || memory.n_steps == 0 ||
        expected_depth < memory.depths[0] ||
        n_active() < Utilities::fixed_power<dim - 1>(n_elements_across))
      return;
    memory.kinds      = kinds();
    memory.levels     = levels(expected_distances(expected_depth));
    memory.is_divided = true;
    memory.divided_at = expected_depth;
    restore_edge();
  }



  template <int dim>
  void
  ContactSet<dim>::restore_edge()
  {
    if (!memory.is_divided)
      return;
    auto part = edge.touched_part(memory.kinds, memory.levels);
    for (const Node &node : candidates)
      {
        double      &own   = part.missing.local_element(node.index);
        const double whole = node.area;
        own = whole - own > 1e-10 * whole ? 1. / (whole - own) : 0.;
      }
    weights = part.taken_over;
    scale   = std::make_shared<Vector>(part.missing);
    make_shared_rows();
  }



  template <int dim>
  void
  ContactSet<dim>::unite_edge()
  {
    memory.is_divided = false;
    weights.reset();
    scale.reset();
    rows.reset();
  }



  template <int dim>
  void
  ContactSet<dim>::make_shared_rows()
  {
    if (!weights)
      return;
    Vector active(memory.gaps_at_edge.get_partitioner());
    for (const unsigned int i : active_entries())
      active.local_element(i) = 1.;
    rows = std::make_shared<SharedRows>(weights, scale, active);
    if (!friction.exists())
      return;
    Vector ones(active.get_partitioner());
    set_candidate_entries(ones, 1.);
    shared_parts = rows->sums(ones);
  }



  template <int dim>
  typename ContactSet<dim>::Vector
  ContactSet<dim>::shared_gaps(const Vector &u, const double depth) const
  {
    return rows ? rows->sums(distances(u, depth)) : Vector();
  }



  // A node that has become a neighbour of the contact was next to one before,
  // and as far away as its distance exceeded that of the one which has come
  // into contact.
  template <int dim>
  void
  ContactSet<dim>::note_edge(const Vector &u)
  {
    if (rule == EdgeRule::at_nodes)
      return;
    std::rotate(memory.distances.begin(),
                memory.distances.end() - 1,
                memory.distances.end());
    std::rotate(memory.depths.begin(),
                memory.depths.end() - 1,
                memory.depths.end());
    memory.distances[0] = distances(u, present_depth);
    memory.depths[0]    = present_depth;
    memory.n_steps      = std::min(memory.n_steps + 1, 3U);

    const Vector neighbors = edge.neighbors(kinds());
    for (const Node &node : candidates)
      {
        double &noted = memory.gaps_at_edge.local_element(node.index);
        if (neighbors.local_element(node.index) == 0.)
          noted = 0.;
        else if (noted == 0.)
          noted = memory.gaps_beyond.local_element(node.index);
      }
    memory.gaps_beyond =
      edge.growth_beyond(kinds(), neighbors, memory.distances[0]);
    for (const Node &node : candidates)
      if (neighbors.local_element(node.index) == 1.)
        memory.gaps_beyond.local_element(node.index) = 0.;
  }



  template class ContactSet<2>;
  template class ContactSet<3>;
} // namespace ElastoPlastic
