// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The mean force between entries of nodes into the contact.

#include <cmath>

#include "evaluation/solve_result.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  SolveResult
  after_step(MeanForce         &mean,
             const double       depth,
             const double       force,
             const unsigned int n_nodes)
  {
    SolveResult result;
    result.depth        = depth;
    result.force        = force;
    result.active_nodes = n_nodes;
    mean.add(result);
    return result;
  }

  bool
  is(const SolveResult &result, const double depth, const double force)
  {
    return std::abs(result.mean_depth - depth) < 1e-14 &&
           std::abs(result.mean_force - force) < 1e-12;
  }

  bool
  is_none(const SolveResult &result)
  {
    return std::isnan(result.mean_depth) && std::isnan(result.mean_force);
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  MeanForce mean;
  verify("the first node", is(after_step(mean, 1., 2., 1), 0.5, 1.));
  verify("none enters", is_none(after_step(mean, 2., 6., 1)));
  // (4 + 2 x 10) / 3
  verify("over steps of different lengths",
         is(after_step(mean, 4., 14., 3), 2.5, 8.));

  verify("on the way", is_none(after_step(mean, 5., 16., 3)));
  verify("back: begins where the indenter has turned",
         is(after_step(mean, 4.5, 8., 2), 4.75, 12.));
  verify("at rest", is_none(after_step(mean, 4.5, 8., 2)));
  verify("nodes change at rest", is_none(after_step(mean, 4.5, 8., 1)));

  // A wave of period 1 on a curve that is straight: ten steps each.
  MeanForce waves;
  bool      smooth = true;
  for (unsigned int i = 1; i <= 40; ++i)
    {
      const double      depth  = 0.1 * i;
      const SolveResult result = after_step(
        waves, depth, depth + 0.3 * std::sin(2 * numbers::PI * depth), i / 10);
      smooth &=
        i % 10 != 0 ? is_none(result) : is(result, depth - 0.5, depth - 0.5);
    }
  verify("waves cancel", smooth);
}
