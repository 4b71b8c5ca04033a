// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef solver_tangent_solver_h
#define solver_tangent_solver_h

#include "mechanics/solid_operator.h"

namespace ElastoPlastic
{
  /// Solves linear systems with the stored tangent of a body of which some
  /// unknowns are held.
  template <int dim>
  class TangentSolver
  {
  public:
    virtual ~TangentSolver() = default;

    /// Takes the stored tangent of @p solid, which must outlive the solves.
    /// @p held has ones at the held unknowns that this rank owns, zeros
    /// elsewhere.
    virtual void
    prepare(const SolidOperator<dim> &solid, const VectorType &held) = 0;

    /// Solves on the free unknowns until the residual has fallen by the factor
    /// @p reduction. @p rhs is zero at held and constrained unknowns, and so is
    /// the result. @return the number of iterations. If they are used up
    /// before, the last iterate is the answer: what CG has found by then is
    /// still a direction of descent for the energy.
    /// @throws ConvergenceError if the result is not finite.
    virtual unsigned int
    solve(VectorType       &solution,
          const VectorType &rhs,
          const double      reduction) = 0;
  };
} // namespace ElastoPlastic

#endif
