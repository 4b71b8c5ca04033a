// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "base/exceptions.h"
#include "solver/solver_parameters.h"
#include "solver/system_matrix.h"

namespace ElastoPlastic
{
  void
  NewtonParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Nonlinear solver");
    prm.add_parameter(
      "Tolerance",
      tolerance,
      "The iteration ends when the active set no longer changes and the norm "
      "of the forces on the free unknowns has fallen below this fraction of "
      "the norm of all nodal forces (those of contact, supports and tractions), "
      "or, where a load history passes through zero load, of the norm that "
      "follows from the largest ones so far. Between 1e-14 and 1e-2. No unit.",
      Patterns::Double());
    prm.add_parameter("Maximum number of iterations",
                      maximum_iterations,
                      "The semi-smooth Newton steps allowed in one nonlinear "
                      "solve. When they are used up, the program ends with a "
                      "report and exit status 3.",
                      Patterns::Integer(1));
    prm.add_parameter(
      "Loosest linear reduction",
      loosest_linear_reduction,
      "Newton's method chooses how accurately each linear system is solved; at "
      "least its residual falls by this factor (for nearly incompressible "
      "bodies, by 1e-4). A small number, such as 1e-8, makes all solves "
      "accurate, to compare linear solvers. Between 1e-12 and 0.5. No unit.",
      Patterns::Double());
    prm.leave_subsection();
  }



  void
  NewtonParameters::check() const
  {
    if (!(tolerance >= 1e-14 && tolerance <= 1e-2))
      throw InputError("Nonlinear solver/Tolerance",
                       tolerance,
                       "it must lie between 1e-14 and 1e-2.");
    if (!(loosest_linear_reduction >= 1e-12 && loosest_linear_reduction <= 0.5))
      throw InputError("Nonlinear solver/Loosest linear reduction",
                       loosest_linear_reduction,
                       "it must lie between 1e-12 and 0.5.");
  }



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
