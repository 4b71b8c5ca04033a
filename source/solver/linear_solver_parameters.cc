// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "base/exceptions.h"
#include "solver/linear_solver_parameters.h"
#include "solver/system_matrix.h"

namespace ElastoPlastic
{
  void
  LinearSolverParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Linear solver");
    prm.add_parameter(
      "Type",
      type,
      "What preconditions the conjugate gradients (GMRES if back stresses "
      "recover). multigrid: geometric multigrid, without a matrix; for nearly "
      "incompressible bodies (Poisson's ratio above 0.452) GMRES with "
      "pressures beside the displacements. AMG: algebraic multigrid for an "
      "assembled matrix, which knows the rigid body motions. direct: a sparse "
      "factorisation of the matrix, for small problems and plane ones that are "
      "hard, such as collapse. Where multigrid does not converge in the "
      "iterations that are worth while, a factorisation takes over (in two "
      "dimensions, up to a million unknowns), or AMG.");
    prm.add_parameter("Maximum number of iterations",
                      maximum_iterations,
                      "The steps allowed per linear system. "
                      "When they are used up, Newton's method goes on with "
                      "what has been found.",
                      Patterns::Integer(1));
    prm.leave_subsection();
  }



  void
  LinearSolverParameters::check() const
  {
    if (type == Preconditioner::amg && !has_algebraic_multigrid)
      throw InputError("Linear solver/Type",
                       "AMG",
                       "this program has been built without Trilinos' ML, "
                       "which is that. Choose 'multigrid' "
                       "or 'direct'.");
  }
} // namespace ElastoPlastic
