// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <numeric>

#include "contact/edge_law.h"

namespace ElastoPlastic
{
  namespace
  {
    /// What a node bears at most before it touches, of the mean pressure of its
    /// inner neighbours.
    constexpr double largest_share = 0.5;



    /// Iterates may be beyond their bounds: for a little of that, the share
    /// stays what it is at the bound.
    constexpr double smallest_opening = -1. / 3.;

    /// The opening of a node that has just left the indenter is zero, but for
    /// this.
    constexpr double rounded_opening = 1e-8;



    /// P(y) = X (1 - (1 - y)^3) / 3.
    double
    penetration(const double opening)
    {
      if (opening <= 0.)
        return largest_share * std::max(opening, smallest_opening);
      const double touched = std::max(1. - opening, 0.);
      return largest_share * (1. - touched * touched * touched) / 3.;
    }
  } // namespace



  double
  EdgeLaw::share(const double opening)
  {
    if (opening < smallest_opening)
      return 0.;
    const double touched = std::clamp(1. - opening, 0., 1.);
    return largest_share * touched * touched;
  }



  double
  EdgeLaw::stiffness(const unsigned int node, const double opening) const
  {
    return opening > -rounded_opening && opening < 1. ?
             2. * largest_share * (1. - opening) / rise(node) :
             0.;
  }



  // All ranks find out all of it, which is little, and keep what concerns
  // their nodes.
  void
  EdgeLaw::reinit(const std::vector<Node> &nodes,
                  const std::vector<Pair> &pairs,
                  const MPI_Comm           communicator)
  {
    const unsigned int rank = Utilities::MPI::this_mpi_process(communicator);
    const auto of_ranks     = Utilities::MPI::all_gather(communicator, nodes);
    std::vector<Node> all;
    unsigned int      begin = 0;
    for (unsigned int r = 0; r < of_ranks.size(); ++r)
      {
        if (r == rank)
          begin = all.size();
        all.insert(all.end(), of_ranks[r].begin(), of_ranks[r].end());
      }
    layout.reset();
    if (all.empty()) // (deal.II makes no partition of nothing)
      return;
    const RiseOfGap rise(all, pairs, communicator);

    IndexSet owned(all.size()), relevant(all.size());
    owned.add_range(begin, begin + nodes.size());
    for (unsigned int k = begin; k < begin + nodes.size(); ++k)
      for (const auto &outer : rise.outer_neighbors[k])
        relevant.add_index(outer.node);
    const auto partitioner =
      std::make_shared<Utilities::MPI::Partitioner>(owned,
                                                    relevant,
                                                    communicator);
    layout = partitioner;

    outer_neighbors.assign(nodes.size(), {});
    rises.reinit(layout);
    parts.assign(nodes.size(), false);
    entries.clear();
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        for (const auto &[node, coefficient] : rise.outer_neighbors[begin + k])
          outer_neighbors[k].push_back(
            {partitioner->global_to_local(node), coefficient});
        rises.local_element(k) = rise.rises[begin + k];
        parts[k]               = rise.have_part[begin + k];
        entries.push_back(nodes[k].entry);
      }
    rises.update_ghost_values();

