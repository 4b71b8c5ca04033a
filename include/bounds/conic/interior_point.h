// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_conic_interior_point_h
#define bounds_conic_interior_point_h

#include "base/exceptions.h"
#include "bounds/conic/conic_program.h"

namespace ElastoPlastic
{
  /// Nothing satisfies the equations and cones of a ConicProgram.
  struct NoSolutionError : ConvergenceError
  {
    NoSolutionError()
      : ConvergenceError(
          "The problem that the interior point method solves has "
          "no solution.")
    {}
  };

  /// The cost of a ConicProgram has no lower bound.
  struct UnboundedError : ConvergenceError
  {
    UnboundedError()
      : ConvergenceError(
          "The cost that the interior point method minimises has "
          "no lower bound.")
    {}
  };



  /// Solves a ConicProgram by a primal-dual interior point method: Nesterov
  /// and Todd's scaling, Mehrotra's predictor and corrector
  /// @cite vandenberghe_2010. The data should be of the order 1. A program that
  /// is moved here is not held in memory twice.
  /// @param tolerance for the gap, relative to the cost. If rounding errors end
  /// the iteration before, the solution is the best iterate. In any case,
  /// make_admissible() has restored its equations. ExclusiveWork of this thread
  /// pauses during the iteration.
  /// @throws ConvergenceError if the gap has not even come below 1 %, in
  /// particular if the program has no solution; TerminationError if this
  /// process has been asked to end.
  ConicSolution
  minimize(ConicProgram program, const double tolerance);
} // namespace ElastoPlastic

#endif
