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
    problem.initialize_vector(residual);
  }



  bool
  NewtonIteration::set_cycles()
  {
    return step.active_set_changed &&
           ++visited_sets[problem.active_set_fingerprint()] >
             tolerated_recurrences;
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
    step.feasible = true;
    problem.move_constrained(u);
    problem.project(u);
    evaluate();
    problem.update_feasible_active_set(u, residual);
  }



  void
  NewtonIteration::update_active_set()
  {
    if (step.iteration == 0)
      return;
    step.active_set_changed =
      step.feasible ? problem.update_feasible_active_set(u, residual) :
                      problem.update_active_set(u, residual);
    if (step.feasible || !((stuck && !is_rounding()) || set_cycles()))
      return;
    if (problem.slow_down())
      visited_sets.clear();
    else
      become_feasible();
  }



  NewtonIteration::Vector
  NewtonIteration::way_to_places() const
  {
    Vector way = u;
    problem.move_constrained(way);
    way -= u;
    return way;
  }



  void
  NewtonIteration::measure_forces()
  {
    constrained_unknowns_at_place = way_to_places().linfty_norm() <=
                                    1e-12 * std::max(u.linfty_norm(), 1e-300);

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
  NewtonIteration::is_rounding() const
  {
    const bool is_small = free_norm <= largest_rounding * force_norm;
    if (!is_small && step.n_active > 0)
      return false;
    Vector         rounded = u;
    RelativeErrors error;
    for (double &number : rounded)
      number *= 1. + error();
    Vector change(residual);
    problem.compute_residual(change, rounded);
    problem.reduce(change);
    change -= free_forces();
    const double rounding =
      (problem.is_convex() ? rounding_factor : nonlinear_rounding_factor) *
      std::ldexp(change.l2_norm(), -n_lost_bits);
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
  NewtonIteration::take_step()
  {
    const Vector from = u;
    ++step.iteration;
    if (step.feasible)
      feasible_step();
    else
      primal_dual_step();
    problem.step_taken(from, u);
  }



  NewtonIteration::Vector
  NewtonIteration::newton_increment(Vector forces)
  {
    Vector increment;
    problem.initialize_vector(increment);
    problem.reduce(forces);
    step.linear_iterations =
      problem.solve_tangent(increment, forces, linear_reduction());
    return increment;
  }



  // If constrained unknowns are not at their places, the increment begins where
  // they are and nothing else has moved, with the forces there to first order;
  // there begins the line search, too. If it finds nothing better, that point
  // is the next iterate, from which the Newton step is a direction of descent.
  void
  NewtonIteration::primal_dual_step()
  {
    problem.linearize(u);
    Vector forces = residual;
    if (!constrained_unknowns_at_place)
      {
        const Vector way = way_to_places();
        Vector       change;
        problem.initialize_vector(change);
        problem.apply_tangent(change, way);
        forces -= change;
        u += way;
      }
    const Vector increment = newton_increment(forces);
    if (!constrained_unknowns_at_place)
      evaluate();

    if (!is_possible())
      step.step_length = full_step(increment);
    else if (problem.has_energy())
      {
        const double slope = problem.slope_along(residual, increment);
        step.step_length   = slope < 0 ? line_search(increment, slope) : 0.;
      }
    else
      step.step_length = residual_line_search(increment);
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
    const Vector increment = newton_increment(residual);
    const Vector base      = u;
    for (step.step_length = 1.; step.step_length > smallest_step_length;
         step.step_length *= 0.5)
      {
        u = base;
        u.add(step.step_length, increment);
        problem.project(u);
        if (has_not_grown(problem.energy(u), current_energy))
          {
            evaluate();
            return;
          }
      }
    u                = base;
    step.step_length = 0.;
  }
} // namespace ElastoPlastic
