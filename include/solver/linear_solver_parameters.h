// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef solver_linear_solver_parameters_h
#define solver_linear_solver_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace ElastoPlastic
{
  using namespace dealii;

  /// The entries of the section "Linear solver".
  struct LinearSolverParameters
  {
    std::string  type               = "multigrid";
    unsigned int maximum_iterations = 1000;

    void
    add_parameters(ParameterHandler &prm);
  };
} // namespace ElastoPlastic

#endif
