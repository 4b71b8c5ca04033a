// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_conic_step_direction_h
#define bounds_conic_step_direction_h

#include "bounds/conic/kkt_system.h"

namespace ElastoPlastic
{
  /// Where an interior point step goes, in the notation of ConicSolution; W is
  /// the scaling of the cones.
  struct StepDirection
  {
    KktVector      change;
    Vector<double> scaled_s; ///< W^-1 ds
    Vector<double> scaled_z; ///< W dz
  };



  /// How far the cones allow to go.
  /// @param scaled lambda = W z = W^-1 s
  double
  largest_step(const ConicLayout    &layout,
               const Vector<double> &scaled,
               const StepDirection  &direction);



  /// What to add to the products of slacks and multipliers at the end of a step
  /// that is longer than the cones allow, so that they come near those on the
  /// central path: a correction of centrality as Gondzio's
  /// @cite gondzio_1996, for second-order cones. The eigenvalues of the
  /// product of each cone are brought into an interval around its target.
  /// @param length of the largest step
  /// @param targets by cones, the eigenvalues on the central path
  /// @return by rows of cones
  Vector<double>
  centrality_correction(const ConicLayout    &layout,
                        const Vector<double> &scaled,
                        const StepDirection  &direction,
                        const double          length,
                        const Vector<double> &targets);
} // namespace ElastoPlastic

#endif
