// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <boost/serialization/map.hpp>
#include <boost/serialization/utility.hpp>

#include <algorithm>
#include <map>
#include <numeric>

#include "contact/edge_law.h"

namespace ElastoPlastic
{
  namespace
  {
    /// A spot of a few elements is not to disappear in what its edge allows:
    /// only nodes that are so many times their rise above the tip of the spot
    /// have the whole rise.
    constexpr double least_height = 6.;
    /// A tip, whose own rise is zero, is plain; a node whose rise is at least
    /// this part of that of its outer neighbour is not.
    constexpr double least_rise_inside = 1. / 3.;
    /// What the outer neighbours of a node have together is at most so many
    /// times its own area.
    constexpr double largest_area_outside = 2.;
    /// Against the largest, smaller rises are rounding.
    constexpr double smallest_rise = 1e-12;
    /// And with still larger ones, a surface is flat.
    constexpr double flat = 1e-6;



    /// The neighbours of each node, ascending, and how many faces they share.
    std::vector<std::map<unsigned int, unsigned int>>
    neighbors_of(const std::vector<EdgeLaw::Node> &nodes,
                 const std::vector<EdgeLaw::Pair> &pairs,
                 const MPI_Comm                    communicator)
    {
      const auto number = [&](const types::global_dof_index dof) {
        const auto found =
          std::lower_bound(nodes.begin(),
                           nodes.end(),
                           dof,
                           [](const EdgeLaw::Node          &node,
                              const types::global_dof_index value) {
                             return node.dof < value;
                           });
        return found != nodes.end() && found->dof == dof ?
                 static_cast<unsigned int>(found - nodes.begin()) :
                 numbers::invalid_unsigned_int;
      };
      std::map<std::pair<unsigned int, unsigned int>, unsigned int> links;
      for (const auto &[one, other] : pairs)
        {
          const auto link = std::make_pair(number(one), number(other));
          if (link.first != numbers::invalid_unsigned_int &&
              link.second != numbers::invalid_unsigned_int)
            ++links[link];
        }
      std::vector<std::map<unsigned int, unsigned int>> result(nodes.size());
      for (const auto &of_rank :
           Utilities::MPI::all_gather(communicator, links))
        for (const auto &[link, n_faces] : of_rank)
          {
            result[link.first][link.second] += n_faces;
            result[link.second][link.first] += n_faces;
          }
      return result;
    }
  } // namespace



  // The weight w_bj of an inner neighbour is in proportion to how much lower
  // the gap is there, and to how many faces it shares with b: so nodes in a
  // plane of symmetry have the same in a half of the body. From low to high:
  // the height of the foot of a node is the weighted mean of those of its inner
  // neighbours.
  RiseOfGap::RiseOfGap(const std::vector<EdgeLaw::Node> &nodes,
                       const std::vector<EdgeLaw::Pair> &pairs,
                       const MPI_Comm                    communicator)
    : outer_neighbors(nodes.size())
    , rises(nodes.size())
    , have_part(nodes.size())
  {
    const auto neighbors = neighbors_of(nodes, pairs, communicator);
    std::vector<unsigned int> from_low_to_high(nodes.size());
    std::iota(from_low_to_high.begin(), from_low_to_high.end(), 0U);
    std::stable_sort(from_low_to_high.begin(),
                     from_low_to_high.end(),
                     [&](const unsigned int j, const unsigned int k) {
                       return nodes[j].gap < nodes[k].gap;
                     });

    std::vector<double> full_rises(nodes.size()), areas_outside(nodes.size());
    std::vector<std::vector<Neighbor>> inner_neighbors(nodes.size());
    for (unsigned int b = 0; b < nodes.size(); ++b)
      {
        double sum = 0;
        for (const auto &[j, n_faces] : neighbors[b])
          if (nodes[j].gap < nodes[b].gap)
            {
              inner_neighbors[b].push_back(
                {j, n_faces * (nodes[b].gap - nodes[j].gap)});
              sum += inner_neighbors[b].back().coefficient;
            }
        for (auto &[j, weight] : inner_neighbors[b])
          {
            weight /= sum;
            full_rises[b] += weight * (nodes[b].gap - nodes[j].gap);
          }
      }
    const double largest_rise =
      nodes.empty() ? 0. :
                      *std::max_element(full_rises.begin(), full_rises.end());

    // (On a flat, feet are where the node is.)
    std::vector<double> feet(nodes.size());
    for (const unsigned int b : from_low_to_high)
      {
        const double inclined =
          largest_rise > 0. ?
            std::min(1., full_rises[b] / (flat * largest_rise)) :
            0.;
        feet[b] = (1. - inclined) * nodes[b].gap;
        for (const auto &[j, weight] : inner_neighbors[b])
          feet[b] += inclined * weight * feet[j];
        if (full_rises[b] > 0.)
          rises[b] =
            full_rises[b] * Utilities::fixed_power<2>(
                              std::clamp((nodes[b].gap - feet[b]) /
                                           (least_height * full_rises[b]),
                                         0.,
                                         1.));
      }

    for (unsigned int b = 0; b < nodes.size(); ++b)
      {
        if (rises[b] <= smallest_rise * largest_rise)
          continue;
        for (const auto &[j, weight] : inner_neighbors[b])
          {
            const double is_no_tip =
              std::min(1., full_rises[j] / (least_rise_inside * full_rises[b]));
            const double area = nodes[b].area * weight * is_no_tip;
            if (area == 0.)
              continue;
            have_part[b] = true;
            areas_outside[j] += area;
            outer_neighbors[j].push_back({b, area});
          }
      }
    for (unsigned int j = 0; j < nodes.size(); ++j)
      for (Neighbor &outer : outer_neighbors[j])
        outer.coefficient *=
          std::min(1. / nodes[j].area, largest_area_outside / areas_outside[j]);
  }
} // namespace ElastoPlastic
