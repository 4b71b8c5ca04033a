// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

#include "base/compatibility.h"
#include "mechanics/rigid_body_modes.h"
#include "multigrid/make_tangent_solver.h"
#include "multigrid/multigrid_preconditioner.h"

namespace ElastoPlastic
{
  namespace
  {
    /// In the plane, a factorisation takes no longer than so many iterations
    /// with geometric multigrid (90,000 unknowns, one rank), and 3.5 KB for
    /// each unknown.
    constexpr unsigned int            patience_in_plane     = 60;
    constexpr types::global_dof_index largest_factorization = 1000000;
    /// Algebraic multigrid would not need fewer.
    constexpr unsigned int patience_in_space = 150;
    /// Nor here, in a nearly incompressible body.
    constexpr unsigned int patience_with_mixed_form = 400;
  } // namespace



  template <int dim>
  std::unique_ptr<TangentSolver>
  make_tangent_solver(const LinearSolverParameters    &parameters,
                      const LoadedBody<dim>           &body,
                      const SolidOperator<dim>        &solid,
                      const DoFHandler<dim>           &dof_handler,
                      const AffineConstraints<double> &constraints,
                      const std::function<void(const std::string &)> &warn)
  {
    using Method = TangentSolver::Method;
    const auto with_matrix =
      [&](const std::string                                            &name,
          const std::function<std::unique_ptr<MatrixPreconditioner>()> &make)
      -> Method {
      return {name,
              [make, &solid, &dof_handler, &constraints]() {
                return std::make_unique<AssembledPreconditioner<dim>>(
                  solid, make(), dof_handler, constraints);
              },
              parameters.maximum_iterations};
    };
    const bool is_mixed = solid.is_nearly_incompressible();
    const bool can_factorize =
      dim == 2 && dof_handler.n_dofs() <= largest_factorization;
    const unsigned int patience = can_factorize ? patience_in_plane :
                                  is_mixed      ? patience_with_mixed_form :
                                                  patience_in_space;

    const Method geometric = {
      "geometric multigrid",
      [&body, &solid, &dof_handler, &constraints]() {
        return std::make_unique<MultigridPreconditioner<dim>>(body,
                                                              solid,
                                                              dof_handler,
                                                              constraints);
      },
      std::min(parameters.maximum_iterations, patience),
      is_mixed ? TangentForm::mixed : TangentForm::displacements};
    const Method algebraic =
      with_matrix("algebraic multigrid", [&solid, &dof_handler]() {
        VectorType layout;
        solid.initialize_vector(layout);
        return make_algebraic_multigrid(rigid_body_modes(dof_handler, layout));
      });
    const Method direct = with_matrix("a factorisation", [&dof_handler]() {
      return make_factorization(communicator_of(dof_handler));
    });

    std::vector<Method> methods;
    switch (parameters.type)
      {
        case Preconditioner::multigrid:
          methods = {geometric,
                     can_factorize || !has_algebraic_multigrid ? direct :
                                                                 algebraic};
          break;
        case Preconditioner::amg:
          methods = {algebraic};
          break;
        case Preconditioner::direct:
          methods = {direct};
          break;
      }
    return std::make_unique<TangentSolver>(solid, methods, warn);
  }



  template std::unique_ptr<TangentSolver>
  make_tangent_solver(const LinearSolverParameters &,
                      const LoadedBody<2> &,
                      const SolidOperator<2> &,
                      const DoFHandler<2> &,
                      const AffineConstraints<double> &,
                      const std::function<void(const std::string &)> &);
  template std::unique_ptr<TangentSolver>
  make_tangent_solver(const LinearSolverParameters &,
                      const LoadedBody<3> &,
                      const SolidOperator<3> &,
                      const DoFHandler<3> &,
                      const AffineConstraints<double> &,
                      const std::function<void(const std::string &)> &);
} // namespace ElastoPlastic
