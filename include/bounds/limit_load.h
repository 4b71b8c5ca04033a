// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_limit_load_h
#define bounds_limit_load_h

#include <vector>

#include "bounds/body/plane_body.h"
#include "bounds/mechanism/velocity_program.h"
#include "bounds/stress/stress_field.h"

namespace ElastoPlastic
{
  /// Two bounds of the largest force, or the largest load factor, that a body
  /// of perfectly plastic materials can bear: any force below that of the
  /// stresses is safe, J (1.14) in
  /// @cite johnson_1978, any force above that of the mechanism is not.
  struct LimitLoad
  {
    StressField   stress;
    VelocityField velocity;

    /// Forces of the indenter, or load factors if other loads grow.
    double lower_bound = 0;
    double upper_bound = 0;

    /// By triangles, with a share of what is on their sides: plastic work of
    /// the mechanism less the power of the stresses,
    /// int sqrt(2/3) sigma_0 |e(v)| - tau : e(v) dx. It is never negative, and
    /// zero where the two fields belong together; all together are the
    /// difference of the bounds at most, or that by the power of the loads that
    /// grow.
    std::vector<double> gaps;
  };



  /// Computes the gaps from stress and velocity.
  void
  find_gaps(const PlaneBody &body, LimitLoad &bounds);

  /// @param degree of the stresses, 1 or 2. @throws ConvergenceError
  LimitLoad
  bound_limit_load(const PlaneBody &body, const unsigned int degree);
} // namespace ElastoPlastic

#endif
