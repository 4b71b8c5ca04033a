// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "base/exceptions.h"
#include "solver/semismooth_newton.h"

namespace ElastoPlastic
{
  namespace
  {
    /// The loosest relative tolerance of a linear solve.
    constexpr double loosest_linear_reduction = 1e-3;
    /// A step that falls below this fraction is no step.
    constexpr double smallest_step_length = 1e-4;
    /// Differences of the energy below this fraction of it are rounding noise.
    constexpr double energy_noise = 1e-11;
    /// So often may an active set come back before we call it a cycle.
    constexpr unsigned int tolerated_recurrences = 3;
    constexpr unsigned int n_smoothing_sweeps    = 3;
  } // namespace



  unsigned int
  NewtonReport::n_iterations() const
  {
    return steps.empty() ? 0 : steps.size() - 1;
  }



  unsigned int
  NewtonReport::n_linear_iterations() const
  {
    unsigned int sum = 0;
    for (const NewtonStep &step : steps)
      sum += step.linear_iterations;
    return sum;
  }



  /// The state of one nonlinear solve.
  struct SemismoothNewton::Iteration
  {
    Iteration(ConstrainedMinimization &problem,
              Vector                  &u,
              const NewtonParameters  &parameters);

    /// Computes the residual at u and what is derived from it.
    void
    evaluate();

    /// Updates the active set and all that depends on it.
    void
    update_active_set();

    /// Whether the set just reached has been there too often.
    bool
    set_cycles();

    /// Projects u onto the admissible set and hands over to the feasible
    /// method.
    void
    become_feasible();

    bool
    has_converged() const;

    /// The primal-dual active set and Newton step.
    void
    newton_step();

    /// The step of the feasible method.
    void
    feasible_step();

    /// Computes the Newton increment with the held unknowns moved to where
    /// they are held: lift + correction on the free ones.
    void
    compute_increment();

    /// Backtracking from @p base along @p direction, where the energy has the
    /// derivative @p slope < 0: finds a fraction with a sufficient decrease
    /// and sets u accordingly. Zero, and u = base, if there is none.
    double
    line_search(const Vector &base,
                const Vector &direction,
                const double  slope);

    /// Whether u is as good as it can be told in the presence of rounding:
    /// the energy has not grown visibly and its slope along @p direction has
    /// shrunk @cite hager_zhang_2005.
    bool
    slope_has_shrunk(const Vector &direction, const double slope);

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

    Vector previous_u, residual, free_residual, lift, increment, trial, work;

    double force_norm             = 0;
    double free_norm              = 0;
    double previous_free_norm     = 0;
    double current_energy         = 0;
    bool   feasible               = false;
    bool   stuck                  = false;
    bool   held_unknowns_at_place = false;

    std::map<std::uint64_t, unsigned int> visited_sets;

    NewtonStep step;
  };



  SemismoothNewton::Iteration::Iteration(ConstrainedMinimization &problem,
                                         Vector                  &u,
                                         const NewtonParameters  &parameters)
    : problem(problem)
    , u(u)
    , parameters(parameters)
    , step{0, 0, 0., 0., 0, 0., true, false}
  {
    for (Vector *vector : {&previous_u,
                           &residual,
                           &free_residual,
                           &lift,
                           &increment,
                           &trial,
                           &work})
      problem.initialize_vector(*vector);
  }



  void
  SemismoothNewton::Iteration::evaluate()
  {
    problem.compute_residual(residual, u);
    current_energy = problem.energy(u);
  }



  bool
  SemismoothNewton::Iteration::set_cycles()
  {
    return step.active_set_changed &&
           ++visited_sets[problem.active_set_fingerprint()] >
             tolerated_recurrences;
  }



  void
  SemismoothNewton::Iteration::become_feasible()
  {
    feasible = true;
    problem.move_held(u);
    problem.project(u);
    evaluate();
    problem.update_feasible_active_set(u, residual);
  }



  void
  SemismoothNewton::Iteration::update_active_set()
  {
    // The set of the starting point is the caller's guess.
    if (step.iteration > 0)
      {
        step.active_set_changed =
          feasible ? problem.update_feasible_active_set(u, residual) :
                     problem.update_active_set(u, residual);
        if (!feasible && (stuck || set_cycles()))
          become_feasible();
      }

    lift = u;
    problem.move_held(lift);
    lift -= u;
    held_unknowns_at_place =
      lift.linfty_norm() <= 1e-12 * std::max(u.linfty_norm(), 1e-300);

    free_residual = residual;
    problem.zero_held(free_residual);
    previous_free_norm = free_norm;
    free_norm          = free_residual.l2_norm();
    force_norm         = residual.l2_norm();
    if (!std::isfinite(force_norm))
      throw ConvergenceError(
        "The forces are no longer finite numbers. Are the moduli in "
        "'Material', 'Loading/Depth' and the values in 'Boundary conditions' "
        "right, and all in the same system of units?");

    step.n_active = problem.n_active();
    step.energy   = current_energy;
    step.residual = (force_norm > 0 ? free_norm / force_norm : 0.);
    step.feasible = feasible;
  }



  // Whether the set has just changed does not matter: if it has, and u fits
  // the new set as well as the old one (a node that touches without force),
  // the solution has been found.
  bool
  SemismoothNewton::Iteration::has_converged() const
  {
    return step.iteration > 0 && held_unknowns_at_place &&
           free_norm <= parameters.tolerance * force_norm;
  }



