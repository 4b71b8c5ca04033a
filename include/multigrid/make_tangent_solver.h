// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef multigrid_make_tangent_solver_h
#define multigrid_make_tangent_solver_h

#include <functional>
#include <memory>
#include <string>

#include "loads/loaded_body.h"
#include "mechanics/solid_operator.h"
#include "solver/solver_parameters.h"
#include "solver/tangent_solver.h"

namespace ElastoPlastic
{
  /// The solver that @p parameters ask for, for the tangent of @p solid on one
  /// mesh. @p warn is told when the solver falls back to another. The body, its
  /// tangent, its unknowns and their constraints must outlive the solver.
  template <int dim>
  std::unique_ptr<TangentSolver>
  make_tangent_solver(const LinearSolverParameters    &parameters,
                      const LoadedBody<dim>           &body,
                      const SolidOperator<dim>        &solid,
                      const DoFHandler<dim>           &dof_handler,
                      const AffineConstraints<double> &constraints,
                      const std::function<void(const std::string &)> &warn);
} // namespace ElastoPlastic

#endif
