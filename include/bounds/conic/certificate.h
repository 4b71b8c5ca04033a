// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_conic_certificate_h
#define bounds_conic_certificate_h

#include "base/exceptions.h"
#include "bounds/conic/kkt_system.h"

namespace ElastoPlastic
{
  /// Nothing satisfies the equations and cones of a ConicProgram.
  struct NoSolutionError : ConvergenceError
  {
    NoSolutionError();
  };

  /// The cost of a ConicProgram has no lower bound.
  struct UnboundedError : ConvergenceError
  {
    UnboundedError();
  };



  /// Whether an @p iterate of an interior point method proves that a
  /// ConicProgram cannot be solved, up to rounding errors. Multipliers with
  ///   A^T y + G^T z = 0, b^T y + h^T z < 0, z in the cones
  /// contradict the conditions A x = b and G x + s = h. A direction with
  ///   P x = 0, A x = 0, G x + s = 0, c^T x < 0, s in the cones
  /// lowers the cost for ever. @p residual is what is missing to the first
  /// three equations of ConicSolution, in the order x, z, y of their
  /// multipliers.
  /// @throws NoSolutionError @throws UnboundedError
  void
  check_solvability(const ConicProgram  &program,
                    const ConicLayout   &layout,
                    const ConicSolution &iterate,
                    const KktVector     &residual);
} // namespace ElastoPlastic

#endif
