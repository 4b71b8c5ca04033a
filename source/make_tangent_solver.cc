// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "make_tangent_solver.h"
#include "mechanics/rigid_body_modes.h"
#include "multigrid/multigrid_solver.h"
#include "solver/assembled_solver.h"
#include "solver/fallback_solver.h"

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
                      const VolumetricTreatment        treatment,
                      const VectorType                &layout,
                      const std::function<void(const std::string &)> &warn)
  {
    const auto make_assembled_solver = [parameters,
                                        layout,
                                        &dof_handler,
                                        &constraints](const std::string &type) {
      LinearSolverParameters assembled_parameters = parameters;
      assembled_parameters.type                   = type;
      return std::make_unique<AssembledSolver<dim>>(
        make_linear_solver(assembled_parameters,
                           rigid_body_modes(dof_handler, layout)),
        dof_handler,
        constraints);
    };

    if (parameters.type != "multigrid")
      return make_assembled_solver(parameters.type);

    LinearSolverParameters multigrid_parameters = parameters;
    multigrid_parameters.maximum_iterations =
      std::min(parameters.maximum_iterations, patience_with_multigrid);
    return std::make_unique<FallbackSolver<dim>>(
      std::make_unique<MultigridSolver<dim>>(multigrid_parameters,
                                             dof_handler,
                                             constraints,
                                             boundary_conditions,
                                             treatment),
      multigrid_parameters.maximum_iterations,
      [=]() { return make_assembled_solver("AMG"); },
      warn);
  }



  template std::unique_ptr<TangentSolver<2>>
  make_tangent_solver(const LinearSolverParameters &,
                      const DoFHandler<2> &,
                      const AffineConstraints<double> &,
                      const BoundaryConditions<2> &,
                      const VolumetricTreatment,
                      const VectorType &,
                      const std::function<void(const std::string &)> &);
  template std::unique_ptr<TangentSolver<3>>
  make_tangent_solver(const LinearSolverParameters &,
                      const DoFHandler<3> &,
                      const AffineConstraints<double> &,
                      const BoundaryConditions<3> &,
                      const VolumetricTreatment,
                      const VectorType &,
                      const std::function<void(const std::string &)> &);
} // namespace ElastoPlastic
