// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_space_limit_load_h
#define bounds_space_limit_load_h

#include <vector>

#include "bounds/mechanism/space_velocity.h"
#include "bounds/stress/space_stress.h"

namespace ElastoPlastic
{
  /// The bounds of the limit load in space: what LimitLoad is in two
  /// dimensions.
  struct SpaceLimitLoad
  {
    SpaceStressField   stress;
    SpaceVelocityField velocity;
    /// What the velocities are those of: see circumscribe().
    SpaceBody body_of_velocity;

    /// Forces of the indenter, or load factors if other loads grow.
    double lower_bound = 0;
    double upper_bound = 0;

    /// By tetrahedra, with a share of what is on their faces: plastic work of
    /// the mechanism less the power of the stresses. It is never negative, and
    /// zero where the two fields belong together; all together are the
    /// difference of the bounds at most, or that by the power of the loads that
    /// grow. (Beside the edge of a disc, where both have meshes of their own,
    /// they are indicators.)
    std::vector<double> gaps;
  };



  /// @throws ConvergenceError
  SpaceLimitLoad
  bound_limit_load(const SpaceBody &body,
                   const double     tolerance = usual_space_tolerance);
} // namespace ElastoPlastic

#endif
