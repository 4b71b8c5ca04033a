// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>
#include <limits>

#include "base/exceptions.h"
#include "solver/newton_iteration.h"

// How far NewtonIteration goes.

namespace ElastoPlastic
{
  double
  NewtonIteration::full_step(const Vector &direction)
  {
    u += direction;
    problem.return_to_bounds(u);
    evaluate();
    if (!is_possible() && !problem.is_convex())
      throw ConvergenceError(
        "The load step turns elements inside out, or strains them beyond all "
        "bounds. Shorter load steps ('Loading/Number of steps') or a finer mesh "
        "at the contact help; under sharp tips, elements that have been "
        "squeezed too far do not recover.");
    return 1.;
  }



  double
  NewtonIteration::line_search(const Vector &direction, const double slope)
  {
    const Vector base  = u;
    const Energy start = current_energy;
    for (double fraction = 1.; fraction > smallest_step_length; fraction *= 0.5)
      {
        u = base;
        u.add(fraction, direction);
        problem.return_to_bounds(u);
        evaluate();
        if (current_energy.value <= start.value + 1e-4 * fraction * slope ||
            is_as_good(start, direction, slope))
          return fraction;
      }
    u = base;
    evaluate();
    return 0.;
  }



  // The linear system has been solved well enough for the norm to fall along
  // the direction. (What is below the tolerance may be rounding.)
  double
  NewtonIteration::residual_line_search(const Vector &direction)
  {
    const Vector base       = u;
    const double start_norm = free_forces().l2_norm();
    const double negligible = parameters.tolerance * force_norm;
    for (double fraction = 1.; fraction > smallest_step_length; fraction *= 0.5)
      {
        u = base;
        u.add(fraction, direction);
        problem.return_to_bounds(u);
        if (trial_norm() <=
            std::max((1. - 1e-4 * fraction) * start_norm, negligible))
          return fraction;
      }
    u = base;
    evaluate();
    return 0.;
  }



  double
  NewtonIteration::trial_norm()
  {
    try
      {
        evaluate();
        return free_forces().l2_norm();
      }
    catch (const ConvergenceError &)
      {
        return std::numeric_limits<double>::infinity();
      }
  }



  // (Of tiny steps, slopes are rounding themselves.)
  bool
  NewtonIteration::is_as_good(const Energy &start,
                              const Vector &direction,
                              const double  slope) const
  {
    return has_not_grown(current_energy, start) &&
           (std::abs(problem.slope_along(residual, direction)) <=
              0.9 * std::abs(slope) ||
            free_forces().l2_norm() <= 0.5 * free_norm);
  }
} // namespace ElastoPlastic
