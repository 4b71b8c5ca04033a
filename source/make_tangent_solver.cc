// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "make_tangent_solver.h"
#include "multigrid/multigrid_solver.h"
#include "solver/assembled_solver.h"

namespace ElastoPlastic
{
  template <int dim>
  std::unique_ptr<TangentSolver<dim>>
  make_tangent_solver(const LinearSolverParameters    &parameters,
                      const DoFHandler<dim>           &dof_handler,
                      const AffineConstraints<double> &constraints,
                      const BoundaryConditions<dim>   &boundary_conditions,
                      const VolumetricTreatment        treatment,
                      const std::vector<VectorType>   &near_null_space)
  {
    if (parameters.type == "multigrid")
      return std::make_unique<MultigridSolver<dim>>(
        parameters, dof_handler, constraints, boundary_conditions, treatment);
    return std::make_unique<AssembledSolver<dim>>(
      make_linear_solver(parameters, near_null_space),
      dof_handler,
      constraints);
  }



  template std::unique_ptr<TangentSolver<2>>
  make_tangent_solver(const LinearSolverParameters &,
                      const DoFHandler<2> &,
                      const AffineConstraints<double> &,
                      const BoundaryConditions<2> &,
                      const VolumetricTreatment,
                      const std::vector<VectorType> &);
  template std::unique_ptr<TangentSolver<3>>
  make_tangent_solver(const LinearSolverParameters &,
                      const DoFHandler<3> &,
                      const AffineConstraints<double> &,
                      const BoundaryConditions<3> &,
                      const VolumetricTreatment,
                      const std::vector<VectorType> &);
} // namespace ElastoPlastic
