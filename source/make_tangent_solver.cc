// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "make_tangent_solver.h"
#include "mechanics/rigid_body_modes.h"
#include "multigrid/multigrid_preconditioner.h"
#include "solver/assembled_preconditioner.h"

namespace ElastoPlastic
{
  namespace
  {
    /// So many iterations tell that something is wrong.
    constexpr unsigned int patience_with_multigrid = 150;
  } // namespace



  template <int dim>
  std::unique_ptr<TangentSolver<dim>>
  make_tangent_solver(const LinearSolverParameters    &parameters,
                      const DoFHandler<dim>           &dof_handler,
                      const AffineConstraints<double> &constraints,
                      const BoundaryConditions<dim>   &boundary_conditions,
                      const StrainModel               &strain_model,
                      const VectorType                &layout,
                      const std::function<void(const std::string &)> &warn)
  {
    using Method           = typename TangentSolver<dim>::Method;
    const auto with_matrix = [&](const std::string &name,
                                 const std::string &type) -> Method {
      return {name,
              [type, layout, &dof_handler, &constraints]() {
                return std::make_unique<AssembledPreconditioner<dim>>(
                  make_matrix_preconditioner(
                    type, rigid_body_modes(dof_handler, layout)),
                  dof_handler,
                  constraints);
              },
              parameters.maximum_iterations};
    };
    const Method geometric = {
      "geometric multigrid",
      [strain_model, &dof_handler, &constraints, &boundary_conditions]() {
        return std::make_unique<MultigridPreconditioner<dim>>(
          dof_handler, constraints, boundary_conditions, strain_model);
      },
      std::min(parameters.maximum_iterations, patience_with_multigrid)};
    const Method algebraic = with_matrix("algebraic multigrid", "AMG");
    const Method direct    = with_matrix("a factorisation", "direct");

    std::vector<Method> methods;
    if (parameters.type == "multigrid")
      methods = {geometric, algebraic};
    else if (parameters.type == "AMG")
      methods = {algebraic};
    else
      methods = {direct};
    return std::make_unique<TangentSolver<dim>>(methods, warn);
  }



  template std::unique_ptr<TangentSolver<2>>
  make_tangent_solver(const LinearSolverParameters &,
                      const DoFHandler<2> &,
                      const AffineConstraints<double> &,
                      const BoundaryConditions<2> &,
                      const StrainModel &,
                      const VectorType &,
                      const std::function<void(const std::string &)> &);
  template std::unique_ptr<TangentSolver<3>>
  make_tangent_solver(const LinearSolverParameters &,
                      const DoFHandler<3> &,
                      const AffineConstraints<double> &,
                      const BoundaryConditions<3> &,
                      const StrainModel &,
                      const VectorType &,
                      const std::function<void(const std::string &)> &);
} // namespace ElastoPlastic
