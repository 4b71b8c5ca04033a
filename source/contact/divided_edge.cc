// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include "contact/divided_edge.h"

namespace ElastoPlastic
{
  namespace
  {
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
  void
  DividedEdge<dim>::reinit(const DoFHandler<dim>              &dof_handler,
                           const AffineConstraints<double>    &constraints,
                           const std::set<types::boundary_id> &boundaries,
                           const Kinematics                    kinematics,
                           const Vector                       &layout)
  {
    unite();
    all_faces.reinit(dof_handler, constraints, boundaries, kinematics, layout);
    memory.clear();
  }



  // The level of a neighbour falls from one, when the edge is at the last node
  // in contact, to zero.
  template <int dim>
  typename DividedEdge<dim>::Vector
  DividedEdge<dim>::levels(const Vector &kinds, const Vector &distances) const
  {
    const Vector neighbors = all_faces.neighbors(kinds);
    const Vector growth = all_faces.growth_beyond(kinds, neighbors, distances);
    Vector       levels(distances.get_partitioner());
    for (unsigned int i = 0; i < levels.locally_owned_size(); ++i)
      if (neighbors.local_element(i) == 1.)
        {
          const double distance = distances.local_element(i);
          const double noted =
            memory.n_steps > 0 ? memory.gaps_at_edge.local_element(i) : 0.;
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
  typename DividedEdge<dim>::Vector
  DividedEdge<dim>::expected_distances(const double depth) const
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
  DividedEdge<dim>::divide(const Vector &kinds,
                           const Vector &areas,
                           const double  expected_depth)
  {
    if (memory.n_steps == 0 || expected_depth < memory.depths[0])
      return;
    memory.kinds      = kinds;
    memory.levels     = levels(kinds, expected_distances(expected_depth));
    memory.is_divided = true;
    memory.divided_at = expected_depth;
    restore(areas);
  }



  template <int dim>
  void
  DividedEdge<dim>::restore(const Vector &areas)
  {
    if (!memory.is_divided)
      return;
    auto part = all_faces.touched_part(memory.kinds, memory.levels);
    for (unsigned int i = 0; i < areas.locally_owned_size(); ++i)
      {
        double      &own   = part.missing.local_element(i);
        const double whole = areas.local_element(i);
        own = whole - own > 1e-10 * whole ? 1. / (whole - own) : 0.;
      }
    weights = part.taken_over;
    scale   = std::make_shared<Vector>(part.missing);
  }



  template <int dim>
  void
  DividedEdge<dim>::unite()
  {
    memory.is_divided = false;
    weights.reset();
    scale.reset();
    shared_rows.reset();
  }



  template <int dim>
  void
  DividedEdge<dim>::share_rows(const Vector &active)
  {
    if (weights)
      shared_rows = std::make_shared<SharedRows>(weights, scale, active);
  }



  // A node that has become a neighbour of the contact was next to one before,
  // and as far away as its distance exceeded that of the one which has come
  // into contact.
  template <int dim>
  void
  DividedEdge<dim>::note(const Vector &kinds,
                         const Vector &distances,
                         const double  depth)
  {
    memory.allocate(distances);
    std::rotate(memory.distances.begin(),
                memory.distances.end() - 1,
                memory.distances.end());
    std::rotate(memory.depths.begin(),
                memory.depths.end() - 1,
                memory.depths.end());
    memory.distances[0] = distances;
    memory.depths[0]    = depth;
    memory.n_steps      = std::min(memory.n_steps + 1, 3U);

    const Vector neighbors = all_faces.neighbors(kinds);
    for (unsigned int i = 0; i < kinds.locally_owned_size(); ++i)
      {
        double &noted = memory.gaps_at_edge.local_element(i);
        if (neighbors.local_element(i) == 0.)
          noted = 0.;
        else if (noted == 0.)
          noted = memory.gaps_beyond.local_element(i);
      }
    memory.gaps_beyond = all_faces.growth_beyond(kinds, neighbors, distances);
    for (unsigned int i = 0; i < kinds.locally_owned_size(); ++i)
      if (neighbors.local_element(i) == 1.)
        memory.gaps_beyond.local_element(i) = 0.;
  }



  template class DividedEdge<2>;
  template class DividedEdge<3>;
} // namespace ElastoPlastic
