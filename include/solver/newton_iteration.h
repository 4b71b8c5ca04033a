// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef solver_newton_iteration_h
#define solver_newton_iteration_h

#include <cstdint>
#include <map>

#include "solver/constrained_minimization.h"
#include "solver/newton_parameters.h"

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



  /// The state of one nonlinear solve, and the steps that SemismoothNewton
  /// makes of it.
  struct NewtonIteration
  {
    using Vector = ConstrainedMinimization::Vector;

    /// A step that falls below this fraction is no step.
    static constexpr double smallest_step_length = 1e-4;
    /// Differences of the energy below this fraction of its magnitude are
    /// rounding noise.
    static constexpr double energy_noise = 1e-11;

    NewtonIteration(ConstrainedMinimization &problem,
                    Vector                  &u,
                    const NewtonParameters  &parameters);

    /// Computes residual and energy at u.
    void
    evaluate();

    /// Updates the active set and all that depends on it.
    void
    update_active_set();

    /// The forces on the free unknowns.
    Vector
    free_forces() const;

    /// Whether the set just reached has been there too often.
    bool
    set_cycles();

    /// Lets the set change more slowly, or else becomes feasible.
    void
    leave_cycle();

    /// Projects u onto the admissible set and hands over to the feasible
    /// method. @throws ConvergenceError if there is no convex energy that this
    /// method could decrease.
    void
    become_feasible();

    /// Whether u is as good as the tolerance asks for, or as it can be. Forces
    /// that are nothing but the rounding of a rigid body motion are dropped.
    bool
    has_converged();

    /// Whether the forces on the free unknowns are small, or all forces nothing
    /// but rounding, and no larger than what the rounding of u makes of them:
    /// the displacements have only so
    /// many digits, and where the body is very stiff, or almost incompressible,
    /// the last of them are large forces.
    bool
    is_rounding();

    /// The primal-dual active set and Newton step.
    void
    newton_step();

    /// The step of the feasible method.
    void
    feasible_step();

    /// Moves the constrained unknowns of u to their prescribed places, unless
    /// they are there, and computes the Newton increment from there; residual
    /// and energy stay those of the old u.
    void
    compute_increment();

    /// Whether there is an energy at u: not where constrained unknowns that
    /// have been moved alone have turned elements inside out.
    bool
    is_possible() const;

    /// Moves u by @p direction, and returns 1, the fraction of it that has been
    /// taken. @throws ConvergenceError if there is no energy there either.
    double
    full_step(const Vector &direction);

    /// Whether an @p energy is not visibly larger than at the @p start.
    static bool
    has_not_grown(const Energy &energy, const Energy &start)
    {
      return energy.value <= start.value + energy_noise * start.magnitude;
    }

    /// Backtracking from @p base along @p direction, where the energy has the
    /// derivative @p slope < 0: finds a fraction with a sufficient decrease
    /// and sets u accordingly. Zero, and u = base, if there is none.
    double
    line_search(const Vector &base,
                const Vector &direction,
                const double  slope);

    /// The same if there is no energy: the norm of the forces on the free
    /// unknowns must fall.
    double
    residual_line_search(const Vector &base, const Vector &direction);

    /// That norm at u, with its residual; infinite where there are no forces.
    double
    trial_norm();

    /// Whether u is as good as it can be told in the presence of rounding:
    /// the energy has not grown visibly and its slope along @p direction has
    /// shrunk @cite hager_zhang_2005.
    bool
    slope_has_shrunk(const Vector &direction, const double slope) const;

    /// Whether the forces on the free unknowns are at most half of those where
    /// the iteration began.
    bool
    forces_have_shrunk() const;

    /// Projected Jacobi sweeps, the energy decreasing.
    void
    smooth();

    /// Relative tolerance for the next linear solve
    /// @cite eisenstat_walker_1996 (choice 2), not tighter than useful.
    double
    linear_reduction() const;

    ConstrainedMinimization &problem;
    Vector                  &u;
    const NewtonParameters  &parameters;

    /// The increment is the way of the constrained unknowns to their places,
    /// until compute_increment() makes that of all unknowns of it.
    Vector previous_u, residual, increment, work;

    double force_norm         = 0;
    double free_norm          = 0;
    double previous_free_norm = 0;
    Energy current_energy;
    bool   feasible                      = false;
    bool   stuck                         = false;
    bool   constrained_unknowns_at_place = false;

    std::map<std::uint64_t, unsigned int> visited_sets;

    NewtonStep step;
  };
} // namespace ElastoPlastic

#endif
