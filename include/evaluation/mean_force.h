// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef evaluation_mean_force_h
#define evaluation_mean_force_h

#include "evaluation/solve_result.h"

namespace ElastoPlastic
{
  /// The force of the indenter as the derivative of its work with respect to
  /// the depth, from one entry of nodes into the contact to the next: a force
  /// on a mesh waves with a period of one entry, and over a period waves
  /// cancel (doc/theory, "The edge of the contact").
  class MeanForce
  {
  public:
    /// Goes on to the end of a load step, @p result. If nodes have entered or
    /// left in it, @p result gets the mean force since this happened last, or
    /// since the indenter turned back, and the depth in the middle; the work
    /// is that of the trapezoidal rule.
    void
    add(SolveResult &result);

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /* version */)
    {
      archive &depth &force &active_nodes &first_depth &work;
    }

  private:
    /// At the end of the last step.
    double                  depth        = 0;
    double                  force        = 0;
    types::global_dof_index active_nodes = 0;

    /// Where the mean begins, and the work since then.
    double first_depth = 0;
    double work        = 0;
  };
} // namespace ElastoPlastic

#endif