    from_high_to_low.resize(nodes.size());
    std::iota(from_high_to_low.begin(), from_high_to_low.end(), 0U);
    std::stable_sort(from_high_to_low.begin(),
                     from_high_to_low.end(),
                     [&](const unsigned int j, const unsigned int k) {
                       return nodes[j].gap > nodes[k].gap;
                     });
  }



  double
  EdgeLaw::allowance(const unsigned int node, const Vector &openings) const
  {
    double sum = 0;
    for (const auto &[outer, coefficient] : outer_neighbors[node])
      sum += coefficient * rises.local_element(outer) *
             penetration(openings.local_element(outer));
    return sum;
  }



  // On one rank, the second round finds nothing to change: the outer neighbours
  // of a node are higher.
  template <typename Opening>
  EdgeLaw::Place
  EdgeLaw::sweep(const std::vector<double> &gaps, const Opening &opening) const
  {
    Place result{Vector(layout), std::vector<double>(gaps.size())};
    for (bool changed = true; changed;)
      {
        changed = false;
        result.openings.update_ghost_values();
        for (const unsigned int k : from_high_to_low)
          {
            result.allowances[k] = allowance(k, result.openings);
            const double y       = opening(k, gaps[k] + result.allowances[k]);
            const double before  = result.openings.local_element(k);
            changed |= (y < before || y > before); // (not if it is no number)
            result.openings.local_element(k) = y;
          }
        changed =
          Utilities::MPI::logical_or(changed, layout->get_mpi_communicator());
      }
    return result;
  }



  EdgeLaw::Place
  EdgeLaw::place(const std::vector<double>        &gaps,
                 const std::vector<ContactStatus> &statuses) const
  {
    if (!exists())
      return {Vector(), std::vector<double>(gaps.size())};
    return sweep(gaps, [&](const unsigned int k, const double distance) {
      return statuses[k] == ContactStatus::closed ? 0. :
             has_part(k) ? std::min(distance / rise(k), 1.) :
                           1.;
    });
  }



  EdgeLaw::Place
  EdgeLaw::largest_openings(const std::vector<double> &gaps) const
  {
    if (!exists())
      return {Vector(), std::vector<double>(gaps.size())};
    return sweep(gaps, [&](const unsigned int k, const double distance) {
      return distance <= 0.      ? 0. :
             distance >= rise(k) ? 1. :
                                   distance / rise(k);
    });
  }



  std::vector<double>
  EdgeLaw::forces_inside(const std::vector<double> &forces) const
  {
    std::vector<double> result(forces.size());
    if (!exists())
      return result;
    Vector sums(layout);
    for (unsigned int k = 0; k < forces.size(); ++k)
      for (const auto &[outer, coefficient] : outer_neighbors[k])
        sums.local_element(outer) += coefficient * forces[k];
    sums.compress(VectorOperation::add);
    for (unsigned int k = 0; k < forces.size(); ++k)
      result[k] = sums.local_element(k);
    return result;
  }



  bool
  EdgeLaw::is_within(const unsigned int node, const Vector &outside) const
  {
    const auto &outer_ones = outer_neighbors[node];
    return !outer_ones.empty() &&
           std::all_of(outer_ones.begin(),
                       outer_ones.end(),
                       [&](const Entry &outer) {
                         return outside.local_element(outer.node) == 0.;
                       });
  }



  std::vector<bool>
  EdgeLaw::passed(const std::vector<double>        &gaps,
                  const std::vector<ContactStatus> &statuses) const
  {
    std::vector<bool> result;
    for (const ContactStatus status : statuses)
      result.push_back(status != ContactStatus::open);
    if (!exists())
      return result;
    Vector outside(layout);
    for (bool changed = true; changed;)
      {
        changed = false;
        for (unsigned int k = 0; k < result.size(); ++k)
          outside.local_element(k) = result[k] ? 0. : 1.;
        outside.update_ghost_values();
        for (const unsigned int k : from_high_to_low)
          if (result[k] && statuses[k] == ContactStatus::entering &&
              gaps[k] > 0. && !is_within(k, outside))
            {
              result[k]                = false;
              outside.local_element(k) = 1.;
              changed                  = true;
            }
        changed =
          Utilities::MPI::logical_or(changed, layout->get_mpi_communicator());
      }
    return result;
  }



  // It ends: inner neighbours are lower.
  std::vector<double>
  EdgeLaw::handed_inside(const std::vector<double> &values,
                         const std::vector<bool>   &keep,
                         const std::vector<double> &forces) const
  {
    std::vector<double> result = values;
    if (!exists())
      return result;
    const std::vector<double> inside = forces_inside(forces);
    Vector                    quotients(layout);
    for (bool has_moved = true; has_moved;)
      {
        has_moved = false;
        quotients = 0.;
        for (unsigned int k = 0; k < result.size(); ++k)
          if (!keep[k] && inside[k] > 0. && result[k] != 0.)
            {
              quotients.local_element(k) = result[k] / inside[k];
              result[k]                  = 0.;
              has_moved                  = true;
            }
        quotients.update_ghost_values();
        for (unsigned int k = 0; k < result.size(); ++k)
          for (const auto &[outer, coefficient] : outer_neighbors[k])
            result[k] +=
              coefficient * forces[k] * quotients.local_element(outer);
        has_moved =
          Utilities::MPI::logical_or(has_moved, layout->get_mpi_communicator());
      }
    return result;
  }



  std::shared_ptr<const SharedRows>
  EdgeLaw::rows(const Place                      &place,
                const std::vector<ContactStatus> &statuses) const
  {
    if (!exists())
      return {};
    Vector shares(layout);
    for (unsigned int k = 0; k < statuses.size(); ++k)
      if (statuses[k] == ContactStatus::entering)
        shares.local_element(k) = share(place.openings.local_element(k));
    shares.update_ghost_values();

    SharedRows::Rows result;
    for (unsigned int k = 0; k < statuses.size(); ++k)
      {
        if (statuses[k] == ContactStatus::open)
          continue;
        std::vector<SharedRows::Rows::Entry> row;
        for (const auto &[outer, coefficient] : outer_neighbors[k])
          if (const double share = shares.local_element(outer); share > 0.)
            row.push_back({outer, coefficient * share});
        if (!row.empty())
          result.add(k, row);
      }
    result.finish();
    return std::make_shared<SharedRows>(result, entries, layout);
  }
} // namespace ElastoPlastic
