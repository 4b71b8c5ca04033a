// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "evaluation/solve_result.h"

namespace ElastoPlastic
{
  void
  MeanForce::add(SolveResult &result)
  {
    const double advance = result.depth - depth;
    if (advance * (depth - first_depth) < 0.)
      {
        first_depth = depth;
        work        = 0.;
      }
    work += 0.5 * (force + result.force) * advance;

    if (result.active_nodes != active_nodes && result.depth != first_depth)
      {
        result.mean_force = work / (result.depth - first_depth);
        result.mean_depth = 0.5 * (first_depth + result.depth);
        first_depth       = result.depth;
        work              = 0.;
      }
    depth        = result.depth;
    force        = result.force;
    active_nodes = result.active_nodes;
  }
} // namespace ElastoPlastic
