// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_rise_of_gap_h
#define contact_rise_of_gap_h

#include <vector>

#include "contact/edge_law.h"

namespace ElastoPlastic
{
  /// How the gap function rises from node to node, of all nodes of all ranks:
  /// the coefficients of EdgeLaw. The rises, and the products of coefficients
  /// and rises, change continuously with the gaps.
  struct RiseOfGap
  {
    /// Of @p nodes in ascending order, the same on all ranks, and the pairs of
    /// the faces of this rank. Collective.
    RiseOfGap(const std::vector<EdgeLaw::Node> &nodes,
              const std::vector<EdgeLaw::Pair> &pairs,
              const MPI_Comm                    communicator);

    struct Neighbor
    {
      unsigned int node;
      double       coefficient;
    };

    /// By node j: its outer neighbours b and c_jb.
    std::vector<std::vector<Neighbor>> outer_neighbors;

    /// R_b; and whether any c_jb is larger than 0.
    std::vector<double> rises;
    std::vector<bool>   have_part;
  };
} // namespace ElastoPlastic

#endif
