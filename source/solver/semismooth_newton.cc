// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <sstream>

#include "base/exceptions.h"
#include "solver/newton_iteration.h"

namespace ElastoPlastic
{
  unsigned int
  NewtonReport::n_linear_iterations() const
  {
    unsigned int sum = 0;
    for (const NewtonStep &step : steps)
      sum += step.linear_iterations;
    return sum;
  }



  NewtonReport
  SemismoothNewton::solve(ConstrainedMinimization &problem, Vector &u) const
  {
    NewtonReport      report;
    NewtonIteration   iteration(problem, u, parameters);
    const NewtonStep &step = iteration.protocol();

    iteration.evaluate();
    while (true)
      {
        iteration.update_active_set();
        iteration.measure_forces();
        const bool has_converged = iteration.has_converged();
        report.steps.push_back(step);
        show_progress(step);
        if (has_converged)
          {
            report.residual = iteration.forces();
            return report;
          }
        if (step.iteration == parameters.maximum_iterations)
          break;
        iteration.take_step();
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
