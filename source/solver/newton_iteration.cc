// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "base/exceptions.h"
#include "solver/newton_iteration.h"

namespace ElastoPlastic
{
  namespace
  {
    /// So often may an active set come back before we call it a cycle.
    constexpr unsigned int tolerated_recurrences = 3;
    constexpr unsigned int n_smoothing_sweeps    = 3;
    /// Forces on the free unknowns that exceed this fraction of all forces are
    /// not negligible, rounding or not, unless all forces are rounding.
    constexpr double largest_rounding = 1e-5;
    /// So much larger the forces on the supports may be then.
    constexpr double rounding_of_supports = 10;
    /// What the forces change by if so many bits of the displacements are lost
    /// tells what one bit is worth, up to a factor. (What is computed of the
    /// displacements is rounded as well: finite strains, through stretches of
    /// the deformation.)
    constexpr int    n_lost_bits               = 12;
    constexpr double rounding_factor           = 8.;
    constexpr double nonlinear_rounding_factor = 32.;
    /// Smaller forces have squares that underflow.
    constexpr double smallest_forces = 1e-130;
    /// Under a larger displacement, they are what rounding leaves of a rigid
    /// body motion.
    constexpr double smallest_motion = 1e-100;



    /// A generator of errors of up to half of the last of the bits that are
    /// kept, relative to a number. They differ from number to number: errors
    /// that are all alike would move a body as a whole, without forces.
    class RelativeErrors
    {
    public:
      double
      operator()()
      {
        return std::ldexp(uniform(generator),
                          n_lost_bits - std::numeric_limits<double>::digits);
      }

    private:
      std::minstd_rand                       generator;
      std::uniform_real_distribution<double> uniform{-1., 1.};
    };
  } // namespace



  NewtonIteration::NewtonIteration(ConstrainedMinimization &problem,
                                   Vector                  &u,
                                   const NewtonParameters  &parameters)
    : problem(problem)
    , u(u)
    , parameters(parameters)
    , step{0, 0, 0., 0., 0, 0., true, false}
  {
    for (Vector *vector : {&previous_u, &residual, &increment, &work})
      problem.initialize_vector(*vector);
  }



  void
  NewtonIteration::evaluate()
  {
    current_energy = problem.compute_residual(residual, u);
  }



  bool
  NewtonIteration::set_cycles()
  {
    return step.active_set_changed &&
           ++visited_sets[problem.active_set_fingerprint()] >
             tolerated_recurrences;
  }



  void
  NewtonIteration::leave_cycle()
  {
    if (problem.slow_down())
      visited_sets.clear();
    else
      become_feasible();
  }



  void
  NewtonIteration::become_feasible()
  {
    if (const std::string obstacle = problem.obstacle_to_convexity();
        !obstacle.empty())
      throw ConvergenceError(
        "The nonlinear solver makes no progress after " +
        std::to_string(step.iteration) + " iterations, and with " + obstacle +
        " there is no convex energy by which another method could find the "
        "solution. Shorter load steps ('Loading/Number of steps') or a finer "
        "mesh at the contact help, if the loads are in the same system of "
        "units as the moduli in 'Material', and not beyond what the body can "
        "bear.");
    feasible = true;
    problem.move_constrained(u);
    problem.project(u);
    evaluate();
    problem.update_feasible_active_set(u, residual);
  }



  void
  NewtonIteration::update_active_set()
  {
    // The set of the starting point is the caller's guess.
    if (step.iteration > 0)
      {
        step.active_set_changed =
          feasible ? problem.update_feasible_active_set(u, residual) :
                     problem.update_active_set(u, residual);
        if (!feasible && ((stuck && !is_rounding()) || set_cycles()))
          leave_cycle();
      }

    increment = u;
    problem.move_constrained(increment);
    increment -= u;
    constrained_unknowns_at_place =
      increment.linfty_norm() <= 1e-12 * std::max(u.linfty_norm(), 1e-300);

    previous_free_norm = free_norm;
    free_norm          = free_forces().l2_norm();
    force_norm =
      std::max({residual.l2_norm(), free_norm, problem.force_scale()});
    if (!std::isfinite(force_norm))
      throw ConvergenceError(
        "The forces are no longer finite numbers. Are the moduli in "
        "'Material', 'Loading/Depth' and the values in 'Boundary conditions' "
        "right, and all in the same system of units?");
    if (force_norm < smallest_forces && u.linfty_norm() < smallest_motion &&
        std::max(residual.linfty_norm(), free_forces().linfty_norm()) > 0.)
      throw InputError(
        "The forces are so small that their squares vanish in double "
        "precision: all of them are below " +
        Patterns::Tools::to_string(smallest_forces) +
        ". Choose larger loads in 'Loading' and 'Boundary conditions', or a "
        "system of units in which moduli and displacements are larger "
        "numbers.");

    step.n_active = problem.n_active();
    step.energy   = current_energy.value;
    step.residual = (force_norm > 0 ? free_norm / force_norm : 0.);
    step.feasible = feasible;
  }