  double
  SemismoothNewton::Iteration::linear_reduction() const
  {
    const double useful =
      0.1 * parameters.tolerance * force_norm / std::max(free_norm, 1e-300);
    const double ratio =
      previous_free_norm > 0 ? free_norm / previous_free_norm : 1.;
    return std::clamp(0.9 * ratio * ratio,
                      std::clamp(useful, 1e-12, loosest_linear_reduction),
                      loosest_linear_reduction);
  }



  void
  SemismoothNewton::Iteration::compute_increment()
  {
    problem.linearize(u);
    // right hand side of the free unknowns: residual - tangent * lift
    work = residual;
    if (!held_unknowns_at_place)
      {
        problem.apply_tangent(trial, lift);
        work -= trial;
      }
    problem.zero_held(work);
    step.linear_iterations =
      problem.solve_tangent(increment, work, linear_reduction());
  }



  // If the affine set has changed, the line search starts on the new one, at
  // the point that differs from u only in the held unknowns; if it finds
  // nothing better, that point is the next iterate, from which the Newton step
  // is a direction of descent.
  void
  SemismoothNewton::Iteration::newton_step()
  {
    compute_increment();
    if (!held_unknowns_at_place)
      {
        u += lift;
        evaluate();
      }
    const double slope = -(residual * increment);
    work               = u;
    step.step_length   = slope < 0 ? line_search(work, increment, slope) : 0.;
    stuck              = (step.step_length == 0. && held_unknowns_at_place);
  }



  double
  SemismoothNewton::Iteration::line_search(const Vector &base,
                                           const Vector &direction,
                                           const double  slope)
  {
    const double start_energy = current_energy;
    for (double fraction = 1.; fraction > smallest_step_length; fraction *= 0.5)
      {
        u = base;
        u.add(fraction, direction);
        current_energy = problem.energy(u);
        if (current_energy <= start_energy + 1e-4 * fraction * slope ||
            (current_energy <=
               start_energy + energy_noise * std::abs(start_energy) &&
             slope_has_shrunk(direction, slope)))
          {
            problem.compute_residual(residual, u);
            return fraction;
          }
      }
    u = base;
    evaluate();
    return 0.;
  }



  bool
  SemismoothNewton::Iteration::slope_has_shrunk(const Vector &direction,
                                                const double  slope)
  {
    problem.compute_residual(residual, u);
    return std::abs(residual * direction) <= 0.9 * std::abs(slope);
  }



  void
  SemismoothNewton::Iteration::smooth()
  {
    problem.linearize(u);
    problem.tangent_diagonal(work);
    for (unsigned int sweep = 0; sweep < n_smoothing_sweeps; ++sweep)
      {
        free_residual = residual;
        problem.zero_held(free_residual);
        for (unsigned int i = 0; i < work.locally_owned_size(); ++i)
          free_residual.local_element(i) /= work.local_element(i);

        for (double damping = 0.5; damping > smallest_step_length;
             damping *= 0.5)
          {
            trial = u;
            trial.add(damping, free_residual);
            problem.project(trial);
            if (problem.energy(trial) <= current_energy)
              {
                u = trial;
                break;
              }
          }
        evaluate();
        problem.update_feasible_active_set(u, residual);
      }
  }



  void
  SemismoothNewton::Iteration::feasible_step()
  {
    smooth();
    problem.linearize(u);
    work = residual;
    problem.zero_held(work);
    step.linear_iterations =
      problem.solve_tangent(increment, work, linear_reduction());

    work = u;
    for (step.step_length = 1.; step.step_length > smallest_step_length;
         step.step_length *= 0.5)
      {
        u = work;
        u.add(step.step_length, increment);
        problem.project(u);
        if (problem.energy(u) <=
            current_energy + energy_noise * std::abs(current_energy))
          {
            evaluate();
            return;
          }
      }
    u                = work;
    step.step_length = 0.;
  }



  SemismoothNewton::SemismoothNewton(
    const NewtonParameters                        &parameters,
    const std::function<void(const NewtonStep &)> &show_progress)
    : parameters(parameters)
    , show_progress(show_progress)
  {}



  NewtonReport
  SemismoothNewton::solve(ConstrainedMinimization &problem, Vector &u) const
  {
    NewtonReport report;
    Iteration    iteration(problem, u, parameters);
    NewtonStep  &step = iteration.step;

    iteration.evaluate();
    while (true)
      {
        iteration.update_active_set();
        report.steps.push_back(step);
        show_progress(step);
        if (iteration.has_converged())
          return report;
        if (step.iteration == parameters.maximum_iterations)
          break;

        ++step.iteration;
        iteration.previous_u = u;
        if (step.feasible)
          iteration.feasible_step();
        else
          iteration.newton_step();
        problem.step_taken(iteration.previous_u, u);
      }

    std::ostringstream message;
    message << "The nonlinear solver has not converged in "
            << parameters.maximum_iterations
            << " iterations ('Nonlinear solver/Maximum number of "
               "iterations'): the forces on the free unknowns are still "
            << step.residual << " of all forces, 'Nonlinear solver/Tolerance' "
            << "is " << parameters.tolerance << ", " << step.n_active
            << " nodes are in contact"
            << (step.feasible ? ", and the feasible method that took over when "
                                "the active set cycled has not helped" :
                                "")
            << ". A finer mesh at the contact, a little hardening or a "
               "smaller depth usually helps.";
    throw ConvergenceError(message.str());
  }
} // namespace ElastoPlastic
