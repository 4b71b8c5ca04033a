// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef solver_semismooth_newton_h
#define solver_semismooth_newton_h

#include <functional>
#include <vector>

#include "solver/constrained_minimization.h"
#include "solver/solver_parameters.h"

namespace ElastoPlastic
{
  /// One line of the iteration's protocol.
  struct NewtonStep
  {
    unsigned int iteration;
    unsigned int n_active;
    double       energy;
    /// Norm of the forces on the free unknowns, relative to all forces, or to
    /// the scale of the problem's forces if that is larger.
    double residual;
    /// Of the linear solve that led here; 0 in the starting point.
    unsigned int linear_iterations;
    /// The fraction of the Newton step that was taken.
    double step_length;
    /// Whether the active set differs from the one of the step before.
    bool active_set_changed;
    /// Whether the feasible method has taken over.
    bool feasible;
  };



  /// All steps of a nonlinear solve, the starting point first.
  struct NewtonReport
  {
    std::vector<NewtonStep> steps;
    /// At the solution; see ConstrainedMinimization::compute_residual().
    ConstrainedMinimization::Vector residual;

    /// The number of linear systems solved.
    unsigned int
    n_iterations() const
    {
      return steps.empty() ? 0 : steps.size() - 1;
    }

    unsigned int
    n_linear_iterations() const;
  };



  /// Minimises a ConstrainedMinimization: primal-dual active set and Newton's
  /// method in one loop @cite hintermuller_ito_kunisch_2002, globalised by the
  /// energy on the affine set where the active nodes touch. When the active
  /// set cycles, a feasible descent method takes over that cannot cycle:
  /// projected smoothing, then a truncated Newton step
  /// @cite graeser_sander_2019. See doc/theory, "One Newton loop".
  class SemismoothNewton
  {
  public:
    using Vector = ConstrainedMinimization::Vector;

    SemismoothNewton(
      const NewtonParameters                        &parameters,
      const std::function<void(const NewtonStep &)> &show_progress)
      : parameters(parameters)
      , show_progress(show_progress)
    {}


    /// @p u is the starting guess on input, the minimiser on output.
    /// @throws ConvergenceError if the limit of iterations is reached.
    NewtonReport
    solve(ConstrainedMinimization &problem, Vector &u) const;

  private:
    const NewtonParameters                        parameters;
    const std::function<void(const NewtonStep &)> show_progress;
  };
} // namespace ElastoPlastic

#endif
