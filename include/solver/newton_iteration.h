// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef solver_newton_iteration_h
#define solver_newton_iteration_h

#include <cmath>
#include <cstdint>
#include <map>

#include "solver/semismooth_newton.h"

namespace ElastoPlastic
{
  /// One nonlinear solve of SemismoothNewton, in stages: it begins with
  /// evaluate(); then each iteration updates the active set, measures the
  /// forces, looks whether it has converged, and if not takes a step.
  class NewtonIteration
  {
  public:
    using Vector = ConstrainedMinimization::Vector;

    /// All arguments must outlive this object; @p u is where it begins, and
    /// then the present iterate.
    NewtonIteration(ConstrainedMinimization &problem,
                    Vector                  &u,
                    const NewtonParameters  &parameters);

    /// Computes forces and energy at u, from where the bounds are now.
    void
    evaluate()
    {
      current_energy = problem.move_to(u, residual);
    }

    /// The switching test; if the set comes back too often, it changes more
    /// slowly from now on, or the feasible method takes over. (The set of the
    /// starting point is the caller's guess.) @throws ConvergenceError if there
    /// is no convex energy that the feasible method could decrease.
    void
    update_active_set();

    /// Finds out how large the forces on the free unknowns are against all.
    /// @throws ConvergenceError, InputError if they are no numbers to work with
    void
    measure_forces();

    /// Whether u is as good as the tolerance asks for, or as it can be. Forces
    /// that are nothing but the rounding of a rigid body motion are dropped.
    bool
    has_converged();

    /// A primal-dual or a feasible step. @throws ConvergenceError
    void
    take_step();

    /// What the protocol says of the iteration so far.
    const NewtonStep &
    protocol() const
    {
      return step;
    }

    /// At u; see ConstrainedMinimization::compute_residual().
    const Vector &
    forces() const
    {
      return residual;
    }

  private:
    /// A step that falls below this fraction is no step.
    static constexpr double smallest_step_length = 1e-4;

    /// Whether an @p energy is not visibly larger than at the @p start:
    /// differences below a small fraction of its magnitude are rounding noise.
    static bool
    has_not_grown(const Energy &energy, const Energy &start)
    {
      return energy.value <= start.value + 1e-11 * start.magnitude;
    }

    /// The forces on the free unknowns.
    Vector
    free_forces() const;

    /// How far the constrained unknowns of u are from their prescribed places.
    Vector
    way_to_places() const;

    /// Whether the set just reached has been there too often.
    bool
    set_cycles();

    /// Projects u onto the admissible set and hands over to the feasible
    /// method.
    void
    become_feasible();

    /// Whether the forces on the free unknowns are small, or all forces nothing
    /// but rounding, and no larger than what the rounding of u makes of them:
    /// the displacements have only so many digits, and where the body is very
    /// stiff, or almost incompressible, the last of them are large forces.
    bool
    is_rounding() const;

    void
    primal_dual_step();

    void
    feasible_step();

    /// The Newton increment for these forces at u, all of them.
    Vector
    newton_increment(Vector forces);

    /// Whether there is an energy at u: not where constrained unknowns that
    /// have been moved alone have turned elements inside out.
    bool
    is_possible() const
    {
      return std::isfinite(current_energy.value);
    }

    /// Moves u by @p direction, and returns 1, the fraction of it that has been
    /// taken. @throws ConvergenceError if there is no energy there either.
    double
    full_step(const Vector &direction);

    /// Backtracking from u along @p direction, where the energy has the
    /// derivative @p slope < 0: finds a fraction with a sufficient decrease
    /// and moves u accordingly. Zero, and no motion, if there is none.
    double
    line_search(const Vector &direction, const double slope);

    /// The same if there is no energy: the norm of the forces on the free
    /// unknowns must fall.
    double
    residual_line_search(const Vector &direction);

    /// That norm at u, with its forces; infinite where there are none.
    double
    trial_norm();

    /// Whether u is as good as it can be told in the presence of rounding:
    /// the energy has not grown visibly since the @p start and its slope along
    /// @p direction has shrunk @cite hager_zhang_2005, or the forces on the
    /// free unknowns are at most half of those where the iteration began.
    bool
    is_as_good(const Energy &start,
               const Vector &direction,
               const double  slope) const;

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

    // At u; all forces, and those on the free unknowns, now and before the last
    // step.
    Vector residual;
    Energy current_energy;
    double force_norm = 0, free_norm = 0, previous_free_norm = 0;

    // Whether the constrained unknowns are where they should be, and whether
    // the last step has led nowhere.
    bool constrained_unknowns_at_place = false, stuck = false;

    std::map<std::uint64_t, unsigned int> visited_sets;
    NewtonStep                            step;
  };
} // namespace ElastoPlastic

#endif