  NewtonIteration::Vector
  NewtonIteration::free_forces() const
  {
    Vector forces = residual;
    problem.reduce(forces);
    return forces;
  }



  // Whether the set has just changed does not matter: if it has, and u fits
  // the new set as well as the old one (a node that touches without force),
  // the solution has been found.
  bool
  NewtonIteration::has_converged()
  {
    if (step.iteration == 0 || !constrained_unknowns_at_place ||
        !problem.is_itself())
      return false;
    if (free_norm <= parameters.tolerance * force_norm)
      return true;
    if (free_norm <= 0.5 * previous_free_norm || !is_rounding())
      return false;
    if (free_norm > largest_rounding * force_norm)
      {
        residual      = 0.;
        step.residual = 0.;
      }
    return true;
  }



  // (Forces that have been reduced already must be subtracted: a given force on
  // the indenter is part of both.)
  bool
  NewtonIteration::is_rounding()
  {
    const bool is_small = free_norm <= largest_rounding * force_norm;
    if (!is_small && step.n_active > 0)
      return false;
    Vector         rounded = u;
    RelativeErrors error;
    for (double &number : rounded)
      number *= 1. + error();
    problem.compute_residual(work, rounded);
    problem.reduce(work);
    work -= free_forces();
    const double rounding =
      (problem.is_convex() ? rounding_factor : nonlinear_rounding_factor) *
      std::ldexp(work.l2_norm(), -n_lost_bits);
    const bool is_rigid_motion = force_norm <= rounding_of_supports * rounding;
    return free_norm <= rounding && (is_small || is_rigid_motion);
  }



  double
  NewtonIteration::linear_reduction() const
  {
    const double useful =
      0.1 * parameters.tolerance * force_norm / std::max(free_norm, 1e-300);
    const double ratio =
      previous_free_norm > 0 ? free_norm / previous_free_norm : 1.;
    const double loosest = parameters.loosest_linear_reduction;
    return std::clamp(0.9 * ratio * ratio,
                      std::clamp(useful, 1e-12, loosest),
                      loosest);
  }



  void
  NewtonIteration::compute_increment()
  {
    problem.linearize(u);
    // the forces at the new u, to first order
    work = residual;
    if (!constrained_unknowns_at_place)
      {
        Vector change;
        problem.initialize_vector(change);
        problem.apply_tangent(change, increment);
        work -= change;
        u += increment;
      }
    problem.reduce(work);
    step.linear_iterations =
      problem.solve_tangent(increment, work, linear_reduction());
  }



  // If the affine set has changed, the line search starts on the new one, at
  // the point that differs from u only in the constrained unknowns; if it finds
  // nothing better, that point is the next iterate, from which the Newton step
  // is a direction of descent.
  void
  NewtonIteration::newton_step()
  {
    compute_increment();
    if (!constrained_unknowns_at_place)
      evaluate();
    work = u;
    if (!is_possible())
      step.step_length = full_step(increment);
    else if (problem.has_energy())
      {
        const double slope = problem.slope_along(residual, increment);
        step.step_length = slope < 0 ? line_search(work, increment, slope) : 0.;
      }
    else
      step.step_length = residual_line_search(work, increment);
    stuck = (step.step_length == 0. && constrained_unknowns_at_place);
  }



  void
  NewtonIteration::smooth()
  {
    problem.linearize(u);
    for (unsigned int sweep = 0; sweep < n_smoothing_sweeps; ++sweep)
      {
        Vector correction = free_forces();
        problem.apply_inverse_diagonal(correction);

        Vector trial;
        for (double damping = 0.5; damping > smallest_step_length;
             damping *= 0.5)
          {
            trial = u;
            trial.add(damping, correction);
            problem.project(trial);
            if (problem.energy(trial).value <= current_energy.value)
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
  NewtonIteration::feasible_step()
  {
    smooth();
    problem.linearize(u);
    work = residual;
    problem.reduce(work);
    step.linear_iterations =
      problem.solve_tangent(increment, work, linear_reduction());

    work = u;
    for (step.step_length = 1.; step.step_length > smallest_step_length;
         step.step_length *= 0.5)
      {
        u = work;
        u.add(step.step_length, increment);
        problem.project(u);
        if (has_not_grown(problem.energy(u), current_energy))
          {
            evaluate();
            return;
          }
      }
    u                = work;
    step.step_length = 0.;
  }
} // namespace ElastoPlastic
